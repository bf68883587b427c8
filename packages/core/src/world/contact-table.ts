import type { ContactSource } from '../contacts/contact-sources.ts';
import { growColumns } from '../math/columns.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ContactEvent, EventQueue } from './events.ts';

/** Nothing stands in a place of the index. */
const EMPTY = -1;

/**
 * The contacts that go on, in the order in which they began: arrays, and an index of their slots, hashed with open addressing. One that
 * goes on costs no object.
 */
export class ContactTable {
  count = 0;
  /** The higher slot of the two and the lower, -1 for scenery, and the generations of the particles. */
  high: Int32Array = new Int32Array(64);
  low: Int32Array = new Int32Array(64);
  highGeneration: Uint32Array = new Uint32Array(64);
  lowGeneration: Uint32Array = new Uint32Array(64);
  /** The step in which each was found last. */
  step: Uint32Array = new Uint32Array(64);
  /** What was told as each began. */
  readonly events: ContactEvent[] = [];
  #index: Int32Array = new Int32Array(128).fill(EMPTY);

  /** The contact of two, or -1. Scenery is told apart by the source. */
  find(high: number, low: number, generation: Uint32Array, source: ContactSource): number {
    const index = this.#index;
    const mask = index.length - 1;
    for (let place = hash(high, low) & mask; index[place] !== EMPTY; place = (place + 1) & mask) {
      const t = index[place];
      if (this.high[t] !== high || this.low[t] !== low || !this.#lives(t, generation)) continue;
      if (low >= 0 || this.events[t].source === source) return t;
    }
    return -1;
  }

  add(high: number, low: number, generation: Uint32Array, step: number, event: ContactEvent): void {
    if (this.count === this.high.length) {
      growColumns(this, this.count * 2);
      this.#index = new Int32Array(this.count * 4);
      this.#fillIndex();
    }
    const t = this.count++;
    this.high[t] = high;
    this.low[t] = low;
    this.highGeneration[t] = generation[high];
    this.lowGeneration[t] = low < 0 ? 0 : generation[low];
    this.step[t] = step;
    this.events[t] = event;
    this.#note(t);
  }

  /** Has those go on of which one sleeps and the other does not move either. */
  keepSleeping({ asleep, inverseMass, generation }: ParticleArrays, step: number): void {
    for (let t = 0; t < this.count; t++) {
      const i = this.high[t];
      const j = this.low[t];
      if (asleep[i] !== 1 && !(j >= 0 && asleep[j] === 1)) continue;
      const rests = (k: number) => k < 0 || asleep[k] === 1 || inverseMass[k] === 0;
      if (rests(i) && rests(j) && this.#lives(t, generation)) this.step[t] = step;
    }
  }

  /** Takes out those that were not found in a step, from the first to the last, and says that they ended. */
  keep(step: number, queue: EventQueue): void {
    const { high, low, highGeneration, lowGeneration, events } = this;
    let kept = 0;
    for (let t = 0; t < this.count; t++) {
      if (this.step[t] !== step) {
        queue.add('contactEnd', events[t]);
        continue;
      }
      high[kept] = high[t];
      low[kept] = low[t];
      highGeneration[kept] = highGeneration[t];
      lowGeneration[kept] = lowGeneration[t];
      this.step[kept] = step;
      events[kept++] = events[t];
    }
    if (kept === this.count) return;
    this.count = kept;
    events.length = kept;
    this.#fillIndex();
  }

  clear(): void {
    if (this.count === 0) return;
    this.count = 0;
    this.events.length = 0;
    this.#fillIndex();
  }

  /** Whether both are still the particles that they were. */
  #lives(t: number, generation: Uint32Array): boolean {
    const j = this.low[t];
    return this.highGeneration[t] === generation[this.high[t]] && (j < 0 || this.lowGeneration[t] === generation[j]);
  }

  #fillIndex(): void {
    this.#index.fill(EMPTY);
    for (let t = 0; t < this.count; t++) this.#note(t);
  }

  #note(t: number): void {
    const index = this.#index;
    const mask = index.length - 1;
    let place = hash(this.high[t], this.low[t]) & mask;
    while (index[place] !== EMPTY) place = (place + 1) & mask;
    index[place] = t;
  }
}

function hash(a: number, b: number): number {
  const mixed = Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca77);
  return mixed ^ (mixed >>> 15);
}
