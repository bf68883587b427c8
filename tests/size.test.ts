// What a game downloads: bundled by esbuild, minified, gzipped.
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { expect, it } from 'vitest';
import { root } from '../scripts/run.ts';

const kilobyte = 1000;

/** The size of a program after minification and gzip, in bytes. */
async function sizeOf(program: string): Promise<number> {
  const { outputFiles } = await build({
    stdin: { contents: program, resolveDir: root, loader: 'ts' },
    bundle: true,
    minify: true,
    format: 'esm',
    target: 'es2022',
    write: false,
    logLevel: 'error',
  });
  return gzipSync(outputFiles[0].contents, { level: 9 }).length;
}

/** Programs that a game might be, and what each may weigh: what it weighs now and a little. Unit: kB. */
const programs: [string, string, number][] = [
  ['all of @mass/core', "export * from '@mass/core';", 37],
  ['fireworks', "export { Drag, Fireworks, FixedTimestep, Gravity, World } from '@mass/core';", 13],
  ['a pile of discs', "export { DiscContacts, HalfPlane, World } from '@mass/core';", 11.6],
  ['a rope', "export { rod, World } from '@mass/core';", 11.5],
];

it.each(programs)('%s is small', async (name, program, limit) => {
  const size = await sizeOf(program);
  console.log(`${name}: ${(size / kilobyte).toFixed(2)} kB minified and gzipped`);
  expect(size).toBeGreaterThan(0);
  expect(size).toBeLessThan(limit * kilobyte);
});

it('a game pays only for what it imports', async () => {
  const all = await sizeOf("export * from '@mass/core';");
  const one = await sizeOf("export { Camera } from '@mass/core/view';");
  const world = await sizeOf("export { World } from '@mass/core';");
  console.log(`World alone: ${(world / kilobyte).toFixed(2)} kB, the camera alone: ${(one / kilobyte).toFixed(2)} kB`);
  expect(world).toBeLessThan(all);
  expect(one).toBeLessThan(all / 2);
});
