import { energyOf } from '../quality.ts';
import { mean } from '../statistics.ts';
import type { Measure, Workload } from '../workload.ts';
import { ropeScene, swingEnergyOf } from './rope.ts';

const TIMES = [1, 2, 5, 10, 20];
const SECOND = 60;

const measures = TIMES.map((t): [string, Measure] => [`t${t}`, { title: `after ${t} s`, unit: '%', better: 'more' }]);

export const energy: Workload = {
  id: 'energy',
  title: 'Energy of a rope over time',
  about: `The rope of 20 links with 10 kg at its end, released level: what is left of the energy of the swing, over the rope hanging at rest, in the
mean of the half second before each time.`,
  needs: ['links'],
  measures: Object.fromEntries(measures),
  cases: [{ name: '20 links', n: 20, quick: true }],
  run({ build, time }, { n }) {
    const scene = ropeScene(n, 10);
    const simulation = build(scene);
    const positions = new Float64Array(2 * scene.discs.length);
    const velocities = new Float64Array(2 * scene.discs.length);
    const { released, atRest } = swingEnergyOf(scene);
    const left: number[] = [];
    time(simulation, SECOND * 20, () => {
      simulation.readPositions(positions);
      simulation.readVelocities(velocities);
      left.push((100 * (energyOf(scene, positions, velocities) - atRest)) / (released - atRest));
    });
    return Object.fromEntries(TIMES.map((t) => [`t${t}`, mean(left.slice(t * SECOND - SECOND / 2, t * SECOND))]));
  },
};
