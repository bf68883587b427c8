/** How many boxes a group has: a power of two. */
const FANOUT = 8;

/** Numbers a box: minX, minY, maxX, maxY. */
const SIDES = 4;

/**
 * Boxes that do not change, in groups of eight neighbours, these again in groups of eight, and so on: those in a place are found
 * without a look at all the others. Boxes that follow each other should lie near each other, as the edges of a chain do. Everything
 * stands in two flat arrays, level by level.
 */
export class BoxTree {
  /** Numbers of the boxes found last, in ascending order. */
  readonly found: Int32Array;
  /** The boxes themselves, then the boxes around each group, and so on up to a single one. */
  readonly #boxes: Float64Array;
  /** Where each level begins, and where the last ends. */
  readonly #starts: Int32Array;
  readonly #levels: number;

  /** @param boxes - minX, minY, maxX, maxY of each box, one after the other. Unit: m. */
  constructor(boxes: Float64Array) {
    const count = boxes.length / SIDES;
    this.found = new Int32Array(count);
    const starts = [0, count];
    let end = count;
    for (let size = count; size > FANOUT; ) {
      size = Math.ceil(size / FANOUT);
      end += size;
      starts.push(end);
    }
    this.#starts = Int32Array.from(starts);
    this.#levels = starts.length - 1;
    this.#boxes = new Float64Array(end * SIDES).fill(Infinity);
    this.#boxes.set(boxes);
    for (let level = 1; level < this.#levels; level++) this.#surround(level);
  }

  /** Finds the boxes that overlap or touch a place. @returns How many there are in `found`. */
  find(minX: number, minY: number, maxX: number, maxY: number): number {
    const boxes = this.#boxes;
    const starts = this.#starts;
    const found = this.found;
    let count = 0;
    let level = this.#levels - 1;
    let node = starts[level];
    let end = starts[level + 1];
    // Down into each group that overlaps; at the end of a group up again and on, as far as groups end there.
    for (;;) {
      if (node === end) {
        if (++level >= this.#levels) return count;
        node = starts[level] + Math.floor((node - 1 - starts[level - 1]) / FANOUT) + 1;
        end = this.#endOfGroup(level, node - 1);
        continue;
      }
      const b = node * SIDES;
      if (boxes[b] > maxX || boxes[b + 1] > maxY || boxes[b + 2] < minX || boxes[b + 3] < minY) {
        node++;
      } else if (level === 0) {
        found[count++] = node++;
      } else {
        node = starts[level - 1] + (node - starts[level]) * FANOUT;
        level--;
        end = this.#endOfGroup(level, node);
      }
    }
  }

  /** Where the group ends in which a node stands. */
  #endOfGroup(level: number, node: number): number {
    const start = this.#starts[level];
    return Math.min(this.#starts[level + 1], node + FANOUT - ((node - start) & (FANOUT - 1)));
  }

  /** Writes the boxes around the groups of the level below. */
  #surround(level: number): void {
    const boxes = this.#boxes;
    const below = this.#starts[level - 1];
    const from = this.#starts[level];
    for (let node = below; node < from; node++) {
      const b = node * SIDES;
      const g = (from + Math.floor((node - below) / FANOUT)) * SIDES;
      const isFirst = (node - below) % FANOUT === 0;
      boxes[g] = Math.min(boxes[g], boxes[b]);
      boxes[g + 1] = Math.min(boxes[g + 1], boxes[b + 1]);
      boxes[g + 2] = isFirst ? boxes[b + 2] : Math.max(boxes[g + 2], boxes[b + 2]);
      boxes[g + 3] = isFirst ? boxes[b + 3] : Math.max(boxes[g + 3], boxes[b + 3]);
    }
  }
}
