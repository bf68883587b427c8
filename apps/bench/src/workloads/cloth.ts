import { strainOf } from '../quality.ts';
import { type Link, makeScene, type Scene } from '../scene.ts';
import { mean, median } from '../statistics.ts';
import type { Workload } from '../workload.ts';

const SPACING = 0.1;
const SWAY = 1;
const STEPS = 600;
const TIMED = 300;
const SAMPLE = 10;

/** A square net of point masses and links, held by its top row. */
function clothScene(side: number): Scene {
  const discs = Array.from({ length: side * side }, (_, i) => {
    const row = Math.floor(i / side);
    return {
      x: (i % side) * SPACING,
      y: -row * SPACING,
      radius: 0.02,
      mass: 0.01,
      vx: row === 0 ? 0 : SWAY,
      fixed: row === 0,
    };
  });
  const links = discs.flatMap((_, i): Link[] => {
    const across = (i + 1) % side === 0 ? [] : [{ a: i, b: i + 1, length: SPACING }];
    const down = i + side < discs.length ? [{ a: i, b: i + side, length: SPACING }] : [];
    return i < side ? down : [...across, ...down];
  });
  return makeScene({ discs, links });
}

export const cloth: Workload = {
  id: 'cloth',
  title: 'Cloth',
  about: `A net of point masses of 10 g, 0.1 m apart, with links along its threads, hung by its top row, set swaying at
1 m/s. Strain: how much links are too long or too short, in the mean over all of them and over the last 5 s of 10 s. The time is the
median of those 5 s.`,
  needs: ['links'],
  measures: {
    step: { title: 'step', unit: 'ms', better: 'less', target: { ratio: 0.5 } },
    strain: { title: 'mean strain', unit: '%', better: 'less' },
  },
  cases: [
    { name: '32 x 32', n: 32, quick: true, targets: { strain: { limit: 0.2 } } },
    { name: '64 x 64', n: 64, targets: { strain: { limit: 0.45 } } },
  ],
  run({ build, run, time }, { n }) {
    const scene = clothScene(n);
    const simulation = build(scene);
    run(simulation, STEPS - TIMED);
    const positions = new Float64Array(2 * scene.discs.length);
    const strains: number[] = [];
    const times = time(simulation, TIMED, (step) => {
      if (step % SAMPLE !== 0) return;
      simulation.readPositions(positions);
      strains.push(strainOf(scene, positions));
    });
    return { step: median(times), strain: 100 * mean(strains) };
  },
  unsound({ strain }) {
    return strain < 100 ? undefined : 'the cloth flew apart';
  },
};
