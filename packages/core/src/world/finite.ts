import type { ForceRegistry } from '../forces/force-registry.ts';
import { describe } from '../math/checks.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ParticleStore } from '../particles/particle-store.ts';

/** The error that names the first particle that is not finite. */
export function nonFiniteError({ count, x, y, vx, vy }: ParticleArrays): Error {
  for (let i = 0; i < count; i++) {
    if (Number.isFinite(x[i] + y[i] + vx[i] + vy[i])) continue;
    return new RangeError(
      `World.step: positions and velocities must stay finite; particle ${i} came to (${x[i]}, ${y[i]}) m ` +
        `at (${vx[i]}, ${vy[i]}) m/s. The step was undone: look at what was written to its numbers, at forces that are ` +
        'too strong for the step, or take shorter steps.',
    );
  }
  return new RangeError('World.step: positions and velocities must stay finite; they did not. The step was undone.');
}

/** The error that names the force generator whose force is not finite, if there is one. Runs the generators again. */
export function nonFiniteForceError(forces: ForceRegistry, dt: number, time: number): Error | undefined {
  const found = forces.findNonFinite(dt, time);
  if (found === undefined) return undefined;
  return new RangeError(
    `World.step: a force must be a finite number of newtons; ${describe(found.generator)}, force ${found.index + 1} of ` +
      `the world, gave (${found.fx}, ${found.fy}) to particle ${found.slot}. The step was undone: mend the generator, or take it out with ` +
      'world.removeForce.',
  );
}

/** Lifetimes are numbers: NaN, written to the array, would end a particle without a word. Reads lifetime. */
export function requireLifetimes({ count, lifetime, mortal }: ParticleStore): void {
  if (!mortal) return;
  let sum = 0;
  for (let i = 0; i < count; i++) sum += lifetime[i];
  if (!Number.isNaN(sum)) return;
  const slot = lifetime.findIndex((seconds, i) => i < count && Number.isNaN(seconds));
  throw new RangeError(`World.step: a lifetime must be a number of seconds; that of particle ${slot} is NaN.`);
}
