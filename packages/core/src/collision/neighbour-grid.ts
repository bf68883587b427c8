import { growColumns } from '../math/columns.ts';
import type { PairBuffer } from './pair-buffer.ts';

/** Each level takes discs of up to twice the reach of those below. */
const LEVELS = 40;

/** Buckets from one row of cells to the next: far from 0, and so is its double, by the size of any table. */
const ROW = 0x85ebca77;

/**
 * Finds discs that are near each other: a grid for each size of disc, each hashed into a table of its own. A disc lies in a cell of its
 * own level, twice as wide as the widest reach there, and is compared with the discs of the cells around it, there and on each higher
 * level: so the smaller of two finds the pair, and a boulder among grains costs no more than what it touches.
 * (M. Eitz, L. Gu: Hierarchical Spatial Hashing for Real-time Collision Detection, 2007.)
 *
 * The cells of a row lie side by side in the table, and the discs in its order in memory: three cells are one walk. What else the
 * hash puts there is too far off; and as rows lie apart in the table, no pair is met twice.
 */
export class NeighbourGrid {
  /** Where each bucket begins among the entries, level by level. The first two buckets of a level stand again after its last. */
  #first = new Int32Array(0);
  /** The discs by bucket. */
  readonly #entries = {
    slot: new Int32Array(0),
    x: new Float64Array(0),
    y: new Float64Array(0),
    reach: new Float64Array(0),
  };
  readonly #discs = { bucket: new Int32Array(0), level: new Uint8Array(0) };
  /** Of each level: the width of its cells, 0 where it is empty; where its buckets begin, and the mask of its table. */
  readonly #width = new Float64Array(LEVELS);
  readonly #start = new Int32Array(LEVELS);
  readonly #mask = new Int32Array(LEVELS);
  readonly #population = new Int32Array(LEVELS);

  /**
   * Takes discs, and finds each pair that is closer than the sum of their reaches. Adds the pairs, in no order of use.
   * @param reach - How far each disc reaches; 0 leaves it out. Unit: m.
   */
  findPairs(count: number, x: Float64Array, y: Float64Array, reach: Float64Array, pairs: PairBuffer): void {
    if (this.#discs.bucket.length < count) growColumns(this.#discs, count * 2);
    this.#assignLevels(count, reach);
    this.#sort(count, x, y, reach);
    for (let level = 0; level < LEVELS; level++) {
      if (this.#population[level] === 0) continue;
      this.#pairWithin(level, pairs);
      for (let above = level + 1; above < LEVELS; above++) {
        if (this.#population[above] > 0) this.#pairWithHigher(level, above, pairs);
      }
    }
  }

  /** Pairs of one level: each disc with those that follow it in its own cell, with the next cell, and with three of the next row. */
  #pairWithin(level: number, pairs: PairBuffer): void {
    const first = this.#first;
    const { slot, x, y, reach } = this.#entries;
    const start = this.#start[level];
    const mask = this.#mask[level];
    for (let bucket = 0; bucket <= mask; bucket++) {
      const begin = first[start + bucket];
      const end = first[start + bucket + 1];
      if (begin === end) continue;
      const next = first[start + bucket + 2];
      const row = start + ((bucket + ROW - 1) & mask);
      pairs.reserve((end - begin) * (next - begin + first[row + 3] - first[row]));
      for (let e = begin; e < end; e++) {
        this.#compare(slot[e], x[e], y[e], reach[e], e + 1, next, pairs);
        this.#compare(slot[e], x[e], y[e], reach[e], first[row], first[row + 3], pairs);
      }
    }
  }

  /** Pairs of two levels: each disc of the lower with the nine cells around it on the higher. */
  #pairWithHigher(level: number, above: number, pairs: PairBuffer): void {
    const first = this.#first;
    const { slot, x, y, reach } = this.#entries;
    const width = this.#width[above];
    const start = this.#start[above];
    const mask = this.#mask[above];
    const end = first[this.#start[level] + this.#mask[level] + 1];
    for (let e = first[this.#start[level]]; e < end; e++) {
      const column = Math.floor(x[e] / width);
      const row = Math.floor(y[e] / width);
      for (let r = row - 1; r <= row + 1; r++) {
        const bucket = start + hash(column - 1, r, mask);
        pairs.reserve(first[bucket + 3] - first[bucket]);
        this.#compare(slot[e], x[e], y[e], reach[e], first[bucket], first[bucket + 3], pairs);
      }
    }
  }

  /**
   * Finds who of the discs taken last is closer to another than the sum of their reaches. Adds pairs; some may be there twice.
   * @param i - Slot of the other.
   * @returns How much was to do: cells and comparisons.
   */
  findAround(i: number, x: number, y: number, reach: number, pairs: PairBuffer): number {
    const first = this.#first;
    let work = 0;
    for (let level = 0; level < LEVELS; level++) {
      if (this.#population[level] === 0) continue;
      const width = this.#width[level];
      const start = this.#start[level];
      const mask = this.#mask[level];
      const far = reach + width / 2;
      const firstColumn = Math.floor((x - far) / width);
      const columns = Math.floor((x + far) / width) - firstColumn + 1;
      const firstRow = Math.floor((y - far) / width);
      const rows = Math.floor((y + far) / width) - firstRow + 1;
      // Of more cells than the table has, all stand there.
      const all = columns * rows > mask;
      for (let row = 0; row < (all ? 1 : rows); row++) {
        for (let column = 0; column < (all ? 1 : columns); column += 3) {
          const bucket = start + hash(firstColumn + column, firstRow + row, mask);
          const from = first[all ? start : bucket];
          const to = first[all ? start + mask + 1 : bucket + 3];
          pairs.reserve(to - from);
          this.#compare(i, x, y, reach, from, to, pairs);
          work += to - from + 1;
        }
      }
    }
    return work;
  }

  /** Compares a disc with some that lie side by side. Adds pairs, each of which is written over unless it is near: no branch to miss. */
  #compare(i: number, atX: number, atY: number, own: number, from: number, to: number, pairs: PairBuffer): void {
    const { slot, x, y, reach } = this.#entries;
    const { a, b } = pairs;
    let { count } = pairs;
    for (let f = from; f < to; f++) {
      const dx = atX - x[f];
      const dy = atY - y[f];
      const near = own + reach[f];
      a[count] = i;
      b[count] = slot[f];
      count += Number(dx * dx + dy * dy < near * near);
    }
    pairs.count = count;
  }

  /** Sorts the discs into the buckets, by counting. */
  #sort(count: number, x: Float64Array, y: Float64Array, reach: Float64Array): void {
    const buckets = this.#layOut();
    const first = this.#first;
    const width = this.#width;
    const start = this.#start;
    const mask = this.#mask;
    const { bucket, level: levels } = this.#discs;
    first.fill(0, 0, buckets + 1);
    for (let i = 0; i < count; i++) {
      if (reach[i] === 0) continue;
      const level = levels[i];
      const own = hash(Math.floor(x[i] / width[level]), Math.floor(y[i] / width[level]), mask[level]);
      bucket[i] = start[level] + own;
      first[bucket[i]]++;
      if (own < 2) first[bucket[i] + mask[level] + 1]++;
    }
    let sum = 0;
    for (let k = 0; k <= buckets; k++) {
      sum += first[k];
      first[k] = sum;
    }
    if (this.#entries.slot.length < sum) growColumns(this.#entries, sum * 2);
    for (let i = count - 1; i >= 0; i--) {
      if (reach[i] === 0) continue;
      const k = bucket[i];
      this.#enter(--first[k], i, x[i], y[i], reach[i]);
      const level = levels[i];
      if (k < start[level] + 2) this.#enter(--first[k + mask[level] + 1], i, x[i], y[i], reach[i]);
    }
  }

  #enter(e: number, i: number, x: number, y: number, reach: number): void {
    const entries = this.#entries;
    entries.slot[e] = i;
    entries.x[e] = x;
    entries.y[e] = y;
    entries.reach[e] = reach;
  }

  /** Puts each disc on the level of its reach. Writes levels, the widths of their cells, and how many discs they have. */
  #assignLevels(count: number, reach: Float64Array): void {
    const levels = this.#discs.level;
    let least = Infinity;
    for (let i = 0; i < count; i++) if (reach[i] !== 0 && reach[i] < least) least = reach[i];
    const width = this.#width.fill(0);
    const population = this.#population.fill(0);
    for (let i = 0; i < count; i++) {
      if (reach[i] === 0) continue;
      let level = 0;
      for (let top = least * 2; reach[i] >= top && level < LEVELS - 1; top *= 2) level++;
      levels[i] = level;
      population[level]++;
      if (reach[i] * 2 > width[level]) width[level] = reach[i] * 2;
    }
  }

  /** Gives each level a table, whose size is a power of two. Returns how many buckets there are in all. */
  #layOut(): number {
    let buckets = 0;
    for (let level = 0; level < LEVELS; level++) {
      if (this.#population[level] === 0) continue;
      let size = 64;
      while (size < this.#population[level] * 2) size *= 2;
      this.#start[level] = buckets;
      this.#mask[level] = size - 1;
      buckets += size + 2;
    }
    if (this.#first.length <= buckets) this.#first = new Int32Array(buckets * 2);
    return buckets;
  }
}

function hash(column: number, row: number, mask: number): number {
  return (column + Math.imul(row, ROW)) & mask;
}
