import type { Flight } from './flight.ts';
import { slackOf } from './slack.ts';

/** Closing slower than this counts as not closing. Unit: m/s. */
export const CLOSING_EPSILON = 1e-9;

/** Of how many rests in one step the allowance grows. */
const MOST_GROWTH = 12;

/** In a crowd two may sink into each other by this share of the radius at most. */
const DEEPEST = 0.25;

/**
 * When two that touch count as touching anew. At rest, moved by rounding alone, they would else do so again and again; and
 * so would what rests on a surface that curves towards it.
 */
export class Tolerance {
  /** A gap below this is a touch. Unit: m. */
  slack = 0;
  /** How much deeper they sink, where they do not close, before they touch again. Unit: m. */
  allowance = 0;
  /** Closing slower than this counts as not closing. Unit: m/s. */
  slowest = 0;

  /** Four times as much each time that a particle came to rest in this step, so that this ends; what sank is separated then. */
  set(radius: number, rests: number): void {
    this.slack = slackOf(radius);
    let growth = 1;
    for (let r = Math.min(rests, MOST_GROWTH); r > 0; r--) growth *= 4;
    this.allowance = this.slack * growth;
    this.slowest = CLOSING_EPSILON * growth;
  }

  /** In a crowd: what closes no faster than the acceleration of a step makes it waits for the end of the step. */
  yield({ duration, particles: { radius } }: Flight, i: number, stepSpeed: number): void {
    this.slowest = Math.max(this.slowest, stepSpeed);
    this.allowance = Math.max(this.allowance, Math.min(2 * stepSpeed * duration, radius[i] * DEEPEST));
  }
}
