import type { ParticleArrays } from '../particles/particle-arrays.ts';

/**
 * Positions between the last two steps, for drawing: `alpha` 0 gives the previous, 1 the current ones. Writes one number
 * a slot, free slots included.
 */
export function interpolate(particles: ParticleArrays, alpha: number, outX: Float64Array, outY: Float64Array): void {
  const { count, x, y, previousX, previousY } = particles;
  for (let i = 0; i < count; i++) {
    outX[i] = previousX[i] + (x[i] - previousX[i]) * alpha;
    outY[i] = previousY[i] + (y[i] - previousY[i]) * alpha;
  }
}
