import { Fireworks } from '@mass/core';
import { BURST, DROP, EMBER, SPARK, SPLASH } from './groups.ts';

const within = (x: number, y: number) => ({ minVelocity: { x: -x, y: -y }, maxVelocity: { x, y } });

/** What flies when something is hit: a burst into sparks and embers, or, from water, a splash. Chance comes from the seed. */
export function sparksOf(seed: number): Fireworks {
  return new Fireworks({
    seed,
    rules: [
      {
        ...{ type: BURST, ...within(0, 0), minAge: 0.01, maxAge: 0.015, damping: 1 },
        payloads: [
          { type: SPARK, count: 26 },
          { type: EMBER, count: 18 },
        ],
      },
      { type: SPARK, ...within(7, 7), minAge: 0.25, maxAge: 0.7, damping: 0.25, mass: 0.01 },
      {
        type: EMBER,
        minVelocity: { x: -4, y: -1 },
        maxVelocity: { x: 4, y: 7 },
        minAge: 0.5,
        maxAge: 1.2,
        damping: 0.5,
      },
      {
        ...{ type: SPLASH, ...within(0, 0), minAge: 0.01, maxAge: 0.015, damping: 1 },
        payloads: [{ type: DROP, count: 16 }],
      },
      { type: DROP, minVelocity: { x: -2, y: 1 }, maxVelocity: { x: 2, y: 5 }, minAge: 0.4, maxAge: 0.9, damping: 0.7 },
    ],
  });
}
