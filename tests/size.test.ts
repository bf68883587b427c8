// What a game downloads: bundled by esbuild, minified, gzipped. `size` tells which files weigh most.
import { expect, it } from 'vitest';
import { sizeOf } from '../scripts/size.ts';

/** What each program of `scripts/size.ts` may weigh: what it weighs now and 2 %. Unit: kB. */
const limits: [string, number][] = [
  ['world', 12.3],
  ['fireworks', 14.6],
  ['pile', 22.4],
  ['rope', 19.7],
  ['camera', 1.15],
  ['all', 62.9],
];

it.each(limits)('%s is small', async (program, limit) => {
  const size = (await sizeOf(program)) / 1000;
  console.log(`${program}: ${size.toFixed(2)} kB minified and gzipped`);
  expect(size).toBeGreaterThan(0);
  expect(size).toBeLessThan(limit);
});
