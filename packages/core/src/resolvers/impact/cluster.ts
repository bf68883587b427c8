import type { Flight } from './flight.ts';

/** Touches that hang together by particles that can move, and those particles. */
export class Cluster {
  touches: Int32Array = new Int32Array(64);
  touchCount = 0;
  slots: Int32Array = new Int32Array(64);
  slotCount = 0;
  /** Velocity and acceleration of each particle when it came in. */
  #before = new Float64Array(64 * 4);
  /** The last round in which each slot, each touch was marked. */
  #round = 0;
  #slotRounds = new Int32Array(64);
  #touchRounds = new Int32Array(64);

  /** Forgets all, and makes room. */
  clear(slotCount: number, touchCount: number): void {
    this.touchCount = 0;
    this.slotCount = 0;
    this.#round++;
    if (this.touches.length < touchCount) {
      this.touches = new Int32Array(touchCount * 2);
      this.#touchRounds = new Int32Array(touchCount * 2);
    }
    if (this.slots.length >= slotCount) return;
    this.slots = new Int32Array(slotCount);
    this.#before = new Float64Array(slotCount * 4);
    this.#slotRounds = new Int32Array(slotCount);
  }

  /** Marks a touch. Returns whether it was not marked yet. */
  mark(c: number): boolean {
    if (this.#touchRounds[c] === this.#round) return false;
    this.#touchRounds[c] = this.#round;
    return true;
  }

  addTouch(c: number): void {
    this.touches[this.touchCount++] = c;
  }

  /** Adds a particle, once. Reads vx, vy, ax, ay. */
  addSlot(i: number, { particles: { vx, vy }, ax, ay }: Flight): void {
    if (this.#slotRounds[i] === this.#round) return;
    this.#slotRounds[i] = this.#round;
    const before = this.#before;
    const s = this.slotCount++;
    this.slots[s] = i;
    before[s * 4] = vx[i];
    before[s * 4 + 1] = vy[i];
    before[s * 4 + 2] = ax[i];
    before[s * 4 + 3] = ay[i];
  }

  /** Keeps those particles alone whose velocity or acceleration is not what it was. */
  keepTurned({ particles: { vx, vy }, ax, ay }: Flight): void {
    const before = this.#before;
    let kept = 0;
    for (let s = 0; s < this.slotCount; s++) {
      const i = this.slots[s];
      const same = vx[i] === before[s * 4] && vy[i] === before[s * 4 + 1];
      if (same && ax[i] === before[s * 4 + 2] && ay[i] === before[s * 4 + 3]) continue;
      this.slots[kept++] = i;
    }
    this.slotCount = kept;
  }
}
