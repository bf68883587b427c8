import type { GapPath } from './gap-path.ts';
import type { Tolerance } from './tolerance.ts';

/** Most looks at a path that cannot be passed over in one go. */
const MOST_STRIDES = 4096;

/** Bisections and Newton steps until a time is found to the last bit; a bracket halves at least every other time. */
const MOST_ROUNDS = 128;

/**
 * When two things that come near each other touch first, by conservative advancement (B. Mirtich and J. Canny, *Impulse-based
 * dynamic simulation*, 1994): within the time that the gap takes to close at the greatest speed they cannot touch. Near each
 * other, where this would take ever smaller strides, they advance by `stride`, a part of their size, and look: a gap that is
 * negative brackets the touch, one that was closing fast enough and now opens brackets its least. A bracket is narrowed by Newton's method,
 * and by halving where that leaves it, down to the last bit.
 *
 * Where they touch already the answer is now if they close, and else the time at which they will be in each other by more than
 * the tolerance allows.
 * @param speed - Bound of how fast the gap can close. Unit: m/s.
 * @param duration - How far ahead to look. Unit: s.
 * @returns The time from now, or `Infinity`. Unit: s.
 */
export function firstTouch(
  path: GapPath,
  speed: number,
  duration: number,
  stride: number,
  tolerance: Tolerance,
): number {
  path.at(0);
  if (path.gap > speed * duration || speed === 0) return Infinity;
  const level = touchLevel(path.gap, path.rate, tolerance);
  if (level === Infinity) return 0;
  const shortest = Math.max(stride, (speed * duration) / MOST_STRIDES);
  let time = 0;
  let gap = path.gap - level;
  let rate = path.rate;
  while (time < duration) {
    const next = Math.min(duration, time + Math.max(gap, shortest) / speed);
    path.at(next);
    const nextGap = path.gap - level;
    const nextRate = path.rate;
    if (nextGap === Infinity) return Infinity;
    if (nextGap < 0) return findTouch(path, level, time, next);
    if (gap < shortest && gap < rate * (time - next) && nextRate > 0) {
      const nearest = findNearest(path, time, next);
      path.at(nearest);
      if (path.gap < level) return findTouch(path, level, time, nearest);
    }
    time = next;
    gap = nextGap;
    rate = nextRate;
  }
  return Infinity;
}

/** The gap at which two things touch that are `gap` apart now, or `Infinity` where they do so now. Unit: m. */
export function touchLevel(gap: number, rate: number, { slack, allowance, slowest }: Tolerance): number {
  if (gap > slack) return 0;
  return rate < -slowest ? Infinity : Math.min(gap, 0) - allowance;
}

/** Where the gap falls to `level`, between a time when it is above and one when it is below. */
function findTouch(path: GapPath, level: number, above: number, below: number): number {
  let time = below;
  let stride = below - above;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    path.at(time);
    const gap = path.gap - level;
    if (gap >= 0) above = time;
    else below = time;
    const newton = time - gap / path.rate;
    const trusted = newton > above && newton < below && Math.abs(newton - time) < stride / 2;
    const next = trusted ? newton : above + (below - above) / 2;
    stride = Math.abs(next - time);
    if (stride <= 1e-16 * next || next === above || next === below) return next;
    time = next;
  }
  return time;
}

/** Where the gap is least, between a time when it closes and one when it opens. */
function findNearest(path: GapPath, closing: number, opening: number): number {
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const middle = closing + (opening - closing) / 2;
    if (middle === closing || middle === opening) break;
    path.at(middle);
    if (path.rate < 0) closing = middle;
    else opening = middle;
  }
  return opening;
}
