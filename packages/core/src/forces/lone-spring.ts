import type { End } from '../particles/end.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import { Spring } from './spring.ts';
import { type SpringOptions, Springs } from './springs.ts';

/** A spring or bungee that is a force generator of its own: what `spring` and `bungee` make. */
export class LoneSpring extends Spring implements ForceGenerator, Iterable<Spring> {
  #batch: Springs | undefined;

  /** @internal */
  static make(where: string, batch: Springs, a: End, b: End, options: SpringOptions): LoneSpring {
    const made = batch.insert(where, a, b, options, LoneSpring);
    made.#batch = batch;
    return made;
  }

  /** Itself, while it is there: what draws the springs of a batch draws this one too. */
  *[Symbol.iterator](): Generator<Spring, void, undefined> {
    if (this.alive) yield this;
  }

  /** Reads x, y, vx, vy. Adds to fx, fy. */
  apply(particles: ParticleArrays): void {
    this.#batch?.apply(particles);
  }
}

/**
 * One spring between two particles, or a particle and a fixed point, to hand to `World.addForce`. Many are quicker as one
 * batch: see `Springs`, which also says how stiff a spring can be.
 *
 * @example
 * ```ts
 * world.addForce(spring({ x: 0, y: 4 }, bob, { stiffness: 20, restLength: 1 }));
 * ```
 */
export function spring(a: End, b: End, options: SpringOptions): LoneSpring {
  return LoneSpring.make('spring', new Springs(), a, b, options);
}

/** One bungee cord between two particles, or a particle and a fixed point: a spring that pulls and never pushes. */
export function bungee(a: End, b: End, options: SpringOptions): LoneSpring {
  return LoneSpring.make('bungee', new Springs('bungee'), a, b, options);
}
