import { requireFinite, requireInteger, requireOrdered } from './checks.ts';

/**
 * Seeded random numbers: the same seed gives the same numbers in every JavaScript engine.
 *
 * The generator is sfc32 (C. Doty-Humphrey, *PractRand*, 2010): 128 bits of state, integer arithmetic only. The seed is
 * spread over the state by splitmix32, so that neighbouring seeds give unrelated numbers.
 */
export class Random {
  readonly #state = new Uint32Array(4);

  /** @param seed - A whole number, 0 to 2³² - 1. @default 1 */
  constructor(seed = 1) {
    requireInteger('Random', 'seed', seed, 0, 0xffffffff);
    let mix = seed;
    for (let i = 0; i < 3; i++) {
      mix = (mix + 0x9e3779b9) | 0;
      let bits = Math.imul(mix ^ (mix >>> 16), 0x21f0aaad);
      bits = Math.imul(bits ^ (bits >>> 15), 0x735a2d97);
      this.#state[i] = bits ^ (bits >>> 15);
    }
    this.#state[3] = 1;
    for (let i = 0; i < 12; i++) this.#next32();
  }

  /** The next number, from 0 (included) to 1 (excluded), on a grid of 2⁻³². */
  next(): number {
    return this.#next32() / 0x1_0000_0000;
  }

  /** A number from `min` to `max`; `max` itself comes only by rounding, or where the two are equal. */
  between(min: number, max: number): number {
    requireFinite('Random.between', 'min', min, '');
    requireFinite('Random.between', 'max', max, '');
    requireOrdered('Random.between', 'number', min, max, '');
    requireFinite('Random.between', 'max - min', max - min, '');
    return min + (max - min) * this.next();
  }

  /** A whole number from `min` to `max`, both included. */
  integer(min: number, max: number): number {
    requireInteger('Random.integer', 'min', min, -0x8000_0000, 0x7fff_ffff);
    requireInteger('Random.integer', 'max', max, min, 0x7fff_ffff);
    return min + Math.floor(this.next() * (max - min + 1));
  }

  #next32(): number {
    const s = this.#state;
    const out = (s[0] + s[1] + s[3]) >>> 0;
    s[3] += 1;
    s[0] = s[1] ^ (s[1] >>> 9);
    s[1] = s[2] + (s[2] << 3);
    s[2] = ((s[2] << 21) | (s[2] >>> 11)) + out;
    return out;
  }
}
