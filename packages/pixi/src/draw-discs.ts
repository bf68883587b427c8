import type { DrawList, Paint, Palette } from '@mass/core/view';
import { type Atlas, largestRing } from './atlas.ts';
import { drawRing } from './draw-ring.ts';
import type { QuadBatch } from './quad-batch.ts';

/** Adds the discs and their outlines; `pixelRatio` is the device pixels in a CSS px. */
export function drawDiscs(
  batch: QuadBatch,
  atlas: Atlas,
  list: DrawList,
  { paints }: Palette,
  pixelRatio: number,
): void {
  const { starts } = list;
  for (let p = 0; p < paints.length; p++) {
    const first = starts[p];
    const end = starts[p + 1];
    const paint = paints[p];
    if (first === end || paint.alpha === 0) continue;
    if (paint.alpha === 1 || paint.stroke === null || paint.fill === null) {
      if (paint.fill !== null) addFills(batch, atlas, list, paint, first, end, pixelRatio);
      if (paint.stroke !== null) addOutlines(batch, atlas, list, paint, first, end, pixelRatio);
      continue;
    }
    for (let k = first; k < end; k++) {
      addFills(batch, atlas, list, paint, k, k + 1, pixelRatio);
      addOutlines(batch, atlas, list, paint, k, k + 1, pixelRatio);
    }
  }
}

/** The fill ends under the middle of the outline, so that neither the ground nor the fill shows along its edges. */
function addFills(
  batch: QuadBatch,
  atlas: Atlas,
  { order, x, y, radius }: DrawList,
  { fillRgb, alpha, strokeWidth }: Paint,
  first: number,
  end: number,
  pixelRatio: number,
): void {
  for (let k = first; k < end; k++) {
    const i = order[k];
    const r = radius[i] - strokeWidth / 2;
    const { texture, size } = atlas.disc(r * pixelRatio);
    const scale = r / size;
    const soft = scale * pixelRatio > 1 ? 2 * scale : 0; // a disc larger than any in the atlas
    if (soft > 0 && alpha === 1) {
      const inner = (r - soft) / size;
      batch.add(texture, x[i], y[i], inner, inner, 0, fillRgb, alpha);
      drawRing(batch, atlas, x[i], y[i], r, 3 * soft, fillRgb, alpha, pixelRatio);
    } else batch.add(texture, x[i], y[i], scale, scale, 0, fillRgb, alpha);
  }
}

function addOutlines(
  batch: QuadBatch,
  atlas: Atlas,
  { order, x, y, radius }: DrawList,
  { strokeRgb, alpha, strokeWidth }: Paint,
  first: number,
  end: number,
  pixelRatio: number,
): void {
  for (let k = first; k < end; k++) {
    const i = order[k];
    if (radius[i] * pixelRatio > largestRing) {
      drawRing(batch, atlas, x[i], y[i], radius[i], strokeWidth, strokeRgb, alpha, pixelRatio);
      continue;
    }
    const { texture, size } = atlas.ring(radius[i] * pixelRatio, strokeWidth * pixelRatio);
    const scale = radius[i] / size;
    batch.add(texture, x[i], y[i], scale, scale, 0, strokeRgb, alpha);
  }
}
