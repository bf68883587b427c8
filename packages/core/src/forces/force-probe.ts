import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';

/**
 * Adds no force, and remembers the sum of those that came before it: added last, the force on each of its particles in the
 * last step, for drawing and for measuring. `World.gravity` is an acceleration and not among them; `Gravity` is.
 *
 * @example
 * ```ts
 * const probe = world.addForce(new ForceProbe());
 * world.step(1 / 60);
 * probe.fy[crate.slot];
 * ```
 */
export class ForceProbe implements ForceGenerator {
  /** Force in the last step, by slot. Unit: N. */
  fx: Float64Array = new Float64Array(0);
  fy: Float64Array = new Float64Array(0);

  /** Reads fx, fy. Writes nothing of the world. */
  apply({ fx, fy }: ParticleArrays, { slots, count }: ForceTargets): void {
    if (this.fx.length < fx.length) {
      this.fx = new Float64Array(fx.length);
      this.fy = new Float64Array(fx.length);
    }
    const ownX = this.fx.fill(0);
    const ownY = this.fy.fill(0);
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      ownX[i] = fx[i];
      ownY[i] = fy[i];
    }
  }
}
