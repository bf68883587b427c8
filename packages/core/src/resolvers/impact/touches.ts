import { SCENERY } from '../../contacts/contact-buffer.ts';
import { SAME_PLACE } from './places.ts';

const FIRST_CAPACITY = 64;

/** What touched in a step, each pair and each place of scenery once, in the order in which it did so first. */
export class Touches {
  count = 0;
  /** Slots of the two; `b` is `SCENERY` for a static shape. */
  a: Int32Array = new Int32Array(FIRST_CAPACITY);
  b: Int32Array = new Int32Array(FIRST_CAPACITY);
  /** Where the touch comes from: see `ContactSources.at`. */
  source: Int32Array = new Int32Array(FIRST_CAPACITY);
  /** Unit normal, towards `a`. */
  normalX: Float64Array = new Float64Array(FIRST_CAPACITY);
  normalY: Float64Array = new Float64Array(FIRST_CAPACITY);
  /** Sum of the impulses so far, as if what supports now did so to the end of the step. Unit: N·s. */
  impulse: Float64Array = new Float64Array(FIRST_CAPACITY);
  /** 1 while the two rest on each other. */
  resting: Uint8Array = new Uint8Array(FIRST_CAPACITY);
  /** While they rest, the force between them. Unit: N. */
  force: Float64Array = new Float64Array(FIRST_CAPACITY);
  /** Mark of whoever walks over touches. */
  mark: Int32Array = new Int32Array(FIRST_CAPACITY);
  /** The touches of each particle, as a list: `first` by slot, then `next` by touch and side; -1 ends it. */
  #first = new Int32Array(0);
  #next: Int32Array = new Int32Array(FIRST_CAPACITY * 2);

  clear(slotCount: number): void {
    this.count = 0;
    if (this.#first.length < slotCount) this.#first = new Int32Array(slotCount * 2);
    this.#first.fill(-1, 0, slotCount);
  }

  /** The first touch of a particle, or -1. */
  firstOf(slot: number): number {
    return this.#first[slot];
  }

  /** The touch of a particle after another of its touches, or -1. */
  nextOf(slot: number, c: number): number {
    return this.#next[c * 2 + (this.a[c] === slot ? 0 : 1)];
  }

  /** The touch of a pair or a place, now with this normal; a new one where there is none. */
  add(a: number, b: number, source: number, normalX: number, normalY: number): number {
    let c = this.firstOf(a);
    while (c >= 0 && !this.#is(c, b, source, normalX, normalY)) c = this.nextOf(a, c);
    if (c < 0) c = this.#append(a, b, source);
    const sign = this.a[c] === a ? 1 : -1;
    this.normalX[c] = normalX * sign;
    this.normalY[c] = normalY * sign;
    return c;
  }

  #is(c: number, b: number, source: number, normalX: number, normalY: number): boolean {
    if (this.source[c] !== source) return false;
    if (b === SCENERY) return normalX * this.normalX[c] + normalY * this.normalY[c] > SAME_PLACE;
    return this.a[c] === b || this.b[c] === b;
  }

  #append(a: number, b: number, source: number): number {
    if (this.count === this.a.length) this.#grow(this.count * 2);
    const c = this.count++;
    this.a[c] = a;
    this.b[c] = b;
    this.source[c] = source;
    this.impulse[c] = 0;
    this.resting[c] = 0;
    this.force[c] = 0;
    this.mark[c] = 0;
    this.#next[c * 2] = this.#first[a];
    this.#first[a] = c;
    if (b !== SCENERY) {
      this.#next[c * 2 + 1] = this.#first[b];
      this.#first[b] = c;
    }
    return c;
  }

  #grow(capacity: number): void {
    this.a = grown(this.a, new Int32Array(capacity));
    this.b = grown(this.b, new Int32Array(capacity));
    this.source = grown(this.source, new Int32Array(capacity));
    this.normalX = grown(this.normalX, new Float64Array(capacity));
    this.normalY = grown(this.normalY, new Float64Array(capacity));
    this.impulse = grown(this.impulse, new Float64Array(capacity));
    this.resting = grown(this.resting, new Uint8Array(capacity));
    this.force = grown(this.force, new Float64Array(capacity));
    this.mark = grown(this.mark, new Int32Array(capacity));
    this.#next = grown(this.#next, new Int32Array(capacity * 2));
  }
}

function grown<T extends { set(from: T): void }>(from: T, to: T): T {
  to.set(from);
  return to;
}
