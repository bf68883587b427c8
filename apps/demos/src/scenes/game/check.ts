import type { Particle } from '@mass/core';
import type { Finding, Point, Setup, Trial } from '../scene.ts';
import { BALL } from './groups.ts';
import type { Level, Throw } from './levels.ts';
import { HIT_POINTS, SPARED_POINTS } from './play.ts';
import { DOT } from './signs.ts';
import { FORK } from './sling.ts';

/** A throw that comes down far from everything. Unit: m. */
const MISS = { x: -0.25, y: -1.6 };

/** What must be true of a level: the recorded throws win it, throws that miss do not, and a ball goes where its dots are. */
export function wins(level: Level, played: Trial, missed: Trial): Finding[] {
  const { name, throws, solution } = level;
  const targets = reading(played.setup, 'Targets left');
  playThrows(played, solution);
  const score = targets * HIT_POINTS + reading(played.setup, 'Throws left') * SPARED_POINTS;

  const offDots = followDots(missed);
  playThrows(
    missed,
    Array.from({ length: throws - 1 }, () => ({ ...MISS, after: 0.2 })),
  );
  return [
    { name: `${name}: targets left by throws that win`, value: reading(played.setup, 'Targets left'), atMost: 0 },
    { name: `${name}: score`, value: reading(played.setup, 'Score'), atLeast: score, atMost: score },
    {
      name: `${name}: targets left by throws that miss`,
      value: reading(missed.setup, 'Targets left'),
      atLeast: targets,
    },
    { name: `${name}: score of throws that miss`, value: reading(missed.setup, 'Score'), atMost: 0 },
    { name: `${name}: throws left after all of them`, value: reading(missed.setup, 'Throws left'), atMost: 0 },
    { name: `${name}: how far a ball is off its dots, in m`, value: offDots, atMost: 1e-9 },
    { name: `${name}: particles that are nowhere`, value: lost(played) + lost(missed), atMost: 0 },
  ];
}

/** The number of a reading. */
function reading(setup: Setup, label: string): number {
  return setup.readouts?.().find((each) => each.label === label)?.value ?? Number.NaN;
}

/** Pulls the ball back by a vector, as a hand does it. */
function pullBack({ pointer }: Setup, { x, y }: Point): void {
  pointer?.down(FORK);
  pointer?.move?.({ x: FORK.x + x, y: FORK.y + y });
}

/** Plays throws, each so long after there is a ball for it, then looks on until the level is won or nothing flies. */
function playThrows({ setup, run }: Trial, throws: readonly Throw[]): void {
  setup.pointer?.down(FORK);
  setup.pointer?.up?.(FORK);
  for (const { after, x, y } of throws) {
    for (let steps = 0; steps < 300 && !heldBall(setup); steps++) run(1 / 60);
    run(after);
    pullBack(setup, { x, y });
    setup.pointer?.up?.({ x: FORK.x + x, y: FORK.y + y });
  }
  for (let steps = 0; steps < 360 && reading(setup, 'Targets left') > 0; steps++) run(1 / 60);
}

/** Throws a ball that misses. Returns how far the farthest of the dots that were drawn before is from where it came by. Unit: m. */
function followDots({ setup, run }: Trial): number {
  pullBack(setup, MISS);
  const dots = (setup.guides?.() ?? []).flatMap((guide) =>
    guide.kind === 'circle' && guide.radius < DOT ? [{ x: guide.x, y: guide.y, nearest: Infinity }] : [],
  );
  const ball = heldBall(setup);
  setup.pointer?.up?.({ x: FORK.x + MISS.x, y: FORK.y + MISS.y });
  run(1.4, () => {
    for (const dot of dots)
      dot.nearest = Math.min(dot.nearest, Math.hypot((ball?.x ?? 0) - dot.x, (ball?.y ?? 0) - dot.y));
  });
  return dots.length < 10 ? Infinity : Math.max(...dots.map(({ nearest }) => nearest));
}

/** The ball in the sling: it is pinned. */
function heldBall({ world }: Setup): Particle | undefined {
  const { count, alive, group, inverseMass } = world.particles;
  for (let i = 0; i < count; i++) {
    if (alive[i] === 1 && group[i] === BALL && inverseMass[i] === 0) return world.particleAt(i);
  }
  return undefined;
}

/** How many particles are at a place that is no number. */
function lost({ setup }: Trial): number {
  const { x, y, vx, vy } = setup.world.particles;
  return x.filter((_, i) => !Number.isFinite(x[i] + y[i] + vx[i] + vy[i])).length;
}
