import { type ContactBuffer, SCENERY } from '../../contacts/contact-buffer.ts';

/** Which contacts each particle has a part in: those of slot s are `contacts[first[s]]` to `contacts[first[s + 1] - 1]`. */
export class ContactTable {
  first: Int32Array = new Int32Array(1);
  contacts: Int32Array = new Int32Array(0);

  /** Reads a, b. Writes the table. */
  build({ count, a, b }: ContactBuffer, slotCount: number): void {
    if (this.first.length < slotCount + 1) this.first = new Int32Array(slotCount * 2 + 1);
    if (this.contacts.length < count * 2) this.contacts = new Int32Array(count * 4);
    const { first, contacts } = this;
    first.fill(0, 0, slotCount + 1);
    for (let c = 0; c < count; c++) {
      first[a[c]]++;
      if (b[c] !== SCENERY) first[b[c]]++;
    }
    for (let s = 0, sum = 0; s <= slotCount; s++) {
      sum += first[s];
      first[s] = sum;
    }
    for (let c = count - 1; c >= 0; c--) {
      contacts[--first[a[c]]] = c;
      if (b[c] !== SCENERY) contacts[--first[b[c]]] = c;
    }
  }
}
