import type { ContactGenerator } from '../contacts/contact-generator.ts';
import type { RigidMotion } from '../contacts/solver/rigid-motion.ts';
import type { End } from '../particles/end.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';

/**
 * Something that joins two ends by contacts. A game's own is made the same way: implement it, hand it to `World.addLink`.
 * It leaves the world with either of its particles, and the two do not collide.
 */
export interface Link extends ContactGenerator {
  readonly a: End;
  readonly b: End;
  /**
   * Makes what keeps links of this kind together in the sub-step resolver: links that name the same function share one solver.
   * A link without is kept by its contacts.
   */
  readonly solver?: () => LinkSolver;
  /** Whether its length was changed since this was last asked: then it may do work. */
  takeChange?(): boolean;
  /** What it has stored by giving way, with its ends at given places. Unit: J. */
  energyAt?(x: Float64Array, y: Float64Array): number;
  /**
   * Whether the link breaks now; asked after each step.
   * @param force - What its contacts had to hold during the step. Unit: N.
   */
  breaksAt?(force: number): boolean;
}

/** Keeps links of one kind together, within the small steps of the sub-step resolver. Each world has one of its own for each kind. */
export interface LinkSolver {
  /** The impulse that each link that can break held in the step so far, in the order of `setLinks`: positive pulls the ends together. Unit: N·s. */
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
  /** Rigid bodies that links make, if it knows any: contacts push these as a whole. */
  readonly bodies?: RigidMotion;
  /** Goes on with the velocities at the end of the small step, where `solve` left their mean, once positions have moved. Writes vx, vy. */
  finish?(particles: ParticleArrays): void;
  /** Brings links back to their lengths by position alone, after contacts have pushed their ends. Writes x, y. */
  straighten?(particles: ParticleArrays): void;
}
