import { energyOf, stretchOf } from '../quality.ts';
import { type Disc, makeScene, type Scene } from '../scene.ts';
import { mean, median } from '../statistics.ts';
import type { Workload } from '../workload.ts';

const LINK = 0.25;
const SECOND = 60;
const STEPS = 20 * SECOND;

/** Point masses in a row to the right of a fixed one, joined by links, the last with a load. */
export function ropeScene(links: number, load: number): Scene {
  const discs = Array.from({ length: links + 1 }, (_, i): Disc => {
    return { x: i * LINK, y: 0, radius: 0.05, mass: i === links ? load : 1, fixed: i === 0 };
  });
  return makeScene({
    discs,
    links: Array.from({ length: links }, (_, i) => ({ a: i, b: i + 1, length: LINK })),
  });
}

/** Energy over that of the rope hanging at rest, as it is released. Unit: J. */
export function swingEnergyOf(scene: Scene): { released: number; atRest: number } {
  const fall = scene.discs.reduce((sum, { mass }, i) => (i === 0 ? sum : sum + mass * scene.gravity * i * LINK), 0);
  return { released: 0, atRest: -fall };
}

export const rope: Workload = {
  id: 'rope',
  title: 'Rope, released level',
  about: `Point masses of 1 kg on links of 0.25 m, 10 kg at the end, released level and left to swing for 20 s. Stretch: the greatest excess of the
whole length. Energy: what is left of the swing, over the rope hanging at rest, in the mean of the last second.`,
  needs: ['links'],
  measures: {
    step: { title: 'step', unit: 'µs', better: 'less', target: { ratio: 0.7 } },
    stretch: { title: 'stretch', unit: '%', better: 'less', target: { limit: 0.1 } },
    energy: { title: 'energy left', unit: '%', better: 'more' },
  },
  cases: [
    { name: '20 links', n: 20, quick: true, targets: { energy: { limit: 99 } } },
    { name: '100 links', n: 100, targets: { energy: { limit: 90 } } },
  ],
  run({ build, time }, { n }) {
    const scene = ropeScene(n, 10);
    const simulation = build(scene);
    const positions = new Float64Array(2 * scene.discs.length);
    const velocities = new Float64Array(2 * scene.discs.length);
    const { released, atRest } = swingEnergyOf(scene);
    const late: number[] = [];
    let stretch = 0;
    const times = time(simulation, STEPS, (step) => {
      simulation.readPositions(positions);
      stretch = Math.max(stretch, stretchOf(scene, positions));
      if (step < STEPS - SECOND) return;
      simulation.readVelocities(velocities);
      late.push((energyOf(scene, positions, velocities) - atRest) / (released - atRest));
    });
    return { step: 1000 * median(times), stretch: 100 * stretch, energy: 100 * mean(late) };
  },
  unsound({ stretch, energy }) {
    if (!(stretch < 100)) return 'the rope flew apart';
    return energy < 101 ? undefined : 'energy from nowhere';
  },
};
