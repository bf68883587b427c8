import { median } from '../statistics.ts';
import type { Workload } from '../workload.ts';
import { pileScene } from './pile.ts';

const STEPS = 600;
const LOOK = 30;
const TIMED = 300;

export const asleep: Workload = {
  id: 'asleep',
  title: 'Pile of discs, asleep',
  about: `The same pile, where what rests may sleep. Asleep after: the time from which on no position changes by a single bit, within 10 s; a
dash if there is none. The time is the median of 300 steps after that.`,
  needs: ['collide', 'sleep'],
  measures: {
    step: { title: 'step', unit: 'µs', better: 'less', target: { limit: 2 } },
    after: { title: 'asleep after', unit: 's', better: 'less', target: { limit: 10 } },
  },
  cases: [
    { name: '500', n: 500, quick: true },
    { name: '2000', n: 2000 },
    { name: '8000', n: 8000 },
  ],
  run({ build, run, time }, { n }) {
    const scene = pileScene(n, { sleep: true });
    const simulation = build(scene);
    const before = new Float64Array(2 * n);
    const positions = new Float64Array(2 * n);
    for (let step = 0; step < STEPS; step += LOOK) {
      before.set(positions);
      run(simulation, LOOK);
      simulation.readPositions(positions);
      if (positions.every((value, i) => value === before[i])) {
        return { step: 1000 * median(time(simulation, TIMED)), after: step * scene.dt };
      }
    }
    return { step: Number.NaN, after: Number.NaN };
  },
};
