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
