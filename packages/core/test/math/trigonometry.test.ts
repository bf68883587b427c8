import { describe, expect, it } from 'vitest';
import { Random } from '../../src/math/random.ts';
import { cos, sin } from '../../src/math/trigonometry.ts';

const BITS = 260n;
const ONE = 1n << BITS;
const view = new DataView(new ArrayBuffer(8));

/** A number with 260 bits after the point. */
function fixed(value: number): bigint {
  view.setFloat64(0, Math.abs(value));
  const word = view.getBigUint64(0);
  const exponent = Number((word >> 52n) & 0x7ffn) - 1075;
  const mantissa = (word & 0xfffffffffffffn) | 0x10000000000000n;
  const shift = BigInt(exponent) + BITS;
  const size = value === 0 ? 0n : shift >= 0n ? mantissa << shift : mantissa >> -shift;
  return value < 0 ? -size : size;
}

/** sin and cos to some 240 bits: the Taylor series of the angle over 2^40, doubled forty times. Independent of `Math`. */
function reference(angle: number): { sin: bigint; cos: bigint } {
  const r = fixed(angle) >> 40n;
  let [s, c] = [0n, 0n];
  let term = ONE;
  for (let n = 0n; term !== 0n && term !== -1n; n++) {
    const sign = n % 4n < 2n ? 1n : -1n;
    if (n % 2n === 0n) c += sign * term;
    else s += sign * term;
    term = ((term * r) >> BITS) / (n + 1n);
  }
  for (let i = 0; i < 40; i++) [s, c] = [(2n * s * c) >> BITS, ((c * c) >> BITS) - ((s * s) >> BITS)];
  return { sin: s, cos: c };
}

function inUlps(result: number, exact: bigint): number {
  view.setFloat64(0, Math.abs(result));
  const exponent = BigInt(Math.max(1, view.getUint16(0) >> 4) - 1075);
  const error = fixed(result) - exact;
  const scaled = ((error < 0n ? -error : error) << 20n) >> (BITS + exponent);
  return Number(scaled) / 2 ** 20;
}

function worst(make: () => number): number {
  let greatest = 0;
  for (let i = 0; i < 3000; i++) {
    const angle = make();
    const exact = reference(angle);
    greatest = Math.max(greatest, inUlps(sin(angle), exact.sin), inUlps(cos(angle), exact.cos));
  }
  return greatest;
}

describe('sine and cosine', () => {
  const random = new Random(5);

  it('the reference agrees with published digits of sin 1 and cos 1', () => {
    expect(inUlps(0.8414709848078965, reference(1).sin)).toBeLessThan(0.5);
    expect(inUlps(0.5403023058681398, reference(1).cos)).toBeLessThan(0.5);
    expect(inUlps(0.8414709848078966, reference(1).sin)).toBeGreaterThan(0.5);
  });

  it('are within one unit in the last place for angles of any size that matters', () => {
    expect(worst(() => random.between(-1, 1))).toBeLessThan(1);
    expect(worst(() => random.between(-10, 10))).toBeLessThan(1);
    expect(worst(() => random.between(-1e6, 1e6))).toBeLessThan(1);
  });

  it('are within one unit in the last place next to multiples of a quarter turn', () => {
    expect(worst(() => random.integer(-4000, 4000) * (Math.PI / 2) + random.between(-1e-9, 1e-9))).toBeLessThan(1);
    expect(worst(() => random.integer(-600_000, 600_000) * (Math.PI / 2))).toBeLessThan(1);
  });

  it('are 0 and 1 exactly at 0, and odd and even', () => {
    expect(sin(0)).toBe(0);
    expect(cos(0)).toBe(1);
    expect(sin(-1)).toBe(-sin(1));
    expect(cos(-1)).toBe(cos(1));
    expect(sin(Math.PI / 2)).toBe(1);
    expect(cos(Math.PI)).toBe(-1);
  });

  it('are still a sine and a cosine far out, and NaN of what is no angle', () => {
    for (const angle of [1e7, -3.3e9, 1e15, 1e300]) expect(sin(angle) ** 2 + cos(angle) ** 2).toBeCloseTo(1, 14);
    expect(Math.abs(sin(1e7) - Math.sin(1e7))).toBeLessThan(1e-9);
    expect(sin(Infinity)).toBeNaN();
    expect(cos(NaN)).toBeNaN();
  });
});
