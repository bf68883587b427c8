import { type ContactBuffer, NO_EDGE, SCENERY } from '../../contacts/contact-buffer.ts';

/**
 * Which contacts each particle has a part in, and all that is needed to find their numbers anew, in one run of memory: those
 * of slot s are the entries `first[s]` to `first[s + 1] - 1`. Each contact has an entry with either of its particles, seen
 * from there. Scenery counts as one more slot, after all others, that has no entries. Contacts with edges stand in `EdgeEntries`.
 */
export class ContactTable {
  first: Int32Array = new Int32Array(1);
  /** The contact's index. */
  contact: Int32Array = new Int32Array(0);
  /** Slot of the other one. */
  other: Int32Array = new Int32Array(0);
  /** Unit normal, from the other one towards this. */
  normalX: Float64Array = new Float64Array(0);
  normalY: Float64Array = new Float64Array(0);

  /** Leaves out contacts of which neither can move. Reads a, b, normal, inverseMass. Writes the table. */
  build(contacts: ContactBuffer, inverseMass: Float64Array, slotCount: number): void {
    const { count, a, b, normalX, normalY, edgeEnd } = contacts;
    this.#reserve(slotCount, count);
    const { first } = this;
    first.fill(0, 0, slotCount + 1);
    for (let c = 0; c < count; c++) {
      const j = b[c] === SCENERY ? slotCount : b[c];
      if (edgeEnd[c] !== NO_EDGE || inverseMass[a[c]] + inverseMass[j] === 0) continue;
      first[a[c]]++;
      if (j < slotCount) first[j]++;
    }
    for (let s = 0, sum = 0; s <= slotCount; s++) {
      sum += first[s];
      first[s] = sum;
    }
    for (let c = count - 1; c >= 0; c--) {
      const i = a[c];
      const j = b[c] === SCENERY ? slotCount : b[c];
      if (edgeEnd[c] !== NO_EDGE || inverseMass[i] + inverseMass[j] === 0) continue;
      this.#write(--first[i], c, j, normalX[c], normalY[c]);
      if (j < slotCount) this.#write(--first[j], c, i, -normalX[c], -normalY[c]);
    }
  }

  #write(entry: number, contact: number, other: number, normalX: number, normalY: number): void {
    this.contact[entry] = contact;
    this.other[entry] = other;
    this.normalX[entry] = normalX;
    this.normalY[entry] = normalY;
  }

  #reserve(slotCount: number, contactCount: number): void {
    if (this.first.length < slotCount + 1) this.first = new Int32Array(slotCount * 2 + 1);
    if (this.contact.length >= contactCount * 2) return;
    this.contact = new Int32Array(contactCount * 4);
    this.other = new Int32Array(contactCount * 4);
    this.normalX = new Float64Array(contactCount * 4);
    this.normalY = new Float64Array(contactCount * 4);
  }
}
