import { median } from '../statistics.ts';
import type { Workload } from '../workload.ts';
import { pileScene } from './pile.ts';

const ROUNDS = 300;

export const readout: Workload = {
  id: 'readout',
  title: 'Reading all positions',
  about: `All positions of a pile, read into an array after each step, as one does to draw it: the median of 300 times. Mass gives its arrays
themselves; what is measured is the loop that copies them.`,
  needs: ['collide'],
  measures: { read: { title: 'read', unit: 'µs', better: 'less' } },
  cases: [{ name: '2000', n: 2000, quick: true, targets: { read: { limit: 20 } } }],
  run({ build, time }, { n }) {
    const simulation = build(pileScene(n));
    const positions = new Float64Array(2 * n);
    const times = new Float64Array(ROUNDS);
    time(simulation, ROUNDS, (step) => {
      const from = performance.now();
      simulation.readPositions(positions);
      times[step] = performance.now() - from;
    });
    return { read: 1000 * median(times) };
  },
};
