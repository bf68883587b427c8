import { type PathList, type PathPaint, pathKinds } from './path-list.ts';
import type { Points } from './points.ts';

const crossings = new Float64Array(512);

/**
 * Adds slanting lines over the inside of a ring of points, all in CSS px. They lie where x + y is a whole number of steps
 * past the origin of the world, at `left` and `top`, so that they go with the scenery when the camera moves; only what is in
 * the view is drawn.
 */
export function addHatching(
  list: PathList,
  { data: points, count }: Points,
  spacing: number,
  { left, top, width, height }: Readonly<Record<'left' | 'top' | 'width' | 'height', number>>,
  paint: PathPaint,
): void {
  const origin = left + top;
  let first = Infinity;
  let last = -Infinity;
  for (let i = 0; i < count; i++) {
    const sum = points[2 * i] + points[2 * i + 1];
    first = Math.min(first, sum);
    last = Math.max(last, sum);
  }
  const step = spacing * Math.SQRT2; // measured along an axis
  first = origin + Math.ceil((Math.max(0, first) - origin) / step) * step;
  last = Math.min(width + height, last);
  for (let sum = first; sum < last; sum += step) {
    const found = cross(points, count, sum);
    for (let k = 0; k + 1 < found; k += 2) {
      // At most as far as the view reaches.
      const from = Math.max(crossings[k], -1, sum - height - 1);
      const to = Math.min(crossings[k + 1], width + 1, sum + 1);
      if (to - from < 0.5) continue;
      list.add(from, sum - from);
      list.add(to, sum - to);
      list.end(pathKinds.line, paint);
    }
  }
}

/** Where the line x + y = sum crosses the sides, x from the left. */
function cross(points: ArrayLike<number>, count: number, sum: number): number {
  let found = 0;
  for (let i = 0, j = count - 1; i < count; j = i++) {
    const a = points[2 * j] + points[2 * j + 1] - sum;
    const b = points[2 * i] + points[2 * i + 1] - sum;
    if (a < 0 === b < 0 || found === crossings.length) continue;
    const x = points[2 * j] + ((points[2 * i] - points[2 * j]) * a) / (a - b);
    let k = found++;
    for (; k > 0 && crossings[k - 1] > x; k--) crossings[k] = crossings[k - 1];
    crossings[k] = x;
  }
  return found;
}
