import { crateQualityOf } from '../quality.ts';
import { randomBetween } from '../random.ts';
import { type Crate, makeScene, type Scene } from '../scene.ts';
import { median } from '../statistics.ts';
import type { Workload } from '../workload.ts';

const SIZE = 0.5;
const STEPS = 600;
const TIMED = 240;

function cratesScene(n: number): Scene {
  const between = randomBetween(2);
  const columns = Math.ceil(Math.sqrt(n));
  const pitch = 1.3 * SIZE;
  const crates = Array.from({ length: n }, (_, i): Crate => {
    const x = ((i % columns) + 0.5) * pitch + between(-0.05, 0.05);
    return { x, y: (Math.floor(i / columns) + 0.5) * 1.2 * pitch, size: SIZE, mass: 1 };
  });
  const container = { left: 0, right: columns * pitch, floor: 0 };
  return makeScene({ crates, container, collide: true, friction: 0.5 });
}

export const crates: Workload = {
  id: 'crates',
  title: 'Pile of crates',
  about: `Boxes of 0.5 m fall into a box; friction 0.5, nothing may sleep. In Mass each is 4 particles and 6 rods, in the others a rigid body. The
time is the median from 6 s to 10 s. Penetration: how deep corners are inside other crates or the container, in the mean of those that are,
as a share of half a side. Deformation: the greatest error of a side; rigid bodies have none.`,
  needs: ['crates', 'collide'],
  measures: {
    step: { title: 'step', unit: 'ms', better: 'less', target: { ratio: 1 } },
    penetration: { title: 'mean penetration', unit: '%', better: 'less' },
    peak: { title: 'deepest', unit: '%', better: 'less' },
    deformation: { title: 'deformation', unit: '%', better: 'less' },
    escaped: { title: 'escaped', unit: '', better: 'less', target: { limit: 0 } },
  },
  cases: [
    { name: '100', n: 100, quick: true },
    { name: '500', n: 500 },
  ],
  run({ build, run, time }, { n }) {
    const scene = cratesScene(n);
    const simulation = build(scene);
    run(simulation, STEPS - TIMED);
    const times = time(simulation, TIMED);
    const corners = new Float64Array(8 * n);
    simulation.readCorners?.(corners);
    const { mean, peak, deformation, escaped } = crateQualityOf(scene, corners);
    const share = 100 / (SIZE / 2);
    return {
      ...{ step: median(times), escaped, deformation: 100 * deformation },
      ...{ penetration: mean * share, peak: peak * share },
    };
  },
  unsound({ escaped, penetration, deformation }) {
    if (escaped > 0) return `${escaped} escaped`;
    if (penetration > 20) return 'crates deep inside one another';
    return deformation > 20 ? 'crates crushed' : undefined;
  },
};
