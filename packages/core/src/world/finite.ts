import { describe } from '../math/checks.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import type { Simulation } from './simulation.ts';

/** Undoes a step that led to a number that is not finite, and makes the error that names the cause: a force, or a particle. */
export function nonFiniteError(simulation: Simulation, dt: number): Error {
  const where = describePlace(simulation.particles);
  simulation.before.restore(simulation.particles);
  return (
    nonFiniteForceError(simulation, dt) ??
    new RangeError(
      `World.step: positions and velocities must stay finite; ${where}. The step was undone: look at what was written to its ` +
        'numbers, at forces that are too strong for the step, or take shorter steps.',
    )
  );
}

/** Where the first particle that is not finite came to. */
function describePlace({ count, x, y, vx, vy }: ParticleArrays): string {
  for (let i = 0; i < count; i++) {
    if (Number.isFinite(x[i] + y[i] + vx[i] + vy[i])) continue;
    return `particle ${i} came to (${x[i]}, ${y[i]}) m at (${vx[i]}, ${vy[i]}) m/s`;
  }
  return 'their sum did not';
}

/** The error that names the first force generator whose force is not finite: each runs again, on its own. Writes fx, fy. */
function nonFiniteForceError({ forces, particles, time }: Simulation, dt: number): Error | undefined {
  for (const [index, generator] of forces.list.entries()) {
    particles.fx.fill(0);
    particles.fy.fill(0);
    forces.applyOne(generator, dt, time);
    const { count, fx, fy } = particles;
    for (let i = 0; i < count; i++) {
      if (Number.isFinite(fx[i] + fy[i])) continue;
      return new RangeError(
        `World.step: a force must be a finite number of newtons; ${describe(generator)}, force ${index + 1} of the world, ` +
          `gave (${fx[i]}, ${fy[i]}) to particle ${i}. The step was undone: mend the generator, or take it out with world.removeForce.`,
      );
    }
  }
  return undefined;
}

/** Lifetimes are numbers: NaN, written to the array, would end a particle without a word. Reads lifetime. */
export function requireLifetimes({ count, lifetime, mortal }: ParticleStore): void {
  if (!mortal) return;
  for (let i = 0; i < count; i++) {
    if (!Number.isNaN(lifetime[i])) continue;
    throw new RangeError(`World.step: a lifetime must be a number of seconds; that of particle ${i} is NaN.`);
  }
}
