/** A gap below this share of the radius is a touch: a tenth of the overlap that is allowed, and far above rounding. */
const SLACK = 1 / 0x2_0000_0000;

/** The same for points. Unit: m. */
const SLACK_OF_POINTS = 1e-12;

/** Two things with a smaller gap, as a share of the radius, may come to rest on each other within a step. */
const NEAR = 1e-4;

/** Of how many rests in one step the allowance grows. */
const MOST_GROWTH = 12;

/** A gap below this is a touch. Unit: m. */
export function slackOf(radius: number): number {
  return radius > 0 ? radius * SLACK : SLACK_OF_POINTS;
}

/**
 * How much deeper two things that touch and do not close may sink, by rounding or where they rest on a surface that curves
 * towards them, before they are brought to rest again: four times as deep each time within a step, so that this ends.
 * The position is corrected at the end of the step. Unit: m.
 */
export function allowanceOf(slack: number, rests: number): number {
  let allowance = slack;
  for (let r = Math.min(rests, MOST_GROWTH); r > 0; r--) allowance *= 4;
  return allowance;
}

/** Two with a smaller gap may come to rest on each other within a step. Unit: m. */
export function nearOf(radius: number): number {
  return radius > 0 ? radius * NEAR : SLACK_OF_POINTS;
}
