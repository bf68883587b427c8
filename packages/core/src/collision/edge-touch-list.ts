import { growColumns } from '../math/columns.ts';

/** Where one particle touches edges and their ends, sorted by slots. */
export class TouchList {
  count = 0;
  /** Slot of the end where the edge starts, or which is touched itself. */
  b: Int32Array = new Int32Array(16);
  /** Slot of the other end; -1 where no edge but an end is touched. */
  edgeEnd: Int32Array = new Int32Array(16);
  /** Where on the edge, 0 at the start and 1 at the other end. */
  share: Float64Array = new Float64Array(16);
  /** Unit normal, towards the particle. */
  normalX: Float64Array = new Float64Array(16);
  normalY: Float64Array = new Float64Array(16);
  /** Unit: m. */
  penetration: Float64Array = new Float64Array(16);

  /**
   * Adds a touch in its place. Returns that, where the numbers are still to be written: handed to a function, each would be an object.
   * Of two with the same slots the one that was first stays, and it is -1.
   */
  add(b: number, edgeEnd: number): number {
    if (this.count === this.b.length) growColumns(this, this.count * 2);
    let place = this.count;
    while (place > 0 && this.#isAfter(place - 1, b, edgeEnd)) place--;
    if (place > 0 && this.b[place - 1] === b && this.edgeEnd[place - 1] === edgeEnd) return -1;
    for (let t = this.count++; t > place; t--) this.#copy(t - 1, t);
    this.b[place] = b;
    this.edgeEnd[place] = edgeEnd;
    return place;
  }

  #isAfter(touch: number, b: number, edgeEnd: number): boolean {
    return this.b[touch] > b || (this.b[touch] === b && this.edgeEnd[touch] > edgeEnd);
  }

  #copy(from: number, to: number): void {
    this.b[to] = this.b[from];
    this.edgeEnd[to] = this.edgeEnd[from];
    this.share[to] = this.share[from];
    this.normalX[to] = this.normalX[from];
    this.normalY[to] = this.normalY[from];
    this.penetration[to] = this.penetration[from];
  }
}
