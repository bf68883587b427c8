import type { PointSink } from './points.ts';

/** How far a polygon may be from the circle that it stands for. Unit: CSS px. */
const tolerance = 0.1;

/** How many sides stand for a circle. */
export function sidesOf(radius: number): number {
  return Math.max(8, Math.min(256, Math.ceil(Math.PI * Math.sqrt(Math.max(1, radius) / (2 * tolerance)))));
}

/** Adds the points of an arc, from one angle to another, both included. */
export function addArc(sink: PointSink, x: number, y: number, radius: number, from: number, to: number): void {
  const turn = to - from;
  const steps = Math.max(1, Math.ceil((sidesOf(radius) * Math.abs(turn)) / (2 * Math.PI)));
  for (let k = 0; k <= steps; k++) {
    const angle = from + (turn * k) / steps;
    sink.add(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  }
}

/** Adds the points of a circle. */
export function addCircle(sink: PointSink, x: number, y: number, radius: number): void {
  const sides = sidesOf(radius);
  for (let k = 0; k < sides; k++) {
    const angle = (2 * Math.PI * k) / sides;
    sink.add(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  }
}

/**
 * Adds the outline of a ring of points, moved outwards by a radius, round at the corners that stick out. The points are
 * x, y, x, y, ..., either way round; `grow` is the radius at each. With `inwards` it is moved inwards. A line there and back
 * is a ring too: it comes out thick, with round ends.
 */
export function addRounded(
  sink: PointSink,
  points: ArrayLike<number>,
  count: number,
  grow: ArrayLike<number>,
  inwards: boolean = false,
): void {
  const side = signedArea(points, count) < 0 !== inwards ? -1 : 1;
  for (let i = 0; i < count; i++) {
    const x = points[2 * i];
    const y = points[2 * i + 1];
    const before = 2 * ((i + count - 1) % count);
    const after = 2 * ((i + 1) % count);
    const from = Math.atan2(points[before] - x, y - points[before + 1]) + (side < 0 ? Math.PI : 0);
    const to = Math.atan2(x - points[after], points[after + 1] - y) + (side < 0 ? Math.PI : 0);
    const wrapped = Math.atan2(Math.sin(to - from), Math.cos(to - from)) * side;
    const turn = wrapped < 1e-9 - Math.PI ? Math.PI : wrapped; // back the same way is around the end
    if (turn > 1e-3 && grow[i] > 0.25) addArc(sink, x, y, grow[i], from, from + turn * side);
    else {
      // A corner that goes in, or that is sharp: where the two sides, moved outwards, meet.
      const half = turn / 2;
      const reach = grow[i] / Math.max(0.3, Math.cos(half));
      sink.add(x + reach * Math.cos(from + half * side), y + reach * Math.sin(from + half * side));
    }
  }
}

/** Twice the area within a ring of points, positive where it turns from x to y. */
export function signedArea(points: ArrayLike<number>, count: number): number {
  let area = 0;
  for (let i = 0, j = count - 1; i < count; j = i++) {
    area += points[2 * j] * points[2 * i + 1] - points[2 * i] * points[2 * j + 1];
  }
  return area;
}

/**
 * Cuts a convex ring of points by a half-plane: keeps where (x - px)·nx + (y - py)·ny is 0 or less. Returns how many points
 * were written to `out`.
 */
export function clipToHalfPlane(
  points: ArrayLike<number>,
  count: number,
  px: number,
  py: number,
  nx: number,
  ny: number,
  out: Float64Array,
): number {
  let kept = 0;
  for (let i = 0; i < count; i++) {
    const x0 = points[2 * i];
    const y0 = points[2 * i + 1];
    const next = 2 * ((i + 1) % count);
    const x1 = points[next];
    const y1 = points[next + 1];
    const d0 = (x0 - px) * nx + (y0 - py) * ny;
    const d1 = (x1 - px) * nx + (y1 - py) * ny;
    if (d0 <= 0) {
      out[2 * kept] = x0;
      out[2 * kept++ + 1] = y0;
    }
    if (d0 * d1 < 0) {
      const t = d0 / (d0 - d1);
      out[2 * kept] = x0 + (x1 - x0) * t;
      out[2 * kept++ + 1] = y0 + (y1 - y0) * t;
    }
  }
  return kept;
}
