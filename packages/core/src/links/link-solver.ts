import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { Link } from './link.ts';

/** Keeps links of one kind together, within the small steps of the sub-step resolver. Each world has one of its own for each kind. */
export interface LinkSolver {
  /** The impulse that each link held in the step so far, in the order of `setLinks`: positive pulls the ends together. Unit: N·s. */
  readonly impulse: Float64Array;
  /** Says which links to keep; called before a step when any came or went. */
  setLinks(links: readonly Link[], particles: ParticleArrays): void;
  /** Begins a step. Reads what may change between steps: lengths, masses, who sleeps. Clears the impulses. */
  begin(particles: ParticleArrays): void;
  /**
   * Changes velocities so that the links have their lengths once the positions have moved on by `h`.
   * Reads x, y, vx, vy, inverseMass. Writes vx, vy, impulse.
   * @param h - Duration of the small step. Unit: s.
   */
  solve(particles: ParticleArrays, h: number): void;
}
