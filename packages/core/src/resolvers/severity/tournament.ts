/**
 * Which of n numbers is the smallest, as a tournament: the winner of each pair meets the winner of the next. Finding the
 * smallest costs nothing, changing a number costs log n. Of equal ones the lowest index wins.
 */
export class Tournament {
  /** The numbers, by index. After writing one call `update`. */
  keys: Float64Array = new Float64Array(1);
  #winners = new Int32Array(2);
  #size = 1;

  /** The index of the smallest number. */
  get winner(): number {
    return this.#winners[1];
  }

  /** Makes room for `count` numbers; those are to be written before `start`. */
  resize(count: number): void {
    let size = 1;
    while (size < count) size *= 2;
    if (size > this.keys.length) {
      this.keys = new Float64Array(size);
      this.#winners = new Int32Array(size * 2);
    }
    this.#size = size;
    this.keys.fill(Infinity, count, size);
  }

  /** Plays all rounds. */
  start(): void {
    const winners = this.#winners;
    const keys = this.keys;
    const size = this.#size;
    for (let i = 0; i < size; i++) winners[size + i] = i;
    for (let node = size - 1; node >= 1; node--) {
      const left = winners[node * 2];
      const right = winners[node * 2 + 1];
      winners[node] = keys[left] <= keys[right] ? left : right;
    }
  }

  /** Plays again the rounds that a changed number takes part in, as far as they come out differently. */
  update(index: number): void {
    const winners = this.#winners;
    const keys = this.keys;
    for (let node = (this.#size + index) >> 1; node >= 1; node >>= 1) {
      const left = winners[node * 2];
      const right = winners[node * 2 + 1];
      const winner = keys[left] <= keys[right] ? left : right;
      if (winner === winners[node] && winner !== index) return;
      winners[node] = winner;
    }
  }
}
