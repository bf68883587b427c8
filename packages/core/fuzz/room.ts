import type { WallsPlan } from './plan.ts';

/** The inside of the walls. */
export interface Room {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** How far in front of the nearest wall a point is, negative outside. Unit: m. */
  distance(x: number, y: number): number;
}

/** The room that walls enclose. */
export function roomAround({ corners, thickness, kind }: WallsPlan): Room {
  const half = kind === 'segments' || kind === 'polyline' ? thickness / 2 : 0;
  const sides = corners.map((corner, k) => {
    const next = corners[(k + 1) % corners.length];
    const length = Math.hypot(next.x - corner.x, next.y - corner.y);
    return { corner, nx: (corner.y - next.y) / length, ny: (next.x - corner.x) / length };
  });
  const xs = corners.map(({ x }) => x);
  const ys = corners.map(({ y }) => y);
  return {
    minX: Math.min(...xs),
    minY: Math.min(...ys),
    maxX: Math.max(...xs),
    maxY: Math.max(...ys),
    distance: (x, y) =>
      Math.min(...sides.map(({ corner, nx, ny }) => (x - corner.x) * nx + (y - corner.y) * ny)) - half,
  };
}
