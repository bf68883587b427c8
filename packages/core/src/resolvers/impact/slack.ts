/** A gap below this share of the radius is a touch: a tenth of the overlap that is allowed, and far above rounding. */
const SLACK = 1 / 0x2_0000_0000;

/** The same for points. Unit: m. */
const SLACK_OF_POINTS = 1e-12;

/** Two things with a smaller gap, as a share of the radius, may come to rest on each other within a step. */
const NEAR = 1e-4;

/** Two with a smaller gap, as a share of the radius, may be pushed into each other where a crowd is separated. */
const NEAR_IN_CROWD = 0.1;

/** A gap below this is a touch. Unit: m. */
export function slackOf(radius: number): number {
  return radius > 0 ? radius * SLACK : SLACK_OF_POINTS;
}

/** Two with a smaller gap may come to rest on each other within a step, or in a crowd be pushed into each other. Unit: m. */
export function nearOf(radius: number, crowded: boolean): number {
  return radius > 0 ? radius * (crowded ? NEAR_IN_CROWD : NEAR) : SLACK_OF_POINTS;
}
