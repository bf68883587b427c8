import { Random } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { thrownBy } from '../helpers.ts';

/** sfc32 seeded by splitmix32, in whole numbers of any size and modulo 2³²: slow, and independent of integer tricks. */
function* reference(seed: number): Generator<number> {
  const mask = 0xffffffffn;
  let mix = BigInt(seed);
  const state: bigint[] = [];
  for (let i = 0; i < 3; i++) {
    mix = (mix + 0x9e3779b9n) & mask;
    let bits = ((mix ^ (mix >> 16n)) * 0x21f0aaadn) & mask;
    bits = ((bits ^ (bits >> 15n)) * 0x735a2d97n) & mask;
    state.push(bits ^ (bits >> 15n));
  }
  let [a, b, c] = state;
  let counter = 1n;
  for (let i = 0; ; i++) {
    const out = (a + b + counter) & mask;
    counter = (counter + 1n) & mask;
    a = b ^ (b >> 9n);
    b = (c + (c << 3n)) & mask;
    c = (((c << 21n) | (c >> 11n)) + out) & mask;
    if (i >= 12) yield Number(out) / 2 ** 32;
  }
}

describe('Random', () => {
  it.each([0, 1, 2, 42, 0x7fffffff, 0x80000000, 0xffffffff])('[M5] is sfc32 seeded by splitmix32: seed %i', (seed) => {
    const random = new Random(seed);
    const expected = reference(seed);
    for (let i = 0; i < 1000; i++) expect(random.next()).toBe(expected.next().value);
  });

  it('[D4] the first numbers of seed 1, the default, are these', () => {
    const random = new Random();
    expect([random.next(), random.next(), random.next(), random.next()]).toMatchInlineSnapshot(`
      [
        0.5636717735324055,
        0.5851113414391875,
        0.8959073920268565,
        0.9463990409858525,
      ]
    `);
  });

  it('[M5] the same seed gives the same numbers, another seed others', () => {
    const numbers = (seed: number) =>
      Array.from(
        { length: 20 },
        (
          (r) => () =>
            r.next()
        )(new Random(seed)),
      );
    expect(numbers(7)).toEqual(numbers(7));
    expect(numbers(7)).not.toEqual(numbers(8));
  });

  it('[M5] numbers run from 0 to below 1 and spread evenly over 100 classes', () => {
    const random = new Random(99);
    const classes = new Array<number>(100).fill(0);
    const draws = 100_000;
    for (let i = 0; i < draws; i++) {
      const value = random.next();
      expect(value >= 0 && value < 1).toBe(true);
      classes[Math.floor(value * 100)]++;
    }
    const expected = draws / 100;
    const chiSquare = classes.reduce((sum, n) => sum + (n - expected) ** 2 / expected, 0);
    // 99 degrees of freedom: outside of 56 to 156 once in five thousand seeds.
    expect(chiSquare).toBeGreaterThan(56);
    expect(chiSquare).toBeLessThan(156);
  });

  it('[M5] successive numbers do not depend on each other: pairs spread evenly over 20 by 20 classes', () => {
    const random = new Random(5);
    const classes = new Array<number>(400).fill(0);
    const draws = 80_000;
    for (let i = 0; i < draws; i++) classes[Math.floor(random.next() * 20) * 20 + Math.floor(random.next() * 20)]++;
    const chiSquare = classes.reduce((sum, n) => sum + (n - draws / 400) ** 2 / (draws / 400), 0);
    // 399 degrees of freedom, deviation 28: four deviations.
    expect(Math.abs(chiSquare - 399)).toBeLessThan(4 * Math.sqrt(2 * 399));
  });

  it('[M5] neighbouring seeds give unrelated numbers', () => {
    const count = 2000;
    for (const draw of [0, 1, 5]) {
      let sum = 0;
      let products = 0;
      let previous = 0.5;
      for (let seed = 0; seed < count; seed++) {
        const random = new Random(seed);
        for (let i = 0; i < draw; i++) random.next();
        const value = random.next();
        sum += value;
        products += (value - 0.5) * (previous - 0.5);
        previous = value;
      }
      // Mean 1/2 with deviation 1/√12n; products have mean 0 and deviation √n/12: four deviations each.
      expect(Math.abs(sum / count - 0.5)).toBeLessThan(4 / Math.sqrt(12 * count));
      expect(Math.abs(products)).toBeLessThan((4 * Math.sqrt(count)) / 12);
    }
  });

  it('[M6] between stays in its range, and is min where the two are equal', () => {
    const random = new Random(3);
    for (let i = 0; i < 10_000; i++) {
      const value = random.between(-3, 5);
      expect(value >= -3 && value < 5).toBe(true);
    }
    expect(random.between(2, 2)).toBe(2);
  });

  it('[M6] integer reaches both ends, each number equally often', () => {
    const random = new Random(3);
    const seen = new Map<number, number>();
    for (let i = 0; i < 60_000; i++) {
      const value = random.integer(-2, 3);
      seen.set(value, (seen.get(value) ?? 0) + 1);
    }
    expect([...seen.keys()].sort((a, b) => a - b)).toEqual([-2, -1, 0, 1, 2, 3]);
    for (const n of seen.values()) expect(Math.abs(n - 10_000)).toBeLessThan(4 * Math.sqrt(10_000));
    expect(random.integer(4, 4)).toBe(4);
  });

  it('[M6] integer spans all 32 bits', () => {
    const random = new Random(3);
    for (let i = 0; i < 1000; i++) {
      const value = random.integer(-0x8000_0000, 0x7fff_ffff);
      expect(Number.isInteger(value) && value >= -0x8000_0000 && value <= 0x7fff_ffff).toBe(true);
    }
  });

  it('[X1] a range whose ends are swapped, or whose width is no number, is an error', () => {
    const random = new Random();
    expect(() => random.between(5, 1)).toThrow(/^Random\.between: .* 5; got 1\. Swap them\.$/);
    expect(() => random.between(-1.7e308, 1.7e308)).toThrow(/^Random\.between: max - min must be a finite number/);
    expect(() => random.integer(3, 2)).toThrow(/^Random\.integer: max must be a whole number from 3 /);
  });

  it('[X1] an error uses up no number', () => {
    const random = new Random(11);
    thrownBy(() => random.between(NaN, 1));
    thrownBy(() => random.integer(0.5, 1));
    expect(random.next()).toBe(new Random(11).next());
  });
});
