import type { ParticleArrays } from './particle-arrays.ts';

/** Whether every position and velocity is a finite number: if one is not, the sum is not. Reads x, y, vx, vy. */
export function allFinite({ count, x, y, vx, vy }: ParticleArrays): boolean {
  let sum = 0;
  for (let i = 0; i < count; i++) sum += x[i] + y[i] + (vx[i] + vy[i]);
  return sum - sum === 0;
}
