import type { DrawList, Palette } from '@mass/core/view';
import type { CanvasContext } from './canvas-context.ts';

const fullTurn = 2 * Math.PI;
/** Discs in one path. Ten thousand in a single one take the browser's rasteriser twice as long as in twenty. */
const pathLength = 512;

/**
 * Draws the discs, a few paths a paint: opaque discs share them. Translucent ones have a path each, so that where two
 * overlap both are seen, as on any other renderer.
 */
export function drawDiscs(context: CanvasContext, list: DrawList, { paints }: Palette): void {
  const { starts } = list;
  for (let p = 0; p < paints.length; p++) {
    const first = starts[p];
    const end = starts[p + 1];
    const { fill, stroke, strokeWidth, alpha } = paints[p];
    if (first === end || alpha === 0) continue;
    context.globalAlpha = alpha;
    if (fill !== null) context.fillStyle = fill;
    if (stroke !== null) {
      context.strokeStyle = stroke;
      context.lineWidth = strokeWidth;
    }
    const inset = strokeWidth / 2;
    if (alpha < 1) paintDiscs(context, list, first, end, inset, fill !== null, stroke !== null, 1);
    else {
      if (fill !== null) paintDiscs(context, list, first, end, inset, true, false, pathLength);
      if (stroke !== null) paintDiscs(context, list, first, end, inset, false, true, pathLength);
    }
  }
}

/** The discs of one paint, `together` of them in each path. The middle of the outline is `inset` from the edge. */
function paintDiscs(
  context: CanvasContext,
  { order, x, y, radius }: DrawList,
  first: number,
  end: number,
  inset: number,
  fill: boolean,
  stroke: boolean,
  together: number,
): void {
  for (let k = first; k < end; ) {
    context.beginPath();
    for (const until = Math.min(end, k + together); k < until; k++) {
      const i = order[k];
      const r = radius[i] - inset;
      context.moveTo(x[i] + r, y[i]);
      context.arc(x[i], y[i], r, 0, fullTurn);
    }
    if (fill) context.fill();
    if (stroke) context.stroke();
  }
}
