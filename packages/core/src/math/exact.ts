/**
 * Logarithm, exponential and power from exactly specified arithmetic alone (+ - * /), so that every
 * JavaScript engine gives the same bits. ECMAScript leaves the last bits of `Math.log`, `Math.exp` and `Math.pow` to the
 * engine, which is why a step cannot use them.
 *
 * The reductions are the classical ones: a number is m·2^e with m near 1; ln m = 2·artanh((m - 1) / (m + 1)) as a series;
 * e^y = 2^k·e^r with |r| <= ln 2 / 2, and e^r as its Taylor series. ln 2 is split in two, so that k times its upper part
 * has no rounding error (W. J. Cody, W. Waite, *Software Manual for the Elementary Functions*, 1980).
 */

const LN2_HIGH = 6.9314718036912381649e-1; // the upper 33 bits of ln 2
const LN2_LOW = 1.90821492927058770002e-10; // ln 2 less its upper part
const SQRT2 = 1.4142135623730951;

/** 2 to the power of a whole number: exact, since each factor is. */
function powerOfTwo(exponent: number): number {
  let power = 1;
  for (let n = exponent; n > 0; n--) power *= 2;
  for (let n = exponent; n < 0; n++) power /= 2;
  return power;
}

/**
 * Natural logarithm; ln 0 is -Infinity, that of a negative number or of NaN is NaN. Within 1 unit in the last place.
 */
export function log(value: number): number {
  if (value === 0) return -Infinity;
  if (!(value > 0)) return NaN;
  if (value === Infinity) return Infinity;
  let mantissa = value; // value = mantissa·2^exponent with √2 / 2 < mantissa <= √2
  let exponent = 0;
  for (; mantissa > SQRT2; exponent++) mantissa /= 2;
  for (; mantissa <= SQRT2 / 2; exponent--) mantissa *= 2;
  const f = mantissa - 1; // exact, unlike s: so 2·s is written as f - f²/2 + s·f²/2, whose greatest part has no error
  const s = f / (2 + f);
  const q = s * s; // at most 0.0295: eleven terms reach the last bit
  let series = 1 / 23;
  for (let odd = 21; odd >= 3; odd -= 2) series = series * q + 1 / odd;
  const half = 0.5 * f * f;
  return exponent * LN2_HIGH - (half - (s * (half + 2 * q * series) + exponent * LN2_LOW) - f);
}

/** e to the power of a number; 0 when too small to be a number, Infinity when too large. Within 1.1 units in the last place. */
export function exp(value: number): number {
  if (value > 710) return Infinity;
  if (value < -746) return 0;
  const k = Math.floor(value / (LN2_HIGH + LN2_LOW) + 0.5);
  const r = value - k * LN2_HIGH - k * LN2_LOW;
  let series = 1;
  for (let n = 14; n >= 1; n--) series = 1 + (r / n) * series;
  const half = Math.floor(k / 2); // in two steps: 2^k itself may be too large or too small for a number
  return series * powerOfTwo(half) * powerOfTwo(k - half);
}

/**
 * `base` to the power of `exponent`, for `base` >= 0. Anything to the power 0 is 1, and so is 0 to the power 0.
 * Within 1.1 + 3·|exponent·ln base| units in the last place: the error of exp, and that of its argument, which it magnifies.
 */
export function pow(base: number, exponent: number): number {
  return exponent === 0 ? 1 : exp(exponent * log(base));
}
