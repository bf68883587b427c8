import { SCENERY } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { SAME_PLACE } from './places.ts';
import { nearOf, slackOf } from './slack.ts';

const FIRST_CAPACITY = 64;

/** What touches or nearly does in a step: each pair, each place of scenery once, in the order in which it was found. */
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
  /** The normal as it was at the last impact. */
  hitX: Float64Array = new Float64Array(FIRST_CAPACITY);
  hitY: Float64Array = new Float64Array(FIRST_CAPACITY);
  /** Sum of the impulses so far, as if what supports now did so to the end of the step. Unit: N·s. */
  impulse: Float64Array = new Float64Array(FIRST_CAPACITY);
  /** How far the two were apart when that was last looked at. Unit: m. */
  gap: Float64Array = new Float64Array(FIRST_CAPACITY);
  /** While they rest, the force between them. Unit: N. */
  force: Float64Array = new Float64Array(FIRST_CAPACITY);
  /** Of a place of scenery: the gap is this plus the product of normal and position. Unit: m. */
  #offset: Float64Array = new Float64Array(FIRST_CAPACITY);
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

  /**
   * The touch of two discs as they are now; a new one where there is none.
   * Reads x, y, radius. Writes the normal and the gap.
   */
  addDiscs(a: number, b: number, source: number, particles: ParticleArrays): number {
    let c = this.firstOf(a);
    while (c >= 0 && !(this.a[c] === b || this.b[c] === b)) c = this.nextOf(a, c);
    const isNew = c < 0;
    if (isNew) c = this.#append(a, b, source);
    this.measure(c, particles);
    if (isNew) this.noteHit(c);
    return c;
  }

  /** The touch of a particle and a place of a shape; a new one where there is none. */
  addPlace(a: number, source: number, { x, y }: ParticleArrays, gap: number, nx: number, ny: number): number {
    let c = this.firstOf(a);
    while (c >= 0 && !this.#isPlace(c, source, nx, ny)) c = this.nextOf(a, c);
    const isNew = c < 0;
    if (isNew) c = this.#append(a, SCENERY, source);
    this.normalX[c] = nx;
    this.normalY[c] = ny;
    if (isNew) this.noteHit(c);
    this.gap[c] = gap;
    this.#offset[c] = gap - (x[a] * nx + y[a] * ny);
    return c;
  }

  /** Notes the normal as that of an impact. */
  noteHit(c: number): void {
    this.hitX[c] = this.normalX[c];
    this.hitY[c] = this.normalY[c];
  }

  /**
   * Finds the gap, and the normal between two discs, as they are now; of scenery as if it were straight.
   * Reads x, y, radius. Writes the normal and the gap.
   */
  measure(c: number, { x, y, radius }: ParticleArrays): void {
    const i = this.a[c];
    const j = this.b[c];
    if (j === SCENERY) {
      this.gap[c] = this.#offset[c] + (x[i] * this.normalX[c] + y[i] * this.normalY[c]);
      return;
    }
    const dx = x[i] - x[j];
    const dy = y[i] - y[j];
    const distance = Math.sqrt(dx * dx + dy * dy);
    this.normalX[c] = distance === 0 ? 0 : dx / distance; // concentric discs define no direction: any will do
    this.normalY[c] = distance === 0 ? 1 : dy / distance;
    this.gap[c] = distance - radius[i] - radius[j];
  }

  /** The gap that the two may close without touching. Unit: m. */
  freeGap(c: number, { radius }: ParticleArrays): number {
    const ofFirst = radius[this.a[c]];
    const smaller = this.b[c] === SCENERY ? ofFirst : Math.min(ofFirst, radius[this.b[c]]);
    return Math.max(0, this.gap[c] - 2 * slackOf(smaller));
  }

  /** Whether the two are so near that they may rest on each other within the step. */
  isNear(c: number, { radius }: ParticleArrays): boolean {
    const ofFirst = radius[this.a[c]];
    const smaller = this.b[c] === SCENERY ? ofFirst : Math.min(ofFirst, radius[this.b[c]]);
    return this.gap[c] <= nearOf(smaller, false);
  }

  #isPlace(c: number, source: number, normalX: number, normalY: number): boolean {
    return this.source[c] === source && normalX * this.normalX[c] + normalY * this.normalY[c] > SAME_PLACE;
  }

  #append(a: number, b: number, source: number): number {
    if (this.count === this.a.length) this.#grow(this.count * 2);
    const c = this.count++;
    this.a[c] = a;
    this.b[c] = b;
    this.source[c] = source;
    this.impulse[c] = 0;
    this.force[c] = 0;
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
    this.hitX = grown(this.hitX, new Float64Array(capacity));
    this.hitY = grown(this.hitY, new Float64Array(capacity));
    this.impulse = grown(this.impulse, new Float64Array(capacity));
    this.gap = grown(this.gap, new Float64Array(capacity));
    this.force = grown(this.force, new Float64Array(capacity));
    this.#offset = grown(this.#offset, new Float64Array(capacity));
    this.#next = grown(this.#next, new Int32Array(capacity * 2));
  }
}

function grown<T extends { set(from: T): void }>(from: T, to: T): T {
  to.set(from);
  return to;
}
