import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import type { Impulses } from './solve-contacts.ts';

/**
 * The impulses of the last step, for the next to begin with. A contact is known again by its source, its slots and its edge: both
 * lists are walked along together, since generators report in the order of the slots. One that is out of order begins with nothing.
 */
export class ImpulseMemory {
  #count = 0;
  #linkCount = 0;
  #h = 1;
  #a = new Int32Array(0);
  #b = new Int32Array(0);
  #edgeEnd = new Int32Array(0);
  #source = new Int32Array(0);
  #normal = new Float64Array(0);
  #tangent = new Float64Array(0);

  /**
   * Hands each contact what it had in the last small step. Reads a, b, edgeEnd, source. Writes impulse, tangentImpulse.
   * @param linkCount - How many sources are links: the others are known by their number after these.
   */
  recall(contacts: ContactBuffer, linkCount: number, h: number): void {
    const { count, a, b, edgeEnd, source, impulse, tangentImpulse } = contacts;
    const scale = h / this.#h; // the same forces, over another time
    const shift = linkCount - this.#linkCount;
    let m = 0;
    for (let c = 0; c < count; c++) {
      let order = -1;
      for (; m < this.#count; m++) {
        order =
          this.#source[m] + shift - source[c] ||
          this.#a[m] - a[c] ||
          this.#b[m] - b[c] ||
          this.#edgeEnd[m] - edgeEnd[c];
        if (order >= 0) break;
      }
      if (order !== 0) continue;
      impulse[c] = this.#normal[m] * scale;
      tangentImpulse[c] = this.#tangent[m++] * scale;
    }
  }

  /** Reads the contacts and the rows of two kinds that were made of them. Writes the memory. */
  keep(contacts: ContactBuffer, rows: Impulses, edges: Impulses, linkCount: number, h: number): void {
    const { count, a, b, edgeEnd, source } = contacts;
    if (this.#a.length < count) this.#reserve(count * 2);
    this.#count = count;
    this.#linkCount = linkCount;
    this.#h = h;
    for (let c = 0; c < count; c++) {
      this.#a[c] = a[c];
      this.#b[c] = b[c];
      this.#edgeEnd[c] = edgeEnd[c];
      this.#source[c] = source[c];
    }
    this.#normal.fill(0, 0, count);
    this.#tangent.fill(0, 0, count);
    this.#note(rows);
    this.#note(edges);
  }

  #note({ count, contact, normal, tangent }: Impulses): void {
    for (let r = 0; r < count; r++) {
      this.#normal[contact[r]] = normal[r];
      this.#tangent[contact[r]] = tangent[r];
    }
  }

  #reserve(count: number): void {
    this.#a = new Int32Array(count);
    this.#b = new Int32Array(count);
    this.#edgeEnd = new Int32Array(count);
    this.#source = new Int32Array(count);
    this.#normal = new Float64Array(count);
    this.#tangent = new Float64Array(count);
  }
}
