import { growColumns } from '../math/columns.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { EdgeBounds } from './edge-bounds.ts';
import type { EdgeTable } from './edge-table.ts';

/** How far things may go before pairs are looked for again, as a share of the mean width of a hull. */
const SKIN = 0.1;

/** What reaches so many times as far as the mean is left out of the grid and compared with every hull. */
const FAR = 4;

/**
 * Pairs of a particle and a hull that may touch in the coming step, kept until something has gone farther than its skin. They are
 * sorted by slot, then hull: the hulls of slot i are `hull[first[i]]` to `hull[first[i + 1] - 1]`.
 */
export class EdgePairs {
  first: Int32Array = new Int32Array(1);
  hull: Int32Array = new Int32Array(0);
  /** Where each particle was when the pairs were found, and how far it might reach from there. Unit: m. */
  #x = new Float64Array(0);
  #y = new Float64Array(0);
  #allowed = new Float64Array(0);
  /** The grid: where each bucket begins among the entries, the slots by bucket, and the cell of each slot. */
  #bucket = new Int32Array(2);
  #entries = new Int32Array(0);
  #cellX = new Int32Array(0);
  #cellY = new Int32Array(0);
  #mask = 0;
  #width = 1;
  #widest = 0;
  /** Slots that are compared with every hull. */
  #far = new Int32Array(0);
  #farCount = 0;
  /** What was found, in no order of use. */
  readonly #pairs = { slot: new Int32Array(256), hull: new Int32Array(256) };
  #found = 0;

  /**
   * Reads x, y, vx, vy, alive and the bounds. Writes the pairs.
   * @param changed - Whether particles, bodies or links came or went.
   */
  update(particles: ParticleArrays, table: EdgeTable, bounds: EdgeBounds, changed: boolean): void {
    if (!changed && this.#isCurrent(particles, bounds)) return;
    this.#allow(particles, table, bounds);
    this.#fill(particles);
    this.#found = 0;
    for (let h = 0; h < table.hullCount; h++) this.#look(particles, table, h);
    this.#sort(particles.count);
  }

  #isCurrent({ count, x, y }: ParticleArrays, { reach }: EdgeBounds): boolean {
    const bx = this.#x;
    const by = this.#y;
    const allowed = this.#allowed;
    for (let i = 0; i < count; i++) {
      if (Math.abs(x[i] - bx[i]) + Math.abs(y[i] - by[i]) + reach[i] > allowed[i]) return false;
    }
    return true;
  }

  /** Lets everything go by its skin, and what is fast on for two more steps. Finds the width of the cells. */
  #allow({ count, x, y, radius }: ParticleArrays, { hullCount }: EdgeTable, bounds: EdgeBounds): void {
    const { reach, minX, minY, maxX, maxY } = bounds;
    if (this.#allowed.length < count) this.#reserve(count * 2);
    let width = 0;
    for (let h = 0; h < hullCount; h++) width += Math.max(maxX[h] - minX[h], maxY[h] - minY[h]) / hullCount;
    let sum = 0;
    for (let i = 0; i < count; i++) {
      this.#x[i] = x[i];
      this.#y[i] = y[i];
      this.#allowed[i] = reach[i] + SKIN * width + 2 * (reach[i] - radius[i]);
      sum += this.#allowed[i];
    }
    this.#width = Math.max(width, (2 * sum) / count);
    this.#widest = (FAR * sum) / count;
  }

  /** Sorts the particles into the grid by their centres. */
  #fill({ count, alive }: ParticleArrays): void {
    const bucket = this.#bucket;
    const allowed = this.#allowed;
    let widest = 0;
    bucket.fill(0);
    this.#farCount = 0;
    for (let i = 0; i < count; i++) {
      if (alive[i] === 0) continue;
      if (allowed[i] > this.#widest) {
        this.#far[this.#farCount++] = i;
        continue;
      }
      if (allowed[i] > widest) widest = allowed[i];
      this.#cellX[i] = Math.floor(this.#x[i] / this.#width);
      this.#cellY[i] = Math.floor(this.#y[i] / this.#width);
      bucket[hash(this.#cellX[i], this.#cellY[i], this.#mask)]++;
    }
    for (let b = 0, sum = 0; b < bucket.length; b++) {
      sum += bucket[b];
      bucket[b] = sum;
    }
    for (let i = count - 1; i >= 0; i--) {
      if (alive[i] === 0 || allowed[i] > this.#widest) continue;
      this.#entries[--bucket[hash(this.#cellX[i], this.#cellY[i], this.#mask)]] = i;
    }
    this.#widest = widest;
  }

  /** Finds the particles that may come to one hull. */
  #look({ count, alive }: ParticleArrays, { hulls, edges, slots }: EdgeTable, h: number): void {
    const allowed = this.#allowed;
    let minX = Infinity;
    let minY = Infinity;
    let maxX = -Infinity;
    let maxY = -Infinity;
    for (let k = hulls.first[h]; k < hulls.first[h + 1]; k++) {
      for (let s = edges.start[k]; ; s = edges.end[k]) {
        minX = Math.min(minX, this.#x[s] - allowed[s]);
        minY = Math.min(minY, this.#y[s] - allowed[s]);
        maxX = Math.max(maxX, this.#x[s] + allowed[s]);
        maxY = Math.max(maxY, this.#y[s] + allowed[s]);
        if (s === edges.end[k]) break;
      }
    }
    const box = { minX, minY, maxX, maxY, owner: hulls.owner[h] };
    for (let f = 0; f < this.#farCount; f++) this.#compare(this.#far[f], h, slots.owner, box);
    const left = Math.floor((minX - this.#widest) / this.#width);
    const right = Math.floor((maxX + this.#widest) / this.#width);
    const bottom = Math.floor((minY - this.#widest) / this.#width);
    const top = Math.floor((maxY + this.#widest) / this.#width);
    if ((right - left + 1) * (top - bottom + 1) > count) {
      // A hull of so many cells is compared with all particles instead.
      for (let i = 0; i < count; i++) {
        if (alive[i] === 1 && allowed[i] <= this.#widest) this.#compare(i, h, slots.owner, box);
      }
      return;
    }
    for (let row = bottom; row <= top; row++) {
      for (let column = left; column <= right; column++) {
        const b = hash(column, row, this.#mask);
        for (let e = this.#bucket[b]; e < this.#bucket[b + 1]; e++) {
          const i = this.#entries[e];
          if (this.#cellX[i] === column && this.#cellY[i] === row) this.#compare(i, h, slots.owner, box);
        }
      }
    }
  }

  #compare(i: number, h: number, owner: Int32Array, box: Box): void {
    const r = this.#allowed[i];
    const x = this.#x[i];
    const y = this.#y[i];
    if (x + r < box.minX || x - r > box.maxX || y + r < box.minY || y - r > box.maxY || owner[i] === box.owner) return;
    if (this.#found === this.#pairs.slot.length) growColumns(this.#pairs, this.#found * 2);
    this.#pairs.slot[this.#found] = i;
    this.#pairs.hull[this.#found++] = h;
  }

  /** Sorts what was found by slot; the hulls of a slot stay in order. */
  #sort(count: number): void {
    const { first } = this;
    const { slot, hull } = this.#pairs;
    if (this.hull.length < this.#found) this.hull = new Int32Array(this.#found * 2);
    first.fill(0, 0, count + 1);
    for (let f = 0; f < this.#found; f++) first[slot[f]]++;
    for (let i = 0, sum = 0; i <= count; i++) {
      sum += first[i];
      first[i] = sum;
    }
    for (let f = this.#found - 1; f >= 0; f--) this.hull[--first[slot[f]]] = hull[f];
  }

  #reserve(count: number): void {
    let buckets = 64;
    while (buckets < count) buckets *= 2;
    this.#mask = buckets - 1;
    this.#bucket = new Int32Array(buckets + 1);
    this.first = new Int32Array(count + 1);
    this.#x = new Float64Array(count);
    this.#y = new Float64Array(count);
    this.#allowed = new Float64Array(count);
    this.#entries = new Int32Array(count);
    this.#cellX = new Int32Array(count);
    this.#cellY = new Int32Array(count);
    this.#far = new Int32Array(count);
  }
}

interface Box {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  readonly owner: number;
}

function hash(column: number, row: number, mask: number): number {
  return (column + Math.imul(row, 0x85ebca77)) & mask;
}
