import { type Disc, makeScene, type Scene } from '../scene.ts';
import type { Bench, Case, Workload } from '../workload.ts';

const RADIUS = 0.1;
const LANES = 20;
const LANE = 2;
const DISTANCE = 5;
const SPEEDS = [5, 10, 20, 50, 100, 200, 500, 1000];

interface TunnelCase extends Case {
  readonly against: 'bars' | 'discs';
}

/** In each lane a disc flies towards something as thick as itself is wide, each from a little further away. */
function lanesScene(against: TunnelCase['against'], speed: number): Scene {
  const lanes = Array.from({ length: LANES }, (_, lane) => lane);
  const fast = lanes.map((lane): Disc => {
    const x = -DISTANCE - (lane / LANES) * (speed / 60);
    return { x, y: lane * LANE, vx: speed, radius: RADIUS, mass: 1, fast: true };
  });
  const targets = lanes.map((lane): Disc => ({ x: 0, y: lane * LANE, radius: RADIUS, mass: 1 }));
  const bars = lanes.map((lane) => ({ x: 0, y: lane * LANE, width: RADIUS, height: 1 }));
  return makeScene({
    gravity: 0,
    collide: true,
    discs: against === 'discs' ? [...fast, ...targets] : fast,
    bars: against === 'bars' ? bars : [],
  });
}

/** How many get through at a speed. */
function passed({ build, time }: Bench, against: TunnelCase['against'], speed: number): number {
  const scene = lanesScene(against, speed);
  const simulation = build(scene);
  const positions = new Float64Array(2 * scene.discs.length);
  const through = new Set<number>();
  time(simulation, Math.ceil((DISTANCE / speed) * 60) + 20, () => {
    simulation.readPositions(positions);
    for (let lane = 0; lane < LANES; lane++) {
      const target = against === 'discs' ? positions[2 * (LANES + lane)] : 0;
      if (!(positions[2 * lane] < target)) through.add(lane);
    }
  });
  return through.size;
}

export const tunnel: Workload<TunnelCase> = {
  id: 'tunnel',
  title: 'Speed without tunnelling',
  about: `Twenty discs of 0.1 m fly at something in their way, 0.1 m thick, each from another place between two steps: an immovable bar, or a disc
like themselves that is at rest. The highest of ${SPEEDS.join(', ')} m/s up to which none ever gets past the middle of what it hits.
Continuous collision is on, where an engine has it.`,
  needs: ['collide'],
  measures: { speed: { title: 'highest speed', unit: 'm/s', better: 'more', target: { limit: 500 } } },
  cases: [
    { name: 'against a bar', n: LANES, against: 'bars', quick: true },
    { name: 'against each other', n: LANES, against: 'discs', quick: true },
  ],
  run(bench, { against }) {
    if (against === 'bars' && bench.engine.cannot?.bars) throw new Error(bench.engine.cannot.bars);
    const firstFailure = SPEEDS.findIndex((speed) => passed(bench, against, speed) > 0);
    const held = firstFailure < 0 ? SPEEDS.length : firstFailure;
    return { speed: held === 0 ? 0 : SPEEDS[held - 1] };
  },
};
