/** Counts the bytes that steps under the impact resolver allocate: see `test/world/allocation-run.ts`. */
import { getHeapStatistics } from 'node:v8';
import type { World } from '@mass/core';
import { breakShot, gas, pile } from './scenes.ts';

const STEPS = 500;

const scenes: Record<string, () => World> = {
  gas: () => gas(20, 3),
  billiards: () => breakShot(8, 1).world,
  pile: () => pile(20, 0.5, 5),
};

const world = scenes[process.argv[2]]();
for (let step = 0; step < 2000; step++) world.step(1 / 60);
let best = { bytesPerStep: Infinity, bufferBytes: 0 };
for (let round = 0; round < 8; round++) {
  globalThis.gc?.();
  const before = getHeapStatistics();
  for (let step = 0; step < STEPS; step++) world.step(1 / 60);
  const after = getHeapStatistics();
  const bytesPerStep = (after.used_heap_size - before.used_heap_size) / STEPS;
  const bufferBytes = after.external_memory - before.external_memory;
  if (bytesPerStep < best.bytesPerStep) best = { bytesPerStep, bufferBytes };
}
console.log(JSON.stringify(best));
