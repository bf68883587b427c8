/** How fast a stage runs, smoothed so that it can be read. */
export class Statistics {
  /** Frames drawn so far. */
  frames = 0;
  #frameTime = 0;
  #stepTime = 0;

  /** Unit: 1/s; 0 while nothing moves. */
  get framesPerSecond(): number {
    return this.#frameTime > 0 ? 1 / this.#frameTime : 0;
  }

  /** What one step costs. Unit: ms. */
  get stepMs(): number {
    return this.#stepTime * 1000;
  }

  /** Takes note of a frame. Units: s. */
  frame(elapsed: number, steps: number, spent: number): void {
    this.frames++;
    this.#frameTime = smooth(this.#frameTime, elapsed);
    if (steps > 0) this.#stepTime = smooth(this.#stepTime, spent / steps);
  }

  /** Nothing moves any more: the next frame starts afresh. */
  rest(): void {
    this.#frameTime = 0;
  }
}

function smooth(before: number, now: number): number {
  return before === 0 ? now : before + (now - before) * 0.08;
}
