import { requireNonNegative, requireOptions } from '../math/checks.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';

/** The two coefficients of drag. */
export interface DragOptions {
  /** Share that grows with the speed. Unit: N·s/m. @default 0 */
  k1?: number;
  /** Share that grows with the square of the speed. Unit: N·s²/m². @default 0 */
  k2?: number;
}

/**
 * Drag against the motion, f = -v̂·(k1·|v| + k2·|v|²). Written as -v·(k1 + k2·|v|) it needs no direction, so that a
 * particle at rest feels none. With k2 = 0 a falling particle ends at the speed m·g / k1, with k1 = 0 at √(m·g / k2).
 *
 * A step shorter than m / k1 slows a particle; in a longer one the force would throw it back: pick the damping then.
 */
export class Drag implements ForceGenerator {
  readonly steady = true;
  readonly k1: number;
  readonly k2: number;

  constructor(options: DragOptions) {
    requireOptions('Drag', 'options', options, '{ k1: 0.1 }');
    const { k1 = 0, k2 = 0 } = options;
    requireNonNegative('Drag', 'k1', k1, 'newton-seconds per metre');
    requireNonNegative('Drag', 'k2', k2, 'newton-seconds squared per square metre');
    this.k1 = k1;
    this.k2 = k2;
  }

  /** Reads vx, vy. Adds to fx, fy. */
  apply({ vx, vy, fx, fy }: ParticleArrays, { slots, count }: ForceTargets): void {
    const { k1, k2 } = this;
    if (k2 === 0) {
      for (let t = 0; t < count; t++) {
        const i = slots[t];
        fx[i] -= k1 * vx[i];
        fy[i] -= k1 * vy[i];
      }
      return;
    }
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      const speed = Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
      const k = k1 + k2 * speed;
      fx[i] -= k * vx[i];
      fy[i] -= k * vy[i];
    }
  }
}
