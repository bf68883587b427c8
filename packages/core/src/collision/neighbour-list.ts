import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { NeighbourGrid } from './neighbour-grid.ts';
import { EARLY_SHARE } from './shape-contacts.ts';

/** How far a disc may go before its neighbours are looked for again, as a share of its radius. */
const SKIN = 0.15;

/**
 * Pairs of discs that may touch in the coming step, kept from step to step until one has gone farther than its skin
 * (L. Verlet: Computer "Experiments" on Classical Fluids, 1967). They are sorted by slot: those of slot i are `other[first[i]]`
 * to `other[first[i + 1] - 1]`, all higher than i.
 */
export class NeighbourList {
  first: Int32Array = new Int32Array(1);
  other: Int32Array = new Int32Array(0);
  /** The middle of each disc's way in the coming step, and how far it reaches from there: half the way, its radius, a little more. Unit: m. */
  x: Float64Array = new Float64Array(0);
  y: Float64Array = new Float64Array(0);
  reach: Float64Array = new Float64Array(0);
  /** The lower slots of the pairs by the higher: those of j are `lower[firstLower[j]]` to `lower[firstLower[j + 1] - 1]`. */
  #lower = new Int32Array(0);
  #firstLower = new Int32Array(1);
  readonly #grid = new NeighbourGrid();
  /** The same when the list was made, with the skin. Unit: m. */
  #x = new Float64Array(0);
  #y = new Float64Array(0);
  #allowed = new Float64Array(0);
  #version = -1;
  #linkVersion = -1;

  /** Brings the list up to date. Reads x, y, vx, vy, radius. Writes the list. Returns how many pairs it has. */
  update(particles: ParticleArrays, contacts: ContactBuffer): number {
    const { count, version } = particles;
    if (this.reach.length < count) this.#reserve(count * 2);
    const old = version !== this.#version || contacts.linkVersion !== this.#linkVersion;
    if (!this.#reachOut(particles, contacts) || old) {
      this.#rebuild(particles, contacts);
      this.#version = version;
      this.#linkVersion = contacts.linkVersion;
    }
    return this.first[count];
  }

  /** Finds how far each disc reaches. Returns whether each stays within what it was allowed when the list was made. */
  #reachOut({ count, x, y, vx, vy, radius }: ParticleArrays, { lookAhead, margin }: ContactBuffer): boolean {
    const { x: midX, y: midY, reach } = this;
    const bx = this.#x;
    const by = this.#y;
    const allowed = this.#allowed;
    const half = lookAhead / 2;
    let within = true;
    for (let i = 0; i < count; i++) {
      const r = radius[i];
      const wayX = vx[i] * half;
      const wayY = vy[i] * half;
      midX[i] = x[i] + wayX;
      midY[i] = y[i] + wayY;
      reach[i] = r === 0 ? 0 : r * (1 + EARLY_SHARE) + margin + Math.sqrt(wayX * wayX + wayY * wayY);
      if (Math.abs(midX[i] - bx[i]) + Math.abs(midY[i] - by[i]) + reach[i] > allowed[i]) within = false;
    }
    return within;
  }

  #rebuild(particles: ParticleArrays, contacts: ContactBuffer): void {
    const { count, radius } = particles;
    const { x, y, reach } = this;
    const allowed = this.#allowed;
    for (let i = 0; i < count; i++) {
      this.#x[i] = x[i];
      this.#y[i] = y[i];
      allowed[i] = reach[i] === 0 ? 0 : reach[i] + SKIN * radius[i];
    }
    this.#grid.findPairs(count, x, y, allowed);
    this.#sort(count, contacts);
  }

  /** Sorts the pairs of the grid by both slots, first by the higher, then by the lower; without those that a link holds. */
  #sort(count: number, contacts: ContactBuffer): void {
    const { a, b } = this.#grid;
    const pairs = this.#dropLinked(contacts);
    if (this.other.length < pairs) {
      this.other = new Int32Array(pairs * 2);
      this.#lower = new Int32Array(pairs * 2);
    }
    const { first, other } = this;
    const lower = this.#lower;
    const higher = this.#firstLower;
    first.fill(0, 0, count + 1);
    higher.fill(0, 0, count + 1);
    for (let p = 0; p < pairs; p++) {
      first[a[p]]++;
      higher[b[p]]++;
    }
    for (let i = 0, sum = 0, sumHigher = 0; i <= count; i++) {
      sum += first[i];
      first[i] = sum;
      sumHigher += higher[i];
      higher[i] = sumHigher;
    }
    for (let p = 0; p < pairs; p++) lower[--higher[b[p]]] = a[p];
    for (let j = count - 1; j >= 0; j--) {
      for (let k = higher[j]; k < higher[j + 1]; k++) other[--first[lower[k]]] = j;
    }
  }

  /** Puts the lower slot of each pair of the grid first, and takes those that a link holds out. Returns how many are left. */
  #dropLinked(contacts: ContactBuffer): number {
    const { a, b, pairCount } = this.#grid;
    let count = 0;
    for (let p = 0; p < pairCount; p++) {
      if (contacts.areLinked(a[p], b[p])) continue;
      const i = a[p];
      const j = b[p];
      a[count] = Math.min(i, j);
      b[count++] = Math.max(i, j);
    }
    return count;
  }

  #reserve(count: number): void {
    this.first = new Int32Array(count + 1);
    this.#firstLower = new Int32Array(count + 1);
    this.x = new Float64Array(count);
    this.y = new Float64Array(count);
    this.reach = new Float64Array(count);
    this.#x = new Float64Array(count);
    this.#y = new Float64Array(count);
    this.#allowed = new Float64Array(count).fill(-Infinity);
  }
}
