/**
 * Logarithm and exponential to 200 bits by whole-number arithmetic: the truth that `exact.ts` is measured against, in
 * units in the last place. Independent of `Math.log` and `Math.exp`, whose last bits differ from engine to engine.
 */

const FRACTION_BITS = 200;
const ONE = 1n << BigInt(FRACTION_BITS);

const view = new DataView(new ArrayBuffer(8));

/** A positive, finite number as mantissa · 2^exponent, with a mantissa of 53 bits unless the number is subnormal. */
export function decompose(value: number): { mantissa: bigint; exponent: number } {
  view.setFloat64(0, value);
  const word = view.getBigUint64(0);
  const biased = Number((word >> 52n) & 0x7ffn);
  const fraction = word & 0xfffffffffffffn;
  return biased === 0
    ? { mantissa: fraction, exponent: -1074 }
    : { mantissa: fraction | (1n << 52n), exponent: biased - 1075 };
}

function shifted(value: bigint, places: number): bigint {
  return places >= 0 ? value << BigInt(places) : value >> BigInt(-places);
}

/** A finite number with 200 bits after the point. */
function fixed(value: number): bigint {
  const { mantissa, exponent } = decompose(Math.abs(value));
  const size = shifted(mantissa, exponent + FRACTION_BITS);
  return value < 0 ? -size : size;
}

/** 2·artanh(s) for a fixed-point s. */
function twiceArtanh(s: bigint): bigint {
  const q = (s * s) >> BigInt(FRACTION_BITS);
  let sum = 0n;
  let power = s;
  for (let odd = 1n; power !== 0n; odd += 2n) {
    sum += power / odd;
    power = (power * q) >> BigInt(FRACTION_BITS);
  }
  return 2n * sum;
}

const LN2 = twiceArtanh(ONE / 3n);

function lnFixed(value: number): bigint {
  const { mantissa, exponent } = decompose(value);
  const bits = mantissa.toString(2).length - 1;
  const m = shifted(mantissa, FRACTION_BITS - bits); // 1 <= m < 2
  return twiceArtanh(((m - ONE) << BigInt(FRACTION_BITS)) / (m + ONE)) + BigInt(exponent + bits) * LN2;
}

/** e^y as mantissa · 2^(k - 200). */
function expFixed(y: bigint): { mantissa: bigint; k: number } {
  const k = (2n * y + LN2) / (2n * LN2) - (2n * y + LN2 < 0n ? 1n : 0n);
  const r = y - k * LN2;
  let sum = 0n;
  let term = ONE;
  for (let n = 1n; term !== 0n && term !== -1n; n++) {
    sum += term;
    term = ((term * r) >> BigInt(FRACTION_BITS)) / n;
  }
  return { mantissa: sum, k: Number(k) };
}

/** The distance of two numbers of one fixed point, in units in the last place of a result. */
function inUlps(error: bigint, ulpExponent: number, point: number): number {
  const size = error < 0n ? -error : error;
  // Sixty bits below the ulp are plenty, and they fit a number.
  return Number(shifted(size, 60 - (ulpExponent + point))) / 2 ** 60;
}

/** How far `result` is from ln `value`, in units in the last place of `result`. */
export function logError(result: number, value: number): number {
  return inUlps(fixed(result) - lnFixed(value), decompose(Math.abs(result)).exponent, FRACTION_BITS);
}

/** How far `result` is from e^`value`, in units in the last place of `result`. */
export function expError(result: number, value: number): number {
  return expFixedError(result, fixed(value));
}

/** How far `result` is from `base`^`exponent`, in units in the last place of `result`. */
export function powError(result: number, base: number, exponent: number): number {
  return expFixedError(result, (lnFixed(base) * fixed(exponent)) >> BigInt(FRACTION_BITS));
}

function expFixedError(result: number, y: bigint): number {
  const { mantissa, k } = expFixed(y);
  const { mantissa: m, exponent } = decompose(result);
  // Both over 2^(k - 200).
  return inUlps(shifted(m, exponent - (k - FRACTION_BITS)) - mantissa, exponent, FRACTION_BITS - k);
}
