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

it('all of @mass/core is smaller than 10 kB', async () => {
  const size = await sizeOf("export * from '@mass/core';");
  console.log(`@mass/core: ${(size / kilobyte).toFixed(2)} kB minified and gzipped`);
  expect(size).toBeGreaterThan(0);
  expect(size).toBeLessThan(10 * kilobyte);
});

it('a game pays only for what it imports', async () => {
  const all = await sizeOf("export * from '@mass/core';");
  const one = await sizeOf("export { Camera } from '@mass/core/view';");
  const world = await sizeOf("export { World } from '@mass/core';");
  console.log(`World alone: ${(world / kilobyte).toFixed(2)} kB, the camera alone: ${(one / kilobyte).toFixed(2)} kB`);
  expect(world).toBeLessThan(all);
  expect(one).toBeLessThan(all / 2);
});
