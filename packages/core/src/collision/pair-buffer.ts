import { growColumns } from '../math/columns.ts';

/** Pairs of slots, in the order in which they were found. */
export class PairBuffer {
  a: Int32Array = new Int32Array(64);
  b: Int32Array = new Int32Array(64);
  count = 0;

  /** Makes room for more. */
  reserve(more: number): void {
    const wanted = this.count + more;
    if (wanted > this.a.length) growColumns(this, wanted * 2);
  }
}
