import { type Crate, type Disc, makeScene, type Scene } from '../scene.ts';
import type { Bench, Case, Workload } from '../workload.ts';

const RADIUS = 0.1;
const LANES = 20;
const LANE = 2;
const DISTANCE = 5;
const SPEEDS = [5, 10, 20, 50, 100, 200, 500, 1000];

interface TunnelCase extends Case {
  readonly against: 'bars' | 'discs' | 'crates';
}

/** In each lane a disc flies towards something thin, each from a little further away. */
function lanesScene(against: TunnelCase['against'], speed: number): Scene {
  const lanes = Array.from({ length: LANES }, (_, lane) => lane);
  const fast = lanes.map((lane): Disc => {
    const x = -DISTANCE - (lane / LANES) * (speed / 60);
    return { x, y: lane * LANE, vx: speed, radius: RADIUS, mass: 1, fast: true };
  });
  const targets = lanes.map((lane): Disc => ({ x: 0, y: lane * LANE, radius: RADIUS, mass: 1 }));
  const crates = lanes.map((lane): Crate => ({ x: 0, y: lane * LANE, size: 4 * RADIUS, mass: 4 }));
  const bars = lanes.map((lane) => ({ x: 0, y: lane * LANE, width: RADIUS, height: 1 }));
  return makeScene({
    gravity: 0,
    collide: true,
    discs: against === 'discs' ? [...fast, ...targets] : fast,
    bars: against === 'bars' ? bars : [],
    crates: against === 'crates' ? crates : [],
  });
}

/** Whether any gets past the middle of what it hits. */
function passes({ build, time }: Bench, against: TunnelCase['against'], speed: number): boolean {
  const scene = lanesScene(against, speed);
  const simulation = build(scene);
  const positions = new Float64Array(2 * scene.discs.length);
  const corners = new Float64Array(8 * scene.crates.length);
  const middle = (lane: number): number => {
    if (against === 'bars') return 0;
    if (against === 'discs') return positions[2 * (LANES + lane)];
    return (corners[8 * lane] + corners[8 * lane + 2] + corners[8 * lane + 4] + corners[8 * lane + 6]) / 4;
  };
  let passed = false;
  time(simulation, Math.ceil((DISTANCE / speed) * 60) + 20, () => {
    simulation.readPositions(positions);
    if (against === 'crates') simulation.readCorners?.(corners);
    for (let lane = 0; lane < LANES; lane++) if (!(positions[2 * lane] < middle(lane))) passed = true;
  });
  return passed;
}

export const tunnel: Workload<TunnelCase> = {
  id: 'tunnel',
  title: 'Speed without tunnelling',
  about: `Twenty discs of 0.1 m fly at something in their way, each from another place between two steps: an immovable bar 0.1 m thick, a disc
like themselves at rest, or the middle of a side of a crate of 0.4 m at rest. The highest of ${SPEEDS.join(', ')} m/s up to which none
ever gets past the middle of what it hits. Continuous collision is on, where an engine has it.`,
  needs: ['collide'],
  measures: { speed: { title: 'highest speed', unit: 'm/s', better: 'more' } },
  cases: [
    { name: 'a bar', n: LANES, against: 'bars', needs: ['bars'], quick: true, targets: { speed: { limit: 500 } } },
    { name: 'a disc', n: LANES, against: 'discs', quick: true, targets: { speed: { limit: 500 } } },
    { name: 'a crate', n: LANES, against: 'crates', needs: ['crates'], quick: true, targets: { speed: { limit: 50 } } },
  ],
  run(bench, { against }) {
    const firstFailure = SPEEDS.findIndex((speed) => passes(bench, against, speed));
    const held = firstFailure < 0 ? SPEEDS.length : firstFailure;
    return { speed: held === 0 ? 0 : SPEEDS[held - 1] };
  },
};
