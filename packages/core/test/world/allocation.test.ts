import { execFile } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { describe, expect, it } from 'vitest';

const script = fileURLToPath(new URL('allocation-run.ts', import.meta.url));

/** Bytes that a step of a scene allocates, on the heap and in buffers. */
async function measure(scene: string): Promise<{ bytesPerStep: number; bufferBytes: number }> {
  const { stdout } = await promisify(execFile)(process.execPath, [
    '--expose-gc',
    '--min-semi-space-size=64', // megabytes: nothing is collected while it counts
    '--max-semi-space-size=64',
    '--no-warnings',
    script,
    scene,
  ]);
  return JSON.parse(stdout);
}

describe('after warm-up', () => {
  // V8 boxes a number that crosses a call which it does not inline, 16 bytes each: a few of those, whatever the number of
  // particles, and what the process does beside, is all that may be left.
  it.each([
    ['flight', '10 000 particles with gravity, drag, two dampings and a force over the arrays'],
    ['particles', 'a force that is called for each particle, under a fixed timestep'],
    ['dampings', '10 000 particles with as many dampings'],
  ])('[W9] a step allocates nothing: %s, %s', { timeout: 120_000 }, async (scene) => {
    const { bytesPerStep, bufferBytes } = await measure(scene);
    expect(bytesPerStep).toBeLessThan(40);
    expect(bytesPerStep).toBeGreaterThan(-16); // nothing was collected meanwhile
    expect(bufferBytes).toBe(0);
  });

  it.each([
    ['links', '200 contacts of links'],
    ['contacts', 'some 250 contacts of discs and shapes, with a listener'],
  ])('[W9] a contact costs a few boxed numbers a step and no object: %s, %s', { timeout: 120_000 }, async (scene) => {
    const { bytesPerStep, bufferBytes } = await measure(scene);
    expect(bytesPerStep).toBeLessThan(200 * 64);
    expect(bufferBytes).toBe(0);
  });

  it('[W9] fireworks that burst all the time allocate a few boxed numbers for each spark that is born', {
    timeout: 120_000,
  }, async () => {
    const { bytesPerStep, bufferBytes } = await measure('fireworks');
    expect(bytesPerStep).toBeLessThan(100 * 102); // 2 rockets and 100 sparks are born in each step
    expect(bufferBytes).toBe(0);
  });
});
