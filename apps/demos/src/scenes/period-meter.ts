/** Measures how long one swing takes, from the moments at which a value rises through its middle. */
export class PeriodMeter {
  #first = Number.NaN;
  #last = Number.NaN;
  #swings = 0;
  #time = Number.NaN;
  #value = 0;

  /** Looks at the value at a time, measured from the middle of the swing. Unit of time: s. */
  add(time: number, value: number): void {
    if (this.#value < 0 && value >= 0) {
      const share = this.#value / (this.#value - value);
      this.#last = this.#time + share * (time - this.#time);
      if (Number.isNaN(this.#first)) this.#first = this.#last;
      else this.#swings++;
    }
    this.#time = time;
    this.#value = value;
  }

  /** The mean of all whole swings so far; NaN before there is one. Unit: s. */
  get period(): number {
    return (this.#last - this.#first) / this.#swings;
  }
}
