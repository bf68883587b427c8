import type { Vec2 } from '../math/vec2.ts';
import { Edges } from './edges.ts';

/** The area that points enclose: positive where they run counter-clockwise. Unit: m². */
export function signedArea(points: readonly Readonly<Vec2>[]): number {
  const [origin] = points; // seen from one of them, so that no digits are lost far from (0, 0)
  let doubled = 0;
  for (let p = 0; p < points.length; p++) doubled += turn(origin, points[p], points[(p + 1) % points.length]);
  return doubled / 2;
}

/** The first two edges, by the points they begin at, that meet other than at the corner which neighbours share. */
export function findCrossing(points: readonly Readonly<Vec2>[]): [number, number] | undefined {
  const { length } = points;
  const { tree } = new Edges(points, true);
  for (let e = 0; e < length; e++) {
    const e2 = (e + 1) % length;
    const { x, y } = points[e];
    const { x: x2, y: y2 } = points[e2];
    const near = tree.find(Math.min(x, x2), Math.min(y, y2), Math.max(x, x2), Math.max(y, y2));
    for (let n = 0; n < near; n++) {
      const f = tree.found[n];
      if (f <= e) continue;
      const f2 = (f + 1) % length;
      if (
        e2 === f ? foldsBack(points[e], points[f], points[f2]) : f2 === e && foldsBack(points[f], points[e], points[e2])
      ) {
        return [e, f];
      }
      if (e2 === f || f2 === e) continue;
      if (meet(points[e], points[e2], points[f], points[f2])) return [e, f];
    }
  }
  return undefined;
}

/** Positive where c lies to the left of the way from a to b; 0 on it. */
function turn(a: Readonly<Vec2>, b: Readonly<Vec2>, c: Readonly<Vec2>): number {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/** Whether the way from a to b turns straight back at b. */
function foldsBack(a: Readonly<Vec2>, b: Readonly<Vec2>, c: Readonly<Vec2>): boolean {
  return turn(a, b, c) === 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0;
}

/** Whether the segments ab and cd have a point in common. */
function meet(a: Readonly<Vec2>, b: Readonly<Vec2>, c: Readonly<Vec2>, d: Readonly<Vec2>): boolean {
  const abc = turn(a, b, c);
  const abd = turn(a, b, d);
  const cda = turn(c, d, a);
  const cdb = turn(c, d, b);
  if (abc > 0 !== abd > 0 && cda > 0 !== cdb > 0 && abc !== 0 && abd !== 0 && cda !== 0 && cdb !== 0) return true;
  return (
    (abc === 0 && liesWithin(c, a, b)) ||
    (abd === 0 && liesWithin(d, a, b)) ||
    (cda === 0 && liesWithin(a, c, d)) ||
    (cdb === 0 && liesWithin(b, c, d))
  );
}

/** Whether a point on the line through a and b lies between them. */
function liesWithin(p: Readonly<Vec2>, a: Readonly<Vec2>, b: Readonly<Vec2>): boolean {
  return (
    p.x >= Math.min(a.x, b.x) && p.x <= Math.max(a.x, b.x) && p.y >= Math.min(a.y, b.y) && p.y <= Math.max(a.y, b.y)
  );
}
