import { makeScene } from '../scene.ts';
import type { Workload } from '../workload.ts';

const SIZE = 0.5;
const STEPS = 3600;

export const tower: Workload = {
  id: 'tower',
  title: 'Tower of crates',
  about: `Boxes of 0.5 m, one on top of the other, friction 0.5, nothing may sleep: how far the top one has sunk and wandered sideways after 60 s.`,
  needs: ['crates', 'collide'],
  measures: {
    sunk: { title: 'top sinks', unit: 'mm', better: 'less' },
    aside: { title: 'top aside', unit: 'mm', better: 'less' },
  },
  cases: [
    { name: '10 crates', n: 10, quick: true },
    { name: '20 crates', n: 20 },
  ],
  run({ build, run }, { n }) {
    const crates = Array.from({ length: n }, (_, i) => ({ x: 0, y: (i + 0.5) * SIZE, size: SIZE, mass: 1 }));
    const container = { left: -20, right: 20, floor: 0 };
    const simulation = build(makeScene({ crates, container, collide: true, friction: 0.5 }));
    run(simulation, STEPS);
    const corners = new Float64Array(8 * n);
    simulation.readCorners?.(corners);
    const top = corners.subarray(8 * (n - 1));
    const x = (top[0] + top[2] + top[4] + top[6]) / 4;
    const y = (top[1] + top[3] + top[5] + top[7]) / 4;
    return { sunk: 1000 * ((n - 0.5) * SIZE - y), aside: 1000 * Math.abs(x) };
  },
  unsound({ sunk }) {
    return sunk < 1000 * SIZE ? undefined : 'the tower fell';
  },
};
