import type { ContactBuffer } from './contact-buffer.ts';

/**
 * Takes out contacts that were found again: both lists, those known and those after them, are in the order of sources and slots.
 * @param known - How many contacts were known.
 */
export function dropRepeated(contacts: ContactBuffer, known: number): void {
  const columns = Object.values(contacts).filter((column) => ArrayBuffer.isView(column)) as unknown as Float64Array[];
  const { count } = contacts;
  let to = known;
  let k = 0;
  for (let c = known; c < count; c++) {
    while (k < known && order(contacts, k, c) < 0) k++;
    if (k < known && order(contacts, k, c) === 0) continue;
    for (const column of columns) column.copyWithin(to, c, c + 1);
    to++;
  }
  contacts.count = to;
  contacts.edgesStart = Math.min(contacts.edgesStart, known); // what came after has moved
  contacts.edgesEnd = Math.min(contacts.edgesEnd, to);
}

function order({ source, a, b, edgeEnd }: ContactBuffer, c: number, d: number): number {
  return source[c] - source[d] || a[c] - a[d] || b[c] - b[d] || edgeEnd[c] - edgeEnd[d];
}
