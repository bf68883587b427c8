import { type Resolver, severity, World } from '@mass/core';
import type { Guide, Scene } from './scene.ts';
import { wrongResolver } from './wrong-resolver.ts';

const rows = [2.6, 0, -2.9];
const middle = 0.2;
const radiusOf = (mass: number): number => (mass === Infinity ? 1.2 : 0.6 * Math.cbrt(mass));

/** As printed: the sign is reversed, and both go the same way. */
const asPrinted = wrongResolver({ moves: (a, b) => [-a / (a + b), -b / (a + b)] });

/** Three pairs of discs, `depth` inside each other; of the depth that is left, `share` is resolved in each step. */
function pairs(resolver: Resolver, masses: readonly number[], { depth, share }: { depth: number; share: number }) {
  const world = new World({ resolver });
  const all = masses.map((mass, row) => {
    const gap = radiusOf(1) + radiusOf(mass) - depth;
    const start = [middle - radiusOf(1) + depth / 2, middle - radiusOf(1) + depth / 2 + gap];
    const [a, b] = [1, mass].map((kilograms, n) =>
      world.addParticle({
        ...{ x: start[n], y: rows[row], mass: kilograms, radius: radiusOf(kilograms), damping: 0.01 },
        group: kilograms === Infinity ? 2 : n,
      }),
    );
    return { a, b, mass, start, end: [start[0] - (depth * mass) / (1 + mass), start[1] + depth / (1 + mass)] };
  });
  return { world, all };
}
