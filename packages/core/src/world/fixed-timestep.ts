import {
  requireFunction,
  requireInteger,
  requireNonNegative,
  requireOptions,
  requirePositive,
} from '../math/checks.ts';

/** How a fixed timestep runs. */
export interface FixedTimestepOptions {
  /** Duration of each step. Unit: s. @default 1/60 */
  step?: number;
  /** Most steps in one call: what a slow frame asks for beyond them is dropped, not caught up with. @default 5 */
  maxSteps?: number;
}

/**
 * Turns frames of any length into steps of one length, so that physics does not depend on the display (G. Fiedler,
 * *Fix Your Timestep!*, 2004). It reads no clock: the game says how much time has passed.
 *
 * @example
 * ```ts
 * const clock = new FixedTimestep();
 * clock.advance(secondsSinceLastFrame, (dt) => world.step(dt));
 * renderer.render(world, camera, clock.alpha);
 * ```
 */
export class FixedTimestep {
  /** Duration of each step. Unit: s. */
  readonly step: number;
  /** Most steps in one call of `advance`. */
  readonly maxSteps: number;
  /** Time that came in and was not stepped over yet; below 0 by at most what is forgiven. */
  #pending = 0;
  #dropped = 0;

  constructor(options: FixedTimestepOptions = {}) {
    requireOptions('FixedTimestep', 'options', options, '{ step: 1 / 60 }');
    const { step = 1 / 60, maxSteps = 5 } = options;
    requirePositive('FixedTimestep', 'step', step, 'seconds');
    requireInteger('FixedTimestep', 'maxSteps', maxSteps, 1, 1000);
    this.step = step;
    this.maxSteps = maxSteps;
  }

  /**
   * Share of a step that has passed since the last one, 0 to below 1: where to draw between the last two states. It is 1
   * only after a step that threw and is still to come.
   */
  get alpha(): number {
    return Math.min(Math.max(0, this.#pending / this.step), 1);
  }

  /** Time that was dropped so far because frames were too slow. Unit: s. */
  get dropped(): number {
    return this.#dropped;
  }

  /**
   * Takes as many whole steps as the time that has passed asks for. When `takeStep` throws, that step does not count.
   * @param elapsed - Time since the last call, 0 or more. Unit: s.
   * @param takeStep - Called with the duration of the step, once for each.
   * @returns How many steps were taken.
   */
  advance(elapsed: number, takeStep: (dt: number) => void): number {
    requireNonNegative('FixedTimestep.advance', 'elapsed', elapsed, 'seconds', 'Pass the time since the last call.');
    requireFunction('FixedTimestep.advance', 'takeStep', takeStep, 'such as (dt) => world.step(dt)');
    this.#pending += elapsed;
    let steps = 0;
    // A sum of frame times misses a whole step by rounding alone: a millionth of a step is forgiven, and owed.
    while (this.#pending >= this.step * (1 - 1e-6) && steps < this.maxSteps) {
      takeStep(this.step);
      this.#pending -= this.step;
      steps++;
    }
    if (this.#pending >= this.step) {
      const kept = this.#pending % this.step;
      this.#dropped += this.#pending - kept;
      this.#pending = kept;
    }
    return steps;
  }

  /** Forgets time that is left over, as after a pause. */
  reset(): void {
    this.#pending = 0;
  }
}
