import { energyOf, stretchOf } from '../quality.ts';
import { makeScene, type Scene } from '../scene.ts';
import { mean } from '../statistics.ts';
import type { Workload } from '../workload.ts';

const LENGTH = 1;
const SECOND = 60;
const STEPS = 60 * SECOND;
const PERIODS = 3;

function pendulumScene(degrees: number): Scene {
  const angle = (degrees * Math.PI) / 180;
  const common = { radius: 0.1, mass: 1 };
  return makeScene({
    discs: [
      { x: 0, y: 0, ...common, fixed: true },
      { x: LENGTH * Math.sin(angle), y: -LENGTH * Math.cos(angle), ...common },
    ],
    links: [{ a: 0, b: 1, length: LENGTH }],
  });
}

/** Period by the elliptic integral, found as an arithmetic-geometric mean. Unit: s. */
function exactPeriod(degrees: number, gravity: number): number {
  let a = 1;
  let b = Math.cos((degrees * Math.PI) / 360);
  for (let i = 0; i < 10; i++) [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
  return (2 * Math.PI * Math.sqrt(LENGTH / gravity)) / a;
}

export const pendulum: Workload = {
  id: 'pendulum',
  title: 'Pendulum',
  about: `A point mass on a link of 1 m, released at rest at an angle from hanging. Period: how far the mean of its first three swings is from the
elliptic integral. Energy: what is left of that of the swing after 60 s, in the mean of a second. Stretch: the greatest error of the length.`,
  needs: ['links'],
  measures: {
    period: { title: 'period off by', unit: '%', better: 'less', target: { limit: 0.1 } },
    energy: { title: 'energy left', unit: '%', better: 'more', target: { limit: 99 } },
    stretch: { title: 'stretch', unit: '%', better: 'less' },
  },
  cases: [
    { name: '30 degrees', n: 30 },
    { name: '90 degrees', n: 90, quick: true },
    { name: '170 degrees', n: 170 },
  ],
  run({ build, time }, { n }) {
    const scene = pendulumScene(n);
    const simulation = build(scene);
    const positions = new Float64Array(4);
    const velocities = new Float64Array(4);
    const atRest = -scene.gravity * LENGTH;
    const released = scene.gravity * scene.discs[1].y;
    const late: number[] = [];
    const crossings: number[] = [];
    let stretch = 0;
    let before = scene.discs[1].x;
    time(simulation, STEPS, (step) => {
      simulation.readPositions(positions);
      const x = positions[2];
      if (before > 0 && x <= 0) crossings.push((step + before / (before - x)) * scene.dt); // every swing to the left
      before = x;
      stretch = Math.max(stretch, Math.abs(stretchOf(scene, positions)));
      if (step < STEPS - SECOND) return;
      simulation.readVelocities(velocities);
      late.push((energyOf(scene, positions, velocities) - atRest) / (released - atRest));
    });
    const period = (crossings[PERIODS] - crossings[0]) / PERIODS;
    return {
      period: 100 * Math.abs(period / exactPeriod(n, scene.gravity) - 1),
      energy: 100 * mean(late),
      stretch: 100 * stretch,
    };
  },
  unsound({ energy, stretch }) {
    if (!(stretch < 100)) return 'the link broke';
    return energy < 105 ? undefined : 'energy from nowhere';
  },
};
