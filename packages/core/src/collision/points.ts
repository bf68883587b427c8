import { describe, requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';

/** Copies of the points of a shape, checked: finite, at least so many, and each apart from the next. */
export function checkedPoints(
  where: string,
  points: readonly Readonly<Vec2>[],
  least: number,
  closed: boolean,
): readonly Readonly<Vec2>[] {
  if (!Array.isArray(points)) {
    throw new TypeError(`${where}: points must be an array of { x, y }, in metres; got ${describe(points)}.`);
  }
  if (points.length < least) {
    throw new RangeError(`${where}: points must be at least ${least}; got ${points.length}.`);
  }
  for (let p = 0; p < points.length; p++) requireVector(where, `points[${p}]`, points[p], 'metres');
  for (let p = 0; p < points.length; p++) {
    const next = (p + 1) % points.length;
    if ((next === 0 && !closed) || !(points[p].x === points[next].x && points[p].y === points[next].y)) continue;
    throw new RangeError(
      `${where}: each point must be apart from the next; points ${p} and ${next} are both at (${points[p].x}, ${points[p].y}). ` +
        'Leave one out.',
    );
  }
  return Object.freeze(points.map(({ x, y }) => Object.freeze({ x, y })));
}
