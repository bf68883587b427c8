import { pow } from '../math/exact.ts';

/**
 * Each particle's damping to the power of dt, kept from step to step: a power costs some 100 ns, and V8 allocates for its
 * result. Looked up by value, so that nothing needs to be told when a damping, or the particle in a slot, changes.
 */
export class DampingPowers {
  /** The damping that the power of a slot belongs to; NaN where there is none yet. */
  bases: Float64Array = new Float64Array(0);
  powers: Float64Array = new Float64Array(0);
  #dt = 0;

  /** Makes room, and forgets the powers of another dt. */
  prepare(capacity: number, dt: number): void {
    if (this.bases.length < capacity) {
      this.bases = new Float64Array(capacity);
      this.powers = new Float64Array(capacity);
    } else if (this.#dt === dt) {
      return;
    }
    this.#dt = dt;
    this.bases.fill(NaN);
  }

  /** Computes the power of a slot. */
  compute(slot: number, damping: Float64Array): void {
    this.bases[slot] = damping[slot];
    this.powers[slot] = pow(damping[slot], this.#dt);
  }
}
