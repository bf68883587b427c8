import type { Shape } from '../collision/shape.ts';
import { SurfaceWalk } from '../collision/surface-walk.ts';
import { Sweep } from '../collision/sweep.ts';
import type { Ray } from './ray.ts';

/** Deeper than this a ray starts inside. Unit: m. */
const TOLERANCE = 1e-9;

/** Least step, as a share of the ray, towards a shape without `sweep`. What is thinner may be missed. */
const LEAST_STEP = 1e-5;

/** Where a ray enters a shape; undefined where it does not, or starts inside. */
export function shapeAlongRay(
  { x, y, dx, dy, length }: Ray,
  shape: Shape,
): { x: number; y: number; normalX: number; normalY: number; fraction: number } | undefined {
  if (startsInside(x, y, shape)) return undefined;
  const sweep = new Sweep();
  sweep.begin(x, y, dx, dy, 0);
  if (shape.sweep) shape.sweep(sweep);
  else new SurfaceWalk().meet(shape, sweep, Math.max(TOLERANCE, LEAST_STEP * length));
  const { time, normalX, normalY } = sweep;
  return time <= 1 ? { x: x + dx * time, y: y + dy * time, normalX, normalY, fraction: time } : undefined;
}

function startsInside(x: number, y: number, shape: Shape): boolean {
  const { minX, minY, maxX, maxY } = shape;
  let inside = false;
  const note = (distance: number) => {
    inside ||= distance < -TOLERANCE;
  };
  if (x >= minX && x <= maxX && y >= minY && y <= maxY) shape.findSurface(x, y, 0, { add: note });
  return inside;
}
