// What a game downloads: bundled by esbuild, minified, gzipped. `size` tells which files weigh most.
import { expect, it } from 'vitest';
import { sizeOf } from '../scripts/size.ts';

/** What each program of `scripts/size.ts` may weigh: what it weighs now and 2 %. Unit: kB. */
const limits: [string, number][] = [
  ['world', 13.5],
  ['fireworks', 15.8],
  ['pile', 25.1],
  ['rope', 24.3],
  ['camera', 1.15],
  ['all', 69.8],
];

it.each(limits)('%s is small', async (program, limit) => {
  const size = (await sizeOf(program)) / 1000;
  console.log(`${program}: ${size.toFixed(2)} kB minified and gzipped`);
  expect(size).toBeGreaterThan(0);
  expect(size).toBeLessThan(limit);
});
