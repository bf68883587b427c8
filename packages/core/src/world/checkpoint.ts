import { growColumns } from '../math/columns.ts';
import type { ParticleStore } from '../particles/particle-store.ts';

/**
 * What a step may change, as it was before: a step that fails is undone from here, and of one that succeeds the old
 * positions become the previous ones, by an exchange of arrays instead of a second copy.
 */
export class Checkpoint {
  x: Float64Array = new Float64Array(0);
  y: Float64Array = new Float64Array(0);
  vx: Float64Array = new Float64Array(0);
  vy: Float64Array = new Float64Array(0);
  fx: Float64Array = new Float64Array(0);
  fy: Float64Array = new Float64Array(0);

  /** Reads x, y, vx, vy, fx, fy. Writes the copies. */
  save(store: ParticleStore): void {
    if (this.x.length !== store.capacity) growColumns(this, store.capacity);
    this.x.set(store.x);
    this.y.set(store.y);
    this.vx.set(store.vx);
    this.vy.set(store.vy);
    this.fx.set(store.fx);
    this.fy.set(store.fy);
  }

  /** Undoes a step that failed. Reads the copies. Writes x, y, vx, vy, fx, fy. */
  restore(store: ParticleStore): void {
    store.x.set(this.x);
    store.y.set(this.y);
    store.vx.set(this.vx);
    store.vy.set(this.vy);
    store.fx.set(this.fx);
    store.fy.set(this.fy);
  }

  /** Ends a step that succeeded. Exchanges previousX, previousY with the copies of x, y. */
  commit(store: ParticleStore): void {
    const { previousX, previousY } = store;
    store.previousX = this.x;
    store.previousY = this.y;
    this.x = previousX;
    this.y = previousY;
  }
}
