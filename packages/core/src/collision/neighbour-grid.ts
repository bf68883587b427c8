/** Each level takes discs of up to twice the reach of those below. */
const LEVELS = 40;

/**
 * Finds discs that are near each other: a grid for each size of disc, all hashed into one table. A disc lies in a cell of its own
 * level, twice as wide as the widest reach there, and is compared with the discs of the cells around it, there and on each higher
 * level: so the smaller of two finds the pair, and a boulder among grains costs no more than what it touches.
 * (M. Eitz, L. Gu: Hierarchical Spatial Hashing for Real-time Collision Detection, 2007.)
 */
export class NeighbourGrid {
  /** The pairs found last, lower slot first. */
  a: Int32Array = new Int32Array(64);
  b: Int32Array = new Int32Array(64);
  pairCount = 0;
  /** Where each bucket begins among the entries, and the discs by bucket. */
  #first = new Int32Array(2);
  #entries = new Int32Array(0);
  #bucket = new Int32Array(0);
  #cellX = new Int32Array(0);
  #cellY = new Int32Array(0);
  #level = new Uint8Array(0);
  /** Width of the cells of each level; 0 where the level is empty. */
  readonly #width = new Float64Array(LEVELS);
  #levelCount = 0;

  /**
   * Finds each pair that is closer than the sum of their reaches. Writes the pairs, in no order of use.
   * @param reach - How far each disc reaches; 0 leaves it out. Unit: m.
   */
  findPairs(count: number, x: Float64Array, y: Float64Array, reach: Float64Array): void {
    const mask = this.#sort(count, x, y, reach);
    const first = this.#first;
    const entries = this.#entries;
    const cellX = this.#cellX;
    const cellY = this.#cellY;
    const levels = this.#level;
    const width = this.#width;
    const levelCount = this.#levelCount;
    this.pairCount = 0;
    for (let i = 0; i < count; i++) {
      if (reach[i] === 0) continue;
      for (let level = levels[i]; level < levelCount; level++) {
        if (width[level] === 0) continue;
        const same = level === levels[i];
        const cx = Math.floor(x[i] / width[level]);
        const cy = Math.floor(y[i] / width[level]);
        for (let cell = same ? 4 : 0; cell < 9; cell++) {
          const column = cx + (cell % 3) - 1;
          const row = cy + ((cell / 3) | 0) - 1;
          const bucket = hash(column, row, level, mask);
          for (let e = first[bucket]; e < first[bucket + 1]; e++) {
            const j = entries[e];
            if (cellX[j] !== column || cellY[j] !== row || levels[j] !== level || (same && cell === 4 && j <= i))
              continue;
            const dx = x[i] - x[j];
            const dy = y[i] - y[j];
            const near = reach[i] + reach[j];
            if (dx * dx + dy * dy < near * near) this.#add(i, j);
          }
        }
      }
    }
  }

  #add(i: number, j: number): void {
    if (this.pairCount === this.a.length) {
      this.a = grown(this.a);
      this.b = grown(this.b);
    }
    this.a[this.pairCount] = Math.min(i, j);
    this.b[this.pairCount++] = Math.max(i, j);
  }

  /** Sorts the discs into the buckets, by counting. Returns the mask of the table. */
  #sort(count: number, x: Float64Array, y: Float64Array, reach: Float64Array): number {
    const mask = this.#reserve(count);
    this.#assignLevels(count, reach);
    const first = this.#first;
    first.fill(0, 0, mask + 2);
    for (let i = 0; i < count; i++) {
      if (reach[i] === 0) continue;
      const level = this.#level[i];
      const column = Math.floor(x[i] / this.#width[level]);
      const row = Math.floor(y[i] / this.#width[level]);
      this.#cellX[i] = column;
      this.#cellY[i] = row;
      this.#bucket[i] = hash(column, row, level, mask);
      first[this.#bucket[i]]++;
    }
    for (let b = 0, sum = 0; b <= mask + 1; b++) {
      sum += first[b];
      first[b] = sum;
    }
    for (let i = count - 1; i >= 0; i--) if (reach[i] !== 0) this.#entries[--first[this.#bucket[i]]] = i;
    return mask;
  }

  /** Puts each disc on the level of its reach. Writes levels and the widths of their cells. */
  #assignLevels(count: number, reach: Float64Array): void {
    let least = Infinity;
    for (let i = 0; i < count; i++) if (reach[i] !== 0 && reach[i] < least) least = reach[i];
    this.#width.fill(0);
    this.#levelCount = 0;
    for (let i = 0; i < count; i++) {
      if (reach[i] === 0) continue;
      let level = 0;
      for (let top = least * 2; reach[i] >= top && level < LEVELS - 1; top *= 2) level++;
      this.#level[i] = level;
      if (level >= this.#levelCount) this.#levelCount = level + 1;
      if (reach[i] * 2 > this.#width[level]) this.#width[level] = reach[i] * 2;
    }
  }

  /** Makes room. Returns the mask of the table, whose size is a power of two. */
  #reserve(count: number): number {
    let buckets = 64;
    while (buckets < count * 2) buckets *= 2;
    if (this.#first.length < buckets + 1) this.#first = new Int32Array(buckets + 1);
    if (this.#entries.length < count) {
      this.#entries = new Int32Array(count * 2);
      this.#bucket = new Int32Array(count * 2);
      this.#cellX = new Int32Array(count * 2);
      this.#cellY = new Int32Array(count * 2);
      this.#level = new Uint8Array(count * 2);
    }
    return buckets - 1;
  }
}

function hash(column: number, row: number, level: number, mask: number): number {
  return (column + Math.imul(row, 0x85ebca77) + Math.imul(level, 0x27d4eb2f)) & mask;
}

function grown(from: Int32Array): Int32Array {
  const to = new Int32Array(from.length * 2);
  to.set(from);
  return to;
}
