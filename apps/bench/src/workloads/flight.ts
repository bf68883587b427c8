import { makeScene, type Scene } from '../scene.ts';
import { median } from '../statistics.ts';
import type { Case, Workload } from '../workload.ts';

const K1 = 0.1;
const PARTICLE_STEPS = 2e7;

interface FlightCase extends Case {
  readonly by: 'engine' | 'function';
}

function flightScene(n: number, by: 'engine' | 'function'): Scene {
  const discs = Array.from({ length: n }, (_, i) => {
    return { x: i % 1000, y: (i * 7) % 100, vx: (i % 13) - 6.5, vy: (i % 7) + 0.5, radius: 0.1, mass: 1 };
  });
  return makeScene({ discs, drag: { k1: K1, by } });
}

export const flight: Workload<FlightCase> = {
  id: 'flight',
  title: 'Free flight',
  about: `Points of 1 kg under gravity and a drag of 0.1 N·s/m, nothing collides: by what the engine has for gravity and drag, or with the drag
by a function of the user's that is called for each particle. Median time a step, over the number of particles. "Fallen" is the mean
change of height, which should be alike.`,
  needs: [],
  measures: {
    particle: { title: 'a particle', unit: 'ns', better: 'less' },
    fallen: { title: 'fallen', unit: 'm', better: 'less' },
  },
  cases: [
    { name: '10 000', n: 10_000, by: 'engine', quick: true, targets: { particle: { limit: 6 } } },
    { name: '100 000', n: 100_000, by: 'engine', targets: { particle: { limit: 6 } } },
    { name: '10 000 by function', n: 10_000, by: 'function', quick: true, targets: { particle: { limit: 15 } } },
    { name: '100 000 by function', n: 100_000, by: 'function', targets: { particle: { limit: 15 } } },
  ],
  run({ build, run, time }, { n, by }) {
    const scene = flightScene(n, by);
    const simulation = build(scene);
    const steps = Math.max(60, Math.min(600, PARTICLE_STEPS / n));
    run(simulation, 60);
    const positions = new Float64Array(2 * n);
    simulation.readPositions(positions);
    const fallen = scene.discs.reduce((sum, { y }, i) => sum + y - positions[2 * i + 1], 0) / n;
    return { particle: (1e6 * median(time(simulation, steps))) / n, fallen };
  },
};
