import { growColumns } from '../../math/columns.ts';
import type { ContactBuffer } from '../contact-buffer.ts';
import type { ContactRows } from './contact-rows.ts';

/**
 * The impulses of the last step, for the next to begin with. A contact is known again by its source, its slots and its edge: both
 * lists are walked along together, since generators report in the order of the slots. One that is out of order begins with nothing.
 */
export class ImpulseMemory {
  #count = 0;
  #linkCount = 0;
  #h = 1;
  readonly #kept = {
    a: new Int32Array(64),
    b: new Int32Array(64),
    edgeEnd: new Int32Array(64),
    source: new Int32Array(64),
    normal: new Float64Array(64),
    tangent: new Float64Array(64),
  };

  /**
   * Hands each contact what it had in the last small step. Reads a, b, edgeEnd, source. Writes normal, tangent, closing, lasting of the rows.
   * @param linkCount - How many sources are links: the others are known by their number after these.
   */
  recall(contacts: ContactBuffer, rows: ContactRows, linkCount: number, h: number): void {
    const { count, a, b, edgeEnd, source } = contacts;
    const { normal, tangent, closing, lasting } = rows;
    const kept = this.#kept;
    const scale = h / this.#h; // the same forces, over another time
    const shift = linkCount - this.#linkCount;
    let m = 0;
    for (let c = 0; c < count; c++) {
      let order = -1;
      for (; m < this.#count; m++) {
        order =
          kept.source[m] + shift - source[c] || kept.a[m] - a[c] || kept.b[m] - b[c] || kept.edgeEnd[m] - edgeEnd[c];
        if (order >= 0) break;
      }
      const known = order === 0 && m < this.#count;
      normal[c] = known ? kept.normal[m] * scale : 0;
      tangent[c] = known ? kept.tangent[m] * scale : 0;
      closing[c] = 0;
      lasting[c] = known ? 1 : 0;
      if (known) m++;
    }
  }

  /** Reads the contacts and their rows. Writes the memory. */
  keep(contacts: ContactBuffer, rows: ContactRows, linkCount: number, h: number): void {
    const { count, a, b, edgeEnd, source } = contacts;
    const kept = this.#kept;
    if (kept.a.length < count) growColumns(kept, count * 2);
    this.#count = count;
    this.#linkCount = linkCount;
    this.#h = h;
    for (let c = 0; c < count; c++) {
      kept.a[c] = a[c];
      kept.b[c] = b[c];
      kept.edgeEnd[c] = edgeEnd[c];
      kept.source[c] = source[c];
      kept.normal[c] = rows.normal[c];
      kept.tangent[c] = rows.tangent[c];
    }
  }
}
