import type { Ray } from './ray.ts';

/** Where a ray enters a disc, as a share of its way; undefined where it does not, or starts inside. */
export function discAlongRay(
  { x, y, dx, dy, length }: Ray,
  cx: number,
  cy: number,
  radius: number,
): number | undefined {
  const sx = x - cx;
  const sy = y - cy;
  const ux = dx / length;
  const uy = dy / length;
  const along = -(sx * ux + sy * uy);
  const offX = sx + ux * along;
  const offY = sy + uy * along;
  const half = radius * radius - (offX * offX + offY * offY); // squared half of the chord, without cancellation
  if (half < 0 || sx * sx + sy * sy < radius * radius) return undefined;
  const distance = along - Math.sqrt(half);
  return distance >= 0 && distance <= length ? distance / length : undefined;
}
