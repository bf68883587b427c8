import { requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';

/**
 * Uniform gravity near the ground, f = m·g: for particles that fall otherwise than the world's own gravity has it.
 * An infinite mass feels none.
 */
export class Gravity implements ForceGenerator {
  readonly steady = true;
  /** Acceleration, x to the right and y up. Unit: m/s². */
  readonly g: Readonly<Vec2>;

  constructor(g: Readonly<Vec2>) {
    requireVector('Gravity', 'g', g, 'metres per second squared');
    this.g = { x: g.x, y: g.y };
  }

  /** Reads mass, inverseMass. Adds to fx, fy. */
  apply({ mass, inverseMass, fx, fy }: ParticleArrays, { slots, count }: ForceTargets): void {
    const { x: gx, y: gy } = this.g;
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      if (inverseMass[i] === 0) continue;
      fx[i] += mass[i] * gx;
      fy[i] += mass[i] * gy;
    }
  }
}
