import { type PathList, pathKinds } from '@mass/core/view';
import type { CanvasContext } from './canvas-context.ts';

/** Points in one path, about: more of them take the browser's rasteriser longer than as many in two. */
const pathLength = 1024;

/** Draws lines and polygons in order. Lines that follow each other and look the same are stroked together. */
export function drawPaths(context: CanvasContext, { count, kinds, paints, starts, points }: PathList): void {
  context.lineCap = 'butt';
  context.lineJoin = 'round';
  for (let p = 0; p < count; ) {
    const paint = paints[p];
    const first = starts[p];
    context.globalAlpha = paint.alpha;
    context.beginPath();
    if (kinds[p] === pathKinds.fill || kinds[p] === pathKinds.strip) {
      context.fillStyle = paint.color;
      if (kinds[p] === pathKinds.fill) tracePolygon(context, points, first, starts[p + 1]);
      else traceStrip(context, points, first, starts[p + 1]);
      context.fill();
      p++;
      continue;
    }
    context.strokeStyle = paint.color;
    context.lineWidth = paint.width;
    do {
      tracePolygon(context, points, starts[p], starts[p + 1]);
      if (kinds[p] === pathKinds.ring) context.closePath();
      p++;
    } while (
      p < count &&
      paint.together &&
      paints[p] === paint &&
      kinds[p] >= pathKinds.line &&
      starts[p + 1] - first < 2 * pathLength
    );
    context.stroke();
  }
}

function tracePolygon(context: CanvasContext, points: Float64Array, first: number, end: number): void {
  context.moveTo(points[first], points[first + 1]);
  for (let k = first + 2; k < end; k += 2) context.lineTo(points[k], points[k + 1]);
}

/** There along every other point, and back along the rest. */
function traceStrip(context: CanvasContext, points: Float64Array, first: number, end: number): void {
  context.moveTo(points[first], points[first + 1]);
  for (let k = first + 4; k < end; k += 4) context.lineTo(points[k], points[k + 1]);
  for (let k = end - 2; k > first; k -= 4) context.lineTo(points[k], points[k + 1]);
}
