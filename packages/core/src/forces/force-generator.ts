import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceTargets } from './force-targets.ts';

/**
 * A force on particles. A game's own is made the same way: implement `apply`, hand it to `World.addForce`. One generator
 * may serve any number of particles; it runs once a step, over all of them. For a force that is easier to say one particle
 * at a time, see `forEachParticle`.
 */
export interface ForceGenerator {
  /**
   * Whether a particle at rest gets the same force at any time, whatever other particles do, as from gravity or drag: particles on which
   * any other force acts do not fall asleep. @default false
   */
  readonly steady?: boolean;
  /**
   * Adds the force on each target to `particles.fx` and `particles.fy`, and writes nothing else of the world.
   * @param particles - Position, velocity, mass, ... of every particle.
   * @param targets - The particles it was added for.
   * @param dt - Duration of the step. Unit: s.
   * @param time - Time of the world at the start of the step. Unit: s.
   */
  apply(particles: ParticleArrays, targets: ForceTargets, dt: number, time: number): void;
}
