import type { Vec2 } from '../math/vec2.ts';

/** Up to so many corners each is joined to each: the stiffest there is. Beyond, the number of rods would run away. */
const ALL_PAIRS = 8;

/** A triangle lower than this share of its longest side counts as a line. */
const FLAT = 1e-6;

/**
 * Which corners rods join so that the body is rigid. Up to eight corners: each with each. Beyond: the edges, and each corner
 * with three that span a wide triangle. Three distances to the corners of a triangle fix a point whatever the outline's form,
 * which a fan of triangles does not where corners lie on one line; and it takes some 4 rods a corner.
 */
export function braces(where: string, corners: readonly Readonly<Vec2>[]): [number, number][] {
  const count = corners.length;
  requireApart(where, corners);
  const wide = wideTriangle(where, corners);
  const pairs: [number, number][] = [];
  for (let a = 0; a < count; a++) {
    for (let b = a + 1; b < count; b++) {
      const isEdge = b === a + 1 || (a === 0 && b === count - 1);
      if (count <= ALL_PAIRS || isEdge || wide.includes(a) || wide.includes(b)) pairs.push([a, b]);
    }
  }
  return pairs;
}

function requireApart(where: string, corners: readonly Readonly<Vec2>[]): void {
  for (let a = 0; a < corners.length; a++) {
    for (let b = a + 1; b < corners.length; b++) {
      const distance = length(corners[a], corners[b]);
      if (distance > 0 && distance < Infinity) continue;
      throw new RangeError(
        `${where}: corners must be at different places; corners ${a} and ${b} are ${distance} m apart. ` +
          'The last corner is joined to the first: do not repeat it.',
      );
    }
  }
}

/** A corner, the one farthest from it, and the one farthest from the line through both. */
function wideTriangle(where: string, corners: readonly Readonly<Vec2>[]): readonly number[] {
  const a = farthest(corners, (p) => length(p, { x: 0, y: 0 })); // from the mean: so at the rim
  const b = farthest(corners, (p) => length(p, corners[a]));
  const base = length(corners[a], corners[b]);
  const ux = (corners[b].x - corners[a].x) / base;
  const uy = (corners[b].y - corners[a].y) / base;
  const height = (p: Readonly<Vec2>) => Math.abs((p.x - corners[a].x) * uy - (p.y - corners[a].y) * ux);
  const c = farthest(corners, height);
  if (!(height(corners[c]) > FLAT * base)) {
    throw new RangeError(`${where}: corners must not lie on one line, or nothing keeps the body from folding.`);
  }
  return [a, b, c];
}

function farthest(corners: readonly Readonly<Vec2>[], distance: (corner: Readonly<Vec2>) => number): number {
  let best = 0;
  for (let i = 1; i < corners.length; i++) {
    if (distance(corners[i]) > distance(corners[best])) best = i;
  }
  return best;
}

function length(p: Readonly<Vec2>, q: Readonly<Vec2>): number {
  const dx = p.x - q.x;
  const dy = p.y - q.y;
  return Math.sqrt(dx * dx + dy * dy);
}
