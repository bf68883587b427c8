import type { ParticleArrays } from '../particles/particle-arrays.ts';

/**
 * Pairs of discs that are near each other, by a uniform grid as wide as the largest disc and its reach, hashed into a table:
 * each disc looks into its own cell and the eight around. Pairs come in the order of the lower slot, then of the cells.
 */
export class Grid {
  #first = new Int32Array(1);
  #entries = new Int32Array(0);
  #cellX = new Int32Array(0);
  #cellY = new Int32Array(0);

  /** The pairs found last: slots `pairs[2 * p]` and, higher, `pairs[2 * p + 1]`. */
  pairs: Int32Array = new Int32Array(128);

  /**
   * Finds each pair of discs whose gap is below a share of the sum of their radii, and of which one can move.
   * Reads x, y, radius, inverseMass. Writes the pairs.
   * @returns How many pairs there are.
   */
  findPairs(particles: ParticleArrays, early: number): number {
    const { count, x, y, radius, inverseMass } = particles;
    const mask = this.#fill(particles, early);
    const first = this.#first;
    const entries = this.#entries;
    const cellX = this.#cellX;
    const cellY = this.#cellY;
    let found = 0;
    for (let i = 0; i < count; i++) {
      if (radius[i] === 0) continue;
      for (let cell = 0; cell < 9; cell++) {
        const cx = cellX[i] + (cell % 3) - 1;
        const cy = cellY[i] + Math.floor(cell / 3) - 1;
        const bucket = hash(cx, cy, mask);
        for (let e = first[bucket]; e < first[bucket + 1]; e++) {
          const j = entries[e];
          if (j <= i || cellX[j] !== cx || cellY[j] !== cy || inverseMass[i] + inverseMass[j] === 0) continue;
          const dx = x[i] - x[j];
          const dy = y[i] - y[j];
          const reach = (radius[i] + radius[j]) * (1 + early);
          if (dx * dx + dy * dy >= reach * reach) continue;
          if (found * 2 === this.pairs.length) this.#grow();
          this.pairs[found * 2] = i;
          this.pairs[found * 2 + 1] = j;
          found++;
        }
      }
    }
    return found;
  }

  #grow(): void {
    const pairs = new Int32Array(this.pairs.length * 2);
    pairs.set(this.pairs);
    this.pairs = pairs;
  }

  /** Sorts the discs into the table. Returns the mask of its size. */
  #fill({ count, x, y, radius }: ParticleArrays, early: number): number {
    let largest = 0;
    for (let i = 0; i < count; i++) largest = Math.max(largest, radius[i]);
    let buckets = 1;
    while (buckets < count * 2) buckets *= 2;
    if (this.#first.length < buckets + 1) this.#first = new Int32Array(buckets + 1);
    if (this.#entries.length < count) {
      this.#entries = new Int32Array(count * 2);
      this.#cellX = new Int32Array(count * 2);
      this.#cellY = new Int32Array(count * 2);
    }
    const first = this.#first;
    const width = largest === 0 ? 1 : largest * 2 * (1 + early);
    first.fill(0, 0, buckets + 1);
    for (let i = 0; i < count; i++) {
      if (radius[i] === 0) continue;
      this.#cellX[i] = Math.floor(x[i] / width);
      this.#cellY[i] = Math.floor(y[i] / width);
      first[hash(this.#cellX[i], this.#cellY[i], buckets - 1)]++;
    }
    for (let b = 0, sum = 0; b <= buckets; b++) {
      sum += first[b];
      first[b] = sum;
    }
    for (let i = count - 1; i >= 0; i--) {
      if (radius[i] !== 0) this.#entries[--first[hash(this.#cellX[i], this.#cellY[i], buckets - 1)]] = i;
    }
    return buckets - 1;
  }
}

function hash(cellX: number, cellY: number, mask: number): number {
  return (Math.imul(cellX, 0x9e3779b1) ^ Math.imul(cellY, 0x85ebca77)) & mask;
}
