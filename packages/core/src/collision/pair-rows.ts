import type { PairBuffer } from './pair-buffer.ts';

/**
 * Pairs of slots in order: those of slot i are `other[first[i]]` to `other[first[i + 1] - 1]`, all higher than i, in ascending order.
 */
export class PairRows {
  first: Int32Array = new Int32Array(1);
  other: Int32Array = new Int32Array(64);
  /** The same by the higher slot, on the way. */
  #firstLower = new Int32Array(1);
  #lower = new Int32Array(64);

  /** Takes pairs, lower slot first, and sorts them, first by the higher slot, then by the lower. */
  sort(count: number, { a, b, count: pairs }: PairBuffer): void {
    this.#reserve(count, pairs);
    const { first, other } = this;
    const firstLower = this.#firstLower;
    const lower = this.#lower;
    first.fill(0, 0, count + 1);
    firstLower.fill(0, 0, count + 1);
    for (let p = 0; p < pairs; p++) {
      first[a[p]]++;
      firstLower[b[p]]++;
    }
    let sum = 0;
    let sumLower = 0;
    for (let i = 0; i <= count; i++) {
      sum += first[i];
      first[i] = sum;
      sumLower += firstLower[i];
      firstLower[i] = sumLower;
    }
    for (let p = 0; p < pairs; p++) lower[--firstLower[b[p]]] = a[p];
    for (let j = count - 1; j >= 0; j--) {
      for (let k = firstLower[j]; k < firstLower[j + 1]; k++) other[--first[lower[k]]] = j;
    }
  }

  /**
   * Takes the pairs of two others: of the first without those of slots that are left out, and of the second each once.
   * @param leftOut - 1 for slots all of whose pairs stand in the second.
   */
  merge(count: number, kept: PairRows, leftOut: Uint8Array, added: PairRows): void {
    this.#reserve(count, kept.first[count] + added.first[count]);
    const { first, other } = this;
    let p = 0;
    for (let i = 0; i < count; i++) {
      first[i] = p;
      let n = kept.first[i];
      let k = added.first[i];
      const end = leftOut[i] === 1 ? n : kept.first[i + 1];
      const addedEnd = added.first[i + 1];
      while (n < end || k < addedEnd) {
        const isAdded = n === end || (k < addedEnd && added.other[k] < kept.other[n]);
        const j = isAdded ? added.other[k++] : kept.other[n++];
        if (isAdded ? p === first[i] || other[p - 1] !== j : leftOut[j] === 0) other[p++] = j;
      }
    }
    first[count] = p;
  }

  #reserve(count: number, pairs: number): void {
    if (this.first.length <= count) {
      this.first = new Int32Array(count * 2 + 1);
      this.#firstLower = new Int32Array(count * 2 + 1);
    }
    if (this.other.length < pairs) {
      this.other = new Int32Array(pairs * 2);
      this.#lower = new Int32Array(pairs * 2);
    }
  }
}
