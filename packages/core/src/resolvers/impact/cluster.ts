import { SCENERY } from '../../contacts/contact-buffer.ts';
import type { Flight } from './flight.ts';
import type { Touches } from './touches.ts';

/** Touches at rest that hang together by particles that can move, and those particles. */
export class Cluster {
  touches: Int32Array = new Int32Array(64);
  touchCount = 0;
  slots: Int32Array = new Int32Array(64);
  slotCount = 0;
  /** Velocity and acceleration of each particle as they were noted. */
  #before = new Float64Array(64 * 4);
  #mark = 0;
  #slotMarks = new Int32Array(0);

  /** Forgets all. */
  clear(capacity: number): void {
    this.touchCount = 0;
    this.slotCount = 0;
    this.#mark++;
    if (this.#slotMarks.length !== capacity) this.#slotMarks = new Int32Array(capacity);
    if (this.slots.length >= capacity) return;
    this.slots = new Int32Array(capacity);
    this.#before = new Float64Array(capacity * 4);
  }

  /** Adds all touches at rest. Their particles are left out. */
  addAll(touches: Touches): void {
    this.#reserve(touches.count);
    for (let c = 0; c < touches.count; c++) if (touches.resting[c] === 1) this.touches[this.touchCount++] = c;
  }

  /** Adds a particle and all that hangs on it. */
  add(touches: Touches, inverseMass: Float64Array, slot: number): void {
    this.#reserve(touches.count);
    const from = this.slotCount;
    this.#addSlot(slot, inverseMass);
    for (let s = from; s < this.slotCount; s++) {
      const i = this.slots[s];
      for (let c = touches.firstOf(i); c >= 0; c = touches.nextOf(i, c)) {
        if (touches.resting[c] === 0 || touches.mark[c] === this.#mark) continue;
        touches.mark[c] = this.#mark;
        this.touches[this.touchCount++] = c;
        this.#addSlot(touches.a[c] === i ? touches.b[c] : touches.a[c], inverseMass);
      }
    }
  }

  /** Takes out the touches that rest no more. */
  dropReleased(touches: Touches): void {
    let kept = 0;
    for (let k = 0; k < this.touchCount; k++) {
      if (touches.resting[this.touches[k]] === 1) this.touches[kept++] = this.touches[k];
    }
    this.touchCount = kept;
  }

  /** Notes the velocities and accelerations. */
  note({ particles: { vx, vy }, ax, ay }: Flight): void {
    const before = this.#before;
    for (let s = 0; s < this.slotCount; s++) {
      const i = this.slots[s];
      before[s * 4] = vx[i];
      before[s * 4 + 1] = vy[i];
      before[s * 4 + 2] = ax[i];
      before[s * 4 + 3] = ay[i];
    }
  }

  /** Leaves those particles alone whose velocity or acceleration is not as it was noted. */
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

  #addSlot(slot: number, inverseMass: Float64Array): void {
    if (slot === SCENERY || inverseMass[slot] === 0 || this.#slotMarks[slot] === this.#mark) return;
    this.#slotMarks[slot] = this.#mark;
    this.slots[this.slotCount++] = slot;
  }

  #reserve(touchCount: number): void {
    if (this.touches.length < touchCount) this.touches = new Int32Array(touchCount * 2); // before the first is added
  }
}
