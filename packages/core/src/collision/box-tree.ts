/** How many boxes a group has. */
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
  #count = 0;

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
    this.#boxes = new Float64Array(end * SIDES).fill(Infinity);
    this.#boxes.set(boxes);
    for (let level = 1; level < starts.length - 1; level++) this.#surround(level);
  }

  /** Finds the boxes that overlap or touch a place. @returns How many there are in `found`. */
  find(minX: number, minY: number, maxX: number, maxY: number): number {
    this.#count = 0;
    const top = this.#starts.length - 2;
    this.#look(top, this.#starts[top], this.#starts[top + 1], minX, minY, maxX, maxY);
    return this.#count;
  }

  /** Looks at the boxes of a level from one to before another, and into each group that overlaps. */
  #look(level: number, from: number, to: number, minX: number, minY: number, maxX: number, maxY: number): void {
    const boxes = this.#boxes;
    const starts = this.#starts;
    for (let node = from; node < to; node++) {
      const b = node * SIDES;
      if (boxes[b] > maxX || boxes[b + 1] > maxY || boxes[b + 2] < minX || boxes[b + 3] < minY) continue;
      if (level === 0) {
        this.found[this.#count++] = node;
        continue;
      }
      const first = starts[level - 1] + (node - starts[level]) * FANOUT;
      this.#look(level - 1, first, Math.min(first + FANOUT, starts[level]), minX, minY, maxX, maxY);
    }
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
