import type { ParticleArrays } from './particle-arrays.ts';

/** What a handle needs of the store behind it. */
export interface ParticleSlots extends ParticleArrays {
  /** Sets the time left to a particle. */
  setLifetime(slot: number, seconds: number): void;
  /** Wakes the particle in a slot, if it sleeps. */
  wake(slot: number): void;
  /** Frees a slot. */
  remove(slot: number): void;
}
