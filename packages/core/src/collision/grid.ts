import type { ParticleArrays } from '../particles/particle-arrays.ts';

/** A disc so many times as large as the mean is left out of the grid, whose cells would be too wide for the others. */
const LARGE = 4;

/** Such discs, up to this many, are compared with all others instead. */
const MOST_LARGE = 16;

/**
 * Pairs of discs that are near each other, by a uniform grid as wide as the largest disc and its reach, hashed into a table:
 * each disc looks into its own cell and the eight around; cells that are neighbours in a row are neighbours in memory. Pairs come
 * in the order of the lower slot, then of the cells.
 */
export class Grid {
  #first = new Int32Array(1);
  #entries = new Int32Array(0);
  #cellX = new Int32Array(0);
  #cellY = new Int32Array(0);
  readonly #large = new Int32Array(MOST_LARGE);
  #largeCount = 0;
  #found = 0;

  /** The pairs found last: slots `pairs[2 * p]` and, higher, `pairs[2 * p + 1]`. */
  pairs: Int32Array = new Int32Array(128);

  /**
   * Finds each pair of discs whose gap is below a share of the sum of their radii, and of which one can move.
   * Reads x, y, radius, inverseMass. Writes the pairs.
   * @returns How many pairs there are.
   */
  findPairs(particles: ParticleArrays, early: number): number {
    const { count, radius } = particles;
    const limit = this.#findLarge(particles);
    const mask = this.#fill(particles, early, limit);
    const first = this.#first;
    const entries = this.#entries;
    const cellX = this.#cellX;
    const cellY = this.#cellY;
    this.#found = 0;
    for (let i = 0; i < count; i++) {
      if (radius[i] === 0) continue;
      if (radius[i] > limit) {
        for (let j = i + 1; j < count; j++) if (radius[j] !== 0) this.#compare(particles, early, i, j);
        continue;
      }
      for (let row = -1; row <= 1; row++) {
        const cy = cellY[i] + row;
        for (let column = -1; column <= 1; column++) {
          const cx = cellX[i] + column;
          const bucket = hash(cx, cy, mask);
          for (let e = first[bucket]; e < first[bucket + 1]; e++) {
            const j = entries[e];
            if (j > i && cellX[j] === cx && cellY[j] === cy) this.#compare(particles, early, i, j);
          }
        }
      }
      for (let l = 0; l < this.#largeCount; l++) {
        if (this.#large[l] > i) this.#compare(particles, early, i, this.#large[l]);
      }
    }
    return this.#found;
  }

  /** Notes a pair if it is near. */
  #compare({ x, y, radius, inverseMass }: ParticleArrays, early: number, i: number, j: number): void {
    const dx = x[i] - x[j];
    const dy = y[i] - y[j];
    const reach = (radius[i] + radius[j]) * (1 + early);
    if (dx * dx + dy * dy >= reach * reach || inverseMass[i] + inverseMass[j] === 0) return;
    if (this.#found * 2 === this.pairs.length) this.#grow();
    this.pairs[this.#found * 2] = i;
    this.pairs[this.#found * 2 + 1] = j;
    this.#found++;
  }

  #grow(): void {
    const pairs = new Int32Array(this.pairs.length * 2);
    pairs.set(this.pairs);
    this.pairs = pairs;
  }

  /** Lists the few discs that are much larger than most. Returns the radius above which they are. */
  #findLarge({ count, radius }: ParticleArrays): number {
    let sum = 0;
    let discs = 0;
    for (let i = 0; i < count; i++) {
      sum += radius[i];
      if (radius[i] !== 0) discs++;
    }
    const limit = (sum / discs) * LARGE;
    this.#largeCount = 0;
    for (let i = 0; i < count; i++) {
      if (!(radius[i] > limit)) continue;
      if (this.#largeCount === MOST_LARGE) {
        this.#largeCount = 0;
        return Infinity;
      }
      this.#large[this.#largeCount++] = i;
    }
    return limit;
  }

  /** Sorts the discs up to a radius into the table. Returns the mask of its size. */
  #fill({ count, x, y, radius }: ParticleArrays, early: number, limit: number): number {
    let largest = 0;
    for (let i = 0; i < count; i++) if (radius[i] <= limit) largest = Math.max(largest, radius[i]);
    const buckets = this.#reserve(count);
    const first = this.#first;
    const width = largest === 0 ? 1 : largest * 2 * (1 + early);
    first.fill(0, 0, buckets + 1);
    for (let i = 0; i < count; i++) {
      if (radius[i] === 0 || radius[i] > limit) continue;
      this.#cellX[i] = Math.floor(x[i] / width);
      this.#cellY[i] = Math.floor(y[i] / width);
      first[hash(this.#cellX[i], this.#cellY[i], buckets - 1)]++;
    }
    for (let b = 0, sum = 0; b <= buckets; b++) {
      sum += first[b];
      first[b] = sum;
    }
    for (let i = count - 1; i >= 0; i--) {
      if (radius[i] === 0 || radius[i] > limit) continue;
      this.#entries[--first[hash(this.#cellX[i], this.#cellY[i], buckets - 1)]] = i;
    }
    return buckets - 1;
  }

  /** Makes room. Returns how many buckets there are: a power of two. */
  #reserve(count: number): number {
    let buckets = 1;
    while (buckets < count * 2) buckets *= 2;
    if (this.#first.length < buckets + 1) this.#first = new Int32Array(buckets + 1);
    if (this.#entries.length < count) {
      this.#entries = new Int32Array(count * 2);
      this.#cellX = new Int32Array(count * 2);
      this.#cellY = new Int32Array(count * 2);
    }
    return buckets;
  }
}

/** Neighbours in a row come one after the other; rows are spread over the table. */
function hash(cellX: number, cellY: number, mask: number): number {
  return (cellX + Math.imul(cellY, 0x85ebca77)) & mask;
}
