import { getHeapStatistics } from 'node:v8';
import type { Workload } from '../workload.ts';
import { pileScene } from './pile.ts';

const WARM_UP = 300;
const STEPS = 100;
const ROUNDS = 5;

export const garbage: Workload = {
  id: 'garbage',
  title: 'Garbage in a step',
  about: `What steps of a pile allocate on JavaScript's heap, after 5 s of warm-up: the least of five times 100 steps, with a young generation so
large that nothing is collected in between. Memory inside WASM is not counted.`,
  needs: ['collide'],
  measures: { bytes: { title: 'a step', unit: 'B', better: 'less', target: { limit: 100 } } },
  cases: [{ name: '500', n: 500, quick: true }],
  nodeFlags: ['--expose-gc', '--min-semi-space-size=512', '--max-semi-space-size=1024'],
  run({ build, run }, { n }) {
    const simulation = build(pileScene(n));
    run(simulation, WARM_UP);
    let least = Infinity;
    for (let round = 0; round < ROUNDS; round++) {
      globalThis.gc?.();
      const before = getHeapStatistics().used_heap_size;
      run(simulation, STEPS);
      least = Math.min(least, getHeapStatistics().used_heap_size - before);
    }
    return { bytes: Math.max(0, least) / STEPS };
  },
};
