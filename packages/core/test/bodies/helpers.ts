import { type Body, DistanceLink } from '@mass/core';

/** The greatest share by which a link of a body is off its length. */
export function worstStrain(body: Body): number {
  let worst = 0;
  for (const link of body.links) if (link instanceof DistanceLink) worst = Math.max(worst, Math.abs(link.strain));
  return worst;
}

/** Momentum, and angular momentum about the origin. */
export function momenta(body: Body): { x: number; y: number; angular: number } {
  const sum = { x: 0, y: 0, angular: 0 };
  for (const { mass, x, y, vx, vy } of body.particles) {
    sum.x += mass * vx;
    sum.y += mass * vy;
    sum.angular += mass * (x * vy - y * vx);
  }
  return sum;
}

/** An angle brought to within half a turn. */
export function wrapped(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
