import type { DrawList, Palette } from '@mass/core/view';
import type { CanvasContext } from './canvas-context.ts';

const fullTurn = 2 * Math.PI;

/**
 * Draws the discs, one path a paint. Opaque discs share the path; translucent ones are filled one by one, so that
 * where two overlap both are seen, as on any other renderer.
 */
export function drawDiscs(context: CanvasContext, list: DrawList, { paints }: Palette): void {
  const { starts } = list;
  for (let p = 0; p < paints.length; p++) {
    const first = starts[p];
    const end = starts[p + 1];
    const { fill, stroke, strokeWidth, alpha } = paints[p];
    if (first === end || alpha === 0 || (fill === null && stroke === null)) continue;
    context.globalAlpha = alpha;
    if (fill !== null) context.fillStyle = fill;
    if (stroke !== null) {
      context.strokeStyle = stroke;
      context.lineWidth = strokeWidth;
    }
    const together = alpha === 1 && end - first > 1;
    if (together) drawTogether(context, list, first, end, strokeWidth / 2, fill !== null, stroke !== null);
    else drawApart(context, list, first, end, strokeWidth / 2, fill !== null, stroke !== null);
  }
}

function drawTogether(
  context: CanvasContext,
  { order, x, y, radius }: DrawList,
  first: number,
  end: number,
  inset: number,
  fill: boolean,
  stroke: boolean,
): void {
  context.beginPath();
  for (let k = first; k < end; k++) {
    const i = order[k];
    const r = radius[i] - inset;
    context.moveTo(x[i] + r, y[i]);
    context.arc(x[i], y[i], r, 0, fullTurn);
  }
  if (fill) context.fill();
  if (stroke) context.stroke();
}

function drawApart(
  context: CanvasContext,
  { order, x, y, radius }: DrawList,
  first: number,
  end: number,
  inset: number,
  fill: boolean,
  stroke: boolean,
): void {
  for (let k = first; k < end; k++) {
    const i = order[k];
    context.beginPath();
    context.arc(x[i], y[i], radius[i] - inset, 0, fullTurn);
    if (fill) context.fill();
    if (stroke) context.stroke();
  }
}
