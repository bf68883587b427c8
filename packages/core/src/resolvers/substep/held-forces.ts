import type { ParticleArrays } from '../../particles/particle-arrays.ts';

/** The forces that a game put into the accumulators between two steps: they act in each small step. */
export class HeldForces {
  #fx = new Float64Array(0);
  #fy = new Float64Array(0);
  #any = false;

  /** Reads fx, fy. */
  note({ count, fx, fy }: ParticleArrays): void {
    this.#any = false;
    for (let i = 0; i < count && !this.#any; i++) this.#any = fx[i] !== 0 || fy[i] !== 0;
    if (!this.#any) return;
    if (this.#fx.length !== fx.length) {
      this.#fx = new Float64Array(fx.length);
      this.#fy = new Float64Array(fx.length);
    }
    this.#fx.set(fx);
    this.#fy.set(fy);
  }

  /** Writes fx, fy. */
  restore({ fx, fy }: ParticleArrays): void {
    if (!this.#any) return;
    fx.set(this.#fx);
    fy.set(this.#fy);
  }
}
