/**
 * Sine and cosine of an angle in radians from exactly specified arithmetic alone, so that every JavaScript engine gives the
 * same bits; ECMAScript leaves the last bits of `Math.sin` and `Math.cos` to the engine.
 *
 * The angle is brought to within a quarter of π by taking away whole quarter turns, with π/2 in three parts so that the
 * multiples of the first two have no rounding error (W. J. Cody, W. Waite, *Software Manual for the Elementary Functions*,
 * 1980; the parts are those of fdlibm). There the Taylor series reach the last bit.
 */

const QUARTER_HIGH = 1.57079632673412561417; // the upper 33 bits of π/2
const QUARTER_MIDDLE = 6.0771005063039659766e-11; // the next 33 bits
const QUARTER_LOW = 2.02226624879595063154e-21; // π/2 less both
const TAU = 6.283185307179586;

/** Beyond it whole turns are taken away first: the number of quarter turns must have no more than 20 bits. */
const LARGE = 1e6;

/** Sine. Within 1 unit in the last place; beyond a million radians within half a unit of the angle's own last place. */
export function sin(angle: number): number {
  return sineAfterQuarters(angle, 0);
}

/** Cosine. As exact as the sine. */
export function cos(angle: number): number {
  return sineAfterQuarters(angle, 1);
}

/** The sine of an angle and so many quarter turns. */
function sineAfterQuarters(angle: number, more: number): number {
  const near = angle > LARGE || angle < -LARGE ? angle % TAU : angle;
  const quarters = Math.floor(near / (TAU / 4) + 0.5);
  const upper = near - quarters * QUARTER_HIGH;
  const lower = quarters * QUARTER_MIDDLE;
  const most = upper - lower;
  const less = upper - most - lower - quarters * QUARTER_LOW;
  const r = most + less;
  const rest = most - r + less; // what does not fit into r
  const quadrant = quarters + more - 4 * Math.floor((quarters + more) / 4); // 0 to 3
  const value = quadrant === 0 || quadrant === 2 ? sineNearZero(r, rest) : cosineNearZero(r, rest);
  return quadrant < 2 ? value : -value;
}

/** sin(r + rest) = r - r³/3! + r⁵/5! - … + rest·cos r, for |r| <= π/4: nine terms. */
function sineNearZero(r: number, rest: number): number {
  const q = r * r;
  let series = 1;
  for (let n = 16; n >= 4; n -= 2) series = 1 - (series * q) / (n * (n + 1));
  return r - ((r * q * series) / 6 - rest * (1 - q / 2)); // the greatest part stands alone: it has no error
}

/** cos(r + rest) = 1 - r²/2! + r⁴/4! - … - rest·sin r, for |r| <= π/4: nine terms. */
function cosineNearZero(r: number, rest: number): number {
  const q = r * r;
  let series = 1;
  for (let n = 15; n >= 5; n -= 2) series = 1 - (series * q) / (n * (n + 1));
  const half = q / 2;
  const upper = 1 - half;
  return upper + (1 - upper - half + ((q * q * series) / 24 - r * rest)); // with what rounding took from the upper part
}
