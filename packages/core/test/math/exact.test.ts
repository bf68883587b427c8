import { describe, expect, it } from 'vitest';
import { exp, log, pow } from '../../src/math/exact.ts';
import { Random } from '../../src/math/random.ts';
import { expError, logError, powError } from './big-reference.ts';

const random = new Random(2024);

/** The greatest error over `count` arguments. */
function worst<T>(count: number, make: () => T, error: (argument: T) => number): number {
  let greatest = 0;
  for (let i = 0; i < count; i++) greatest = Math.max(greatest, error(make()));
  return greatest;
}

describe('the reference itself', () => {
  it('agrees with published digits of ln 2, ln 10, e and √2', () => {
    // Each constant is the double nearest to the number, so its error is at most half a unit in the last place.
    expect(logError(0.6931471805599453, 2)).toBeLessThan(0.5);
    expect(logError(2.302585092994046, 10)).toBeLessThan(0.5);
    expect(expError(2.718281828459045, 1)).toBeLessThan(0.5);
    expect(powError(1.4142135623730951, 2, 0.5)).toBeLessThan(0.5);
  });

  it('finds an error of one unit', () => {
    expect(expError(2.7182818284590455, 1)).toBeGreaterThan(0.5);
    expect(logError(0.6931471805599454, 2)).toBeGreaterThan(0.5);
  });
});

describe('log', () => {
  it.each([
    ['around 1', () => random.between(0.7, 1.5)],
    ['close to 1', () => 1 + random.between(-1e-3, 1e-3)],
    ['a damping', () => random.between(0.001, 1)],
    ['every magnitude, subnormals included', () => 2 ** random.between(-1074, 1023.99)],
  ])('[M1] is within 1 unit in the last place: %s', (_name, make) => {
    const error = (value: number) => (value === 1 ? Math.abs(log(value)) : logError(log(value), value));
    expect(worst(5000, make, error)).toBeLessThan(1);
  });

  it('[M1] is within 1 unit in the last place for the neighbours of 1', () => {
    for (let i = 1; i <= 500; i++) {
      expect(logError(log(1 + i * 2 ** -52), 1 + i * 2 ** -52)).toBeLessThan(1);
      expect(logError(log(1 - i * 2 ** -53), 1 - i * 2 ** -53)).toBeLessThan(1);
    }
  });

  it('[M1] has the special values of Math.log', () => {
    for (const value of [0, -0, 1, Infinity, -1, -Infinity, NaN, 5e-324, Number.MAX_VALUE, Number.MIN_VALUE * 3]) {
      expect(log(value)).toBe(Math.log(value));
    }
  });

  it('[M1] agrees with Math.log to 2 units in the last place', () => {
    const error = (value: number) => Math.abs(log(value) - Math.log(value)) / (Math.abs(Math.log(value)) * 2 ** -52);
    expect(worst(20_000, () => 2 ** random.between(-1074, 1023), error)).toBeLessThan(2);
  });
});

describe('exp', () => {
  it.each([
    ['around 0', () => random.between(-0.5, 0.5)],
    ['a hair from 0', () => random.between(-1e-9, 1e-9)],
    ['normal results', () => random.between(-708, 709.7)],
    ['subnormal results', () => random.between(-745, -708)],
  ])('[M2] is within 1.1 units in the last place: %s', (_name, make) => {
    expect(worst(5000, make, (value) => expError(exp(value), value))).toBeLessThan(1.1);
  });

  it('[M2] has the special values of Math.exp', () => {
    for (const value of [0, -0, Infinity, -Infinity, NaN, 710, -746, 709.7827128933841, -745.1332191019412]) {
      expect(exp(value)).toBe(Math.exp(value));
    }
  });

  it('[M2] reaches the greatest and the smallest numbers', () => {
    expect(exp(709.782712893384)).toBeGreaterThan(1.797e308);
    expect(exp(-745.13)).toBe(5e-324);
  });

  it('[M2] undoes log', () => {
    for (let i = 0; i < 2000; i++) {
      const value = 2 ** random.between(-20, 20);
      expect(Math.abs(exp(log(value)) - value)).toBeLessThan(value * 20 * 2 ** -52);
    }
  });
});

describe('pow', () => {
  it.each([
    ['damping over a step', () => [random.between(0, 1), random.between(0.001, 0.1)] as const],
    ['damping over a minute', () => [random.between(0.001, 1), random.between(1, 60)] as const],
    ['any base', () => [2 ** random.between(-100, 100), random.between(-5, 5)] as const],
  ])('[M3] is within 1.1 + 3·|exponent·ln base| units in the last place: %s', (_name, make) => {
    const share = ([base, exponent]: readonly [number, number]) =>
      powError(pow(base, exponent), base, exponent) / (1.1 + 3 * Math.abs(exponent * Math.log(base)));
    expect(worst(5000, make, share)).toBeLessThan(1);
  });

  it('[M3] anything to the power 0 is 1, 0 to the power 0 included', () => {
    for (const base of [0, -0, 1e-300, 0.5, 1, 7, Infinity, NaN]) expect(pow(base, 0)).toBe(1);
  });

  it('[M3] 0 to a positive power is 0, to a negative one Infinity; 1 to any power is 1', () => {
    for (const exponent of [5e-324, 1 / 60, 1, 1e300]) expect(pow(0, exponent)).toBe(0);
    expect(pow(0, -1)).toBe(Infinity);
    for (const exponent of [-1e300, 1 / 60, 1e300]) expect(pow(1, exponent)).toBe(1);
  });

  it('[M3] a base that is negative or NaN gives NaN, not a number out of nowhere', () => {
    expect(pow(NaN, 1 / 60)).toBeNaN();
    expect(pow(-0.5, 1 / 60)).toBeNaN();
  });

  it('[M3] overflows to Infinity and underflows to 0', () => {
    expect(pow(10, 400)).toBe(Infinity);
    expect(pow(10, -400)).toBe(0);
    expect(pow(0.5, 1074)).toBe(5e-324);
  });
});

it('[D4] the bits of log, exp and pow are these on every engine', () => {
  const bits = (value: number) => new BigUint64Array(new Float64Array([value]).buffer)[0].toString(16);
  expect({
    log: [0.99, 0.5, 3, 1e-310, 1e300].map((value) => bits(log(value))),
    exp: [-1 / 3, 1, 100, -744].map((value) => bits(exp(value))),
    pow: [0.99, 0.9, 0.5, 0.001].map((base) => bits(pow(base, 1 / 60))),
  }).toMatchInlineSnapshot(`
    {
      "exp": [
        "3fe6edd3122f2ea5",
        "4005bf0a8b14576a",
        "48f3494a9b171bf5",
        "2",
      ],
      "log": [
        "bf8495453e6fd4bc",
        "bfe62e42fefa39ef",
        "3ff193ea7aad030a",
        "c0864e69394d9508",
        "4085963447f87fb5",
      ],
      "pow": [
        "3feffea0bea600be",
        "3feff1a09d51966f",
        "3fefa1e827a1b38c",
        "3fec8520affa0a4b",
      ],
    }
  `);
});
