import { execFile } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { expect, it } from 'vitest';

const script = fileURLToPath(new URL('allocation-run.ts', import.meta.url));

// V8 boxes a number that crosses a call which it does not inline, 16 bytes each: some for each look at a path.
it.each([
  ['gas', 4000],
  ['billiards', 4000],
  ['pile', 60_000],
])('[I29] after warm-up a step makes no object and no array: %s', { timeout: 120_000 }, async (scene, most) => {
  const { stdout } = await promisify(execFile)(process.execPath, [
    '--expose-gc',
    '--min-semi-space-size=64', // megabytes: nothing is collected while it counts
    '--max-semi-space-size=64',
    '--no-warnings',
    script,
    scene,
  ]);
  const { bytesPerStep, bufferBytes } = JSON.parse(stdout);
  expect(bytesPerStep).toBeLessThan(most);
  expect(bufferBytes).toBe(0);
});
