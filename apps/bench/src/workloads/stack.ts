import { type Disc, makeScene, type Scene } from '../scene.ts';
import { median } from '../statistics.ts';
import type { Workload } from '../workload.ts';

const RADIUS = 0.25;
const EARLY = 120;
const STEPS = 600;

/** A triangle of discs that just touch, each row one shorter than that beneath, the lowest between two walls. The top is the last. */
function stackScene(rows: number): Scene {
  const discs: Disc[] = [];
  for (let row = 0; row < rows; row++) {
    for (let i = 0; i < rows - row; i++) {
      const y = RADIUS + row * Math.sqrt(3) * RADIUS;
      discs.push({ x: (2 * i + 1 + row) * RADIUS, y, radius: RADIUS, mass: 1 });
    }
  }
  const container = { left: 0, right: 2 * rows * RADIUS, floor: 0 };
  return makeScene({ discs, container, collide: true, friction: 0.5 });
}

export const stack: Workload = {
  id: 'stack',
  title: 'Stack of discs',
  about: `A pyramid of discs of 0.25 m that just touch, its lowest row between two walls; friction 0.5, nothing may sleep. How far the top has
sunk after 10 s, and how much of that after the first 2 s. The time is the median over 10 s.`,
  needs: ['collide'],
  measures: {
    step: { title: 'step', unit: 'ms', better: 'less', target: { ratio: 0.3 } },
    sunk: { title: 'top sinks', unit: 'mm', better: 'less' },
    creep: { title: 'creep after 2 s', unit: 'mm', better: 'less', target: { limit: 0.1 } },
  },
  cases: [
    { name: '10 rows', n: 10, quick: true, targets: { sunk: { limit: 8 } } },
    { name: '20 rows', n: 20, targets: { sunk: { limit: 30 } } },
  ],
  run({ build, time }, { n }) {
    const scene = stackScene(n);
    const simulation = build(scene);
    const positions = new Float64Array(2 * scene.discs.length);
    const top = (): number => {
      simulation.readPositions(positions);
      return 1000 * positions[positions.length - 1];
    };
    const start = 1000 * scene.discs[scene.discs.length - 1].y;
    let early = start;
    const times = time(simulation, STEPS, (step) => {
      if (step === EARLY - 1) early = top();
    });
    const end = top();
    return { step: median(times), sunk: start - end, creep: Math.abs(end - early) };
  },
  unsound({ sunk }) {
    return sunk < 1000 * RADIUS ? undefined : 'the stack fell';
  },
};
