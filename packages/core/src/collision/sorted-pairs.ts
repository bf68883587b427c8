import { PairBuffer } from './pair-buffer.ts';

/** Pairs of slots, lower slot first, sorted by the lower slot, then by the higher. */
export class SortedPairs extends PairBuffer {
  /** Where the pairs of each slot begin, as the lower and as the higher; and the lower slots by the higher. */
  #first = new Int32Array(0);
  #firstLower = new Int32Array(0);
  #lower = new Int32Array(0);

  /** Takes pairs, lower slot first, and sorts them by counting, first by the higher slot, then by the lower. */
  sort(slots: number, { a, b, count }: PairBuffer): void {
    this.count = 0;
    this.reserve(count);
    this.count = count;
    if (this.#first.length <= slots) {
      this.#first = new Int32Array(slots * 2 + 1);
      this.#firstLower = new Int32Array(slots * 2 + 1);
    }
    if (this.#lower.length < count) this.#lower = new Int32Array(count * 2);
    const lower = this.#lower;
    const first = this.#first.fill(0, 0, slots + 1);
    const firstLower = this.#firstLower.fill(0, 0, slots + 1);
    for (let p = 0; p < count; p++) {
      first[a[p]]++;
      firstLower[b[p]]++;
    }
    let sum = 0;
    let sumLower = 0;
    for (let i = 0; i <= slots; i++) {
      sum += first[i];
      first[i] = sum;
      sumLower += firstLower[i];
      firstLower[i] = sumLower;
    }
    for (let p = 0; p < count; p++) lower[--firstLower[b[p]]] = a[p];
    const { a: sortedA, b: sortedB } = this;
    for (let j = slots - 1; j >= 0; j--) {
      for (let k = firstLower[j]; k < firstLower[j + 1]; k++) {
        const p = --first[lower[k]];
        sortedA[p] = lower[k];
        sortedB[p] = j;
      }
    }
  }

  /**
   * Takes the pairs of two others: of the first without those of slots that are left out, and of the second each once.
   * @param leftOut - 1 for slots all of whose pairs stand in the second.
   */
  merge(kept: SortedPairs, leftOut: Uint8Array, added: SortedPairs): void {
    this.count = 0;
    this.reserve(kept.count + added.count + 1);
    const { a, b } = this;
    const { a: keptA, b: keptB, count } = kept;
    let p = 0;
    let k = 0;
    let nextA = added.firstOf(k);
    for (let n = 0; n < count; n++) {
      const i = keptA[n];
      const j = keptB[n];
      for (; nextA < i || (nextA === i && added.b[k] < j); nextA = added.firstOf(++k))
        p = this.#put(p, nextA, added.b[k]);
      a[p] = i;
      b[p] = j;
      p += 1 - (leftOut[i] | leftOut[j]); // written over where it is left out
    }
    for (; k < added.count; k++) p = this.#put(p, added.a[k], added.b[k]);
    this.count = p;
  }

  /** The lower slot of a pair; after the last, one that is higher than all. */
  firstOf(p: number): number {
    return p < this.count ? this.a[p] : 0x7fff_ffff;
  }

  /** Writes a pair unless it is that before. Returns where the next goes. */
  #put(p: number, i: number, j: number): number {
    if (p > 0 && this.a[p - 1] === i && this.b[p - 1] === j) return p;
    this.a[p] = i;
    this.b[p] = j;
    return p + 1;
  }
}
