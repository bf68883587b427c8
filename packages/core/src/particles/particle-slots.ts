import type { ParticleArrays } from './particle-arrays.ts';

/** What a handle needs of the store behind it. */
export interface ParticleSlots extends ParticleArrays {
  /** Grows each time a slot is freed, so that a handle knows whether it still means the slot's particle. */
  readonly generation: Uint32Array;
  /** Sets the time left to a particle. */
  setLifetime(slot: number, seconds: number): void;
  /** Frees a slot. */
  remove(slot: number): void;
}
