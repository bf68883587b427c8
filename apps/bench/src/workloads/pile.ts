import { distanceBetween, overlapsOf } from '../quality.ts';
import { randomBetween } from '../random.ts';
import { type Disc, makeScene, type Scene } from '../scene.ts';
import { median, quantile, trimmedMean } from '../statistics.ts';
import type { Workload } from '../workload.ts';

/** Mean radius of a disc. Unit: m. */
export const RADIUS = 0.25;
const FALLING = 120;
const STEPS = 600;
const SETTLED = 360;
const SAMPLE = 6;
const STILL = 0.01;
const WARM_UP_DISCS = 200;

/** Discs in loose rows over the floor of a box, about as high as wide when they have fallen, or so many rows as given. */
export function pileScene(n: number, parts: Partial<Scene> = {}, rows: number = Math.ceil(Math.sqrt(n))): Scene {
  const between = randomBetween(1);
  const columns = Math.ceil(n / rows);
  const pitch = 2.3 * RADIUS;
  const discs = Array.from({ length: n }, (_, i): Disc => {
    const radius = RADIUS * between(0.9, 1.1);
    const x = ((i % columns) + 0.5) * pitch + between(-0.02, 0.02);
    const y = (Math.floor(i / columns) + 0.5) * 1.3 * pitch;
    return { x, y, radius, mass: (radius / RADIUS) ** 2 };
  });
  const container = { left: 0, right: columns * pitch, floor: 0 };
  return makeScene({ discs, container, collide: true, friction: 0.3, ...parts });
}

export const pile: Workload = {
  id: 'pile',
  title: 'Pile of discs in a box',
  about: `Discs of 0.25 m ± 10 % fall in loose rows into a box about as wide as the pile is high; friction 0.3, no restitution,
nothing may sleep. A small pile has warmed up the process. Falling: mean of the first 2 s, without the
slowest twentieth of steps. Settled: the steps from 6 s to 10 s, their
median, and the 99th percentile over it. Penetrations are a share of the mean radius: peak
while falling, and at the end the mean over all that overlap. Still: the time from which on the discs move at less than 10 mm/s
(root mean square).`,
  needs: ['collide'],
  measures: {
    settled: { title: 'settled', unit: 'ms', better: 'less', target: { ratio: 0.2 } },
    tail: { title: 'p99 over median', unit: '', better: 'less', target: { limit: 2 } },
    falling: { title: 'falling', unit: 'ms', better: 'less', target: { ratio: 0.3 } },
    penetration: { title: 'mean penetration', unit: '%', better: 'less' },
    peak: { title: 'peak overlap', unit: '%', better: 'less', target: { limit: 60 } },
    still: { title: 'still after', unit: 's', better: 'less' },
    escaped: { title: 'escaped', unit: '', better: 'less', target: { limit: 0 } },
  },
  cases: [
    { name: '500', n: 500, quick: true },
    { name: '2000', n: 2000, targets: { penetration: { limit: 1 } } },
    { name: '8000', n: 8000 },
  ],
  run({ build, run, time }, { n }) {
    run(build(pileScene(WARM_UP_DISCS)), FALLING);
    const scene = pileScene(n);
    const simulation = build(scene);
    const positions = new Float64Array(2 * n);
    const before = new Float64Array(2 * n);
    let peak = 0;
    let still = 0;
    simulation.readPositions(before);
    const watch = (step: number): void => {
      if ((step + 1) % SAMPLE !== 0) return;
      simulation.readPositions(positions);
      if (!(distanceBetween(before, positions) < STILL * SAMPLE * scene.dt)) still = (step + 1) * scene.dt;
      before.set(positions);
    };
    const falling = time(simulation, FALLING, (step) => {
      simulation.readPositions(positions);
      peak = Math.max(peak, overlapsOf(scene, positions).peak);
      watch(step);
    });
    time(simulation, SETTLED - FALLING, (step) => watch(step + FALLING));
    const settled = time(simulation, STEPS - SETTLED, (step) => watch(step + SETTLED));
    simulation.readPositions(positions);
    const end = overlapsOf(scene, positions);
    return {
      settled: median(settled),
      tail: quantile(settled, 0.99) / median(settled),
      falling: trimmedMean(falling),
      penetration: (100 * end.mean) / RADIUS,
      peak: (100 * peak) / RADIUS,
      still: still < STEPS * scene.dt ? still : Number.NaN,
      escaped: end.escaped,
    };
  },
  unsound({ escaped, penetration }) {
    if (escaped > 0) return `${escaped} escaped`;
    return penetration > 20 ? 'discs deep inside one another' : undefined;
  },
};
