import { stretchOf } from '../quality.ts';
import { makeScene, type Scene } from '../scene.ts';
import type { Bench, Workload } from '../workload.ts';

const LINKS = 20;
const LENGTH = 0.25;
const STEPS = 600;

/** A straight rope at 45 degrees, with a load at its end. */
function swingingScene(load: number): Scene {
  const discs = Array.from({ length: LINKS + 1 }, (_, i) => {
    return {
      x: i * LENGTH * Math.SQRT1_2,
      y: -i * LENGTH * Math.SQRT1_2,
      radius: 0.05,
      mass: i === LINKS ? load : 1,
      fixed: i === 0,
    };
  });
  return makeScene({
    discs,
    links: Array.from({ length: LINKS }, (_, i) => ({ a: i, b: i + 1, length: LENGTH })),
  });
}

function stretch({ build, time }: Bench, scene: Scene, effort: number): number {
  const simulation = build(scene, effort);
  const positions = new Float64Array(2 * scene.discs.length);
  let most = 0;
  time(simulation, STEPS, () => {
    simulation.readPositions(positions);
    most = Math.max(most, Math.abs(stretchOf(scene, positions)));
  });
  return 100 * most;
}

export const load: Workload = {
  id: 'load',
  title: 'Stretch against load and effort',
  about: `A rope of 20 links of 1 kg and 0.25 m, with a load at its end, released at 45 degrees. The greatest stretch within 10 s, with the sub-steps
or iterations that each engine recommends, with twice and with four times as many.`,
  needs: ['links'],
  measures: {
    once: { title: 'as recommended', unit: '%', better: 'less' },
    twice: { title: 'effort x 2', unit: '%', better: 'less' },
    fourTimes: { title: 'effort x 4', unit: '%', better: 'less' },
  },
  cases: [
    { name: '1 kg', n: 1 },
    { name: '10 kg', n: 10 },
    { name: '100 kg', n: 100, quick: true },
    { name: '1000 kg', n: 1000 },
    { name: '10 000 kg', n: 10_000, targets: { once: { limit: 1 } } },
  ],
  run(bench, { n }) {
    const scene = swingingScene(n);
    return { once: stretch(bench, scene, 1), twice: stretch(bench, scene, 2), fourTimes: stretch(bench, scene, 4) };
  },
};
