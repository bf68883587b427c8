import type { ParticleArrays } from './particle-arrays.ts';

/** The low way to add particles by the thousand: slots instead of handles. Every world is one. */
export interface ParticleSpawner {
  readonly particles: ParticleArrays;
  /**
   * Adds a particle at rest, with the default of everything else, and returns its slot: write the rest to the arrays.
   * @param x - Position. Unit: m.
   * @param y - Position. Unit: m.
   * @param lifetime - Time until the world removes it. Unit: s. @default Infinity
   */
  spawn(x: number, y: number, lifetime?: number): number;
  /** Tells one particle of a slot from the next that lives there. */
  generationAt(slot: number): number;
}
