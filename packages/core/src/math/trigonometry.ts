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

/** Sine. Within 1.5 units in the last place; beyond a million radians within half a unit of the angle's own last place. */
export function sin(angle: number): number {
  const reduced = angle > LARGE || angle < -LARGE ? angle % TAU : angle;
  const quarters = Math.floor(reduced / (TAU / 4) + 0.5);
  const r = remainder(reduced, quarters);
  return quadrant(quarters, sineNearZero(r), cosineNearZero(r));
}

/** Cosine. As exact as the sine. */
export function cos(angle: number): number {
  const reduced = angle > LARGE || angle < -LARGE ? angle % TAU : angle;
  const quarters = Math.floor(reduced / (TAU / 4) + 0.5);
  const r = remainder(reduced, quarters);
  return quadrant(quarters + 1, sineNearZero(r), cosineNearZero(r));
}

/** The sine of so many quarter turns and a rest whose sine and cosine are known. */
function quadrant(quarters: number, sine: number, cosine: number): number {
  const quadrant = quarters - 4 * Math.floor(quarters / 4); // 0 to 3
  const value = quadrant === 0 || quadrant === 2 ? sine : cosine;
  return quadrant < 2 ? value : -value;
}

function remainder(angle: number, quarters: number): number {
  return angle - quarters * QUARTER_HIGH - quarters * QUARTER_MIDDLE - quarters * QUARTER_LOW;
}

/** r - r³/3! + r⁵/5! - …, for |r| <= π/4: nine terms. */
function sineNearZero(r: number): number {
  const q = r * r;
  let series = 1;
  for (let n = 16; n >= 4; n -= 2) series = 1 - (series * q) / (n * (n + 1));
  return r - (r * q * series) / 6; // the greatest part stands alone: it has no error
}

/** 1 - r²/2! + r⁴/4! - …, for |r| <= π/4: nine terms. */
function cosineNearZero(r: number): number {
  const q = r * r;
  let series = 1;
  for (let n = 15; n >= 5; n -= 2) series = 1 - (series * q) / (n * (n + 1));
  const half = q / 2;
  const upper = 1 - half;
  return upper + (1 - upper - half + (q * q * series) / 24); // with what rounding took from the upper part
}
