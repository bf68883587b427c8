import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { Shape } from './shape.ts';

/** Whether two particles may touch: each has a bit of the other's category in its mask. */
export function mayTouch({ category, mask }: ParticleArrays, i: number, j: number): boolean {
  return (category[i] & mask[j]) !== 0 && (category[j] & mask[i]) !== 0;
}

/** Whether a particle may touch a shape: the same, and the shape's own filter lets it. */
export function mayTouchShape({ category, mask }: ParticleArrays, i: number, shape: Shape): boolean {
  const { category: kind = 1, mask: kinds = 0xffff, filter } = shape;
  return (category[i] & kinds) !== 0 && (kind & mask[i]) !== 0 && (filter === undefined || filter(i));
}

/** Whether two particles may push each other: they may touch, and neither is a sensor. */
export function mayPush(particles: ParticleArrays, i: number, j: number): boolean {
  return particles.sensor[i] + particles.sensor[j] === 0 && mayTouch(particles, i, j);
}

/** Whether a shape may push a particle: they may touch, and neither is a sensor. */
export function mayPushShape(particles: ParticleArrays, i: number, shape: Shape): boolean {
  return particles.sensor[i] === 0 && !shape.sensor && mayTouchShape(particles, i, shape);
}
