import { impact, type Particle, World } from '@mass/core';
import {
  Cloth,
  chooseShot,
  energyOf,
  firstHit,
  half,
  isPotted,
  layCueBall,
  layRack,
  layTable,
  mass,
  pocketRadius,
  pockets,
  radius,
} from './billiard-table.ts';
import type { Action, Guide, Point, Scene } from './scene.ts';

const fastest = 8;
const longestPull = 0.5;
const breakFrom = 0;
const breakOff = -0.003;

export const billiards: Scene<'restitution' | 'cloth'> = {
  id: 'billiards',
  figure: 'Chapter 8',
  title: 'Billiards',
  summary:
    'The resolver for billiards goes from one impact to the next, each at its own time. Nothing overlaps and nothing is missed, however hard the break; at restitution 1 and without the cloth not a billionth of the energy is lost. It plays by itself until you do: pull back from the white ball and let go, or turn the cue by ← and →, set the force by ↑ and ↓, and shoot by Enter. Any other ball can be taken hold of and dragged.',
  lookFor: 'The break scatters fifteen balls in a few thousandths of a second, each impact in its turn.',
  formula: String.raw`|\mathbf p_a+\mathbf v_a t-\mathbf p_b-\mathbf v_b t|=r_a+r_b,\qquad J=\frac{-(1+c)\,v_s}{1/m_a+1/m_b}`,
  parameters: {
    restitution: { label: 'Restitution', min: 0.7, max: 1, step: 0.01, value: 0.95 },
    cloth: { label: 'Slowed by the cloth', unit: 'm/s²', min: 0, max: 2, step: 0.05, value: 0.3, live: true },
  },
  show: { minX: -1.13, maxX: 1.13, minY: -0.635, maxY: 0.635 },
  step: 1 / 240,
  poster: 0.5,
  style: ({ series, dark, ink }) => {
    const balls = [3, 1, 6, 5, 2, 4, 7].map((n) => series[n]);
    const black = { fill: '#101318', stroke: dark ? '#5b6472' : '#101318', strokeWidth: 1 };
    return {
      particle: { minRadius: 4 },
      groups: {
        ...Object.fromEntries(balls.map((fill, n) => [n + 1, { fill }])),
        8: black,
        ...Object.fromEntries(balls.map((fill, n) => [n + 9, { fill, stroke: '#ffffff', strokeWidth: 2.25 }])),
        16: { fill: '#ffffff', stroke: dark ? '#ffffff' : ink, strokeWidth: 1.25 },
        17: black,
      },
      // Frame, cloth and cushions are one colour, laid on once, twice and three times.
      shapes: { fill: series[4], fillAlpha: dark ? 0.17 : 0.2, stroke: series[4], strokeWidth: 1, hatch: null },
    };
  },

  build(values, seed) {
    const { restitution } = values;
    const world = new World({ resolver: impact() });
    layTable(world, restitution);
    const cloth = world.addForce(new Cloth());
    let balls: Particle[] = [];
    let cue: Particle;
    let aim = { angle: 0, speed: 5 };
    let aiming = false;
    let played = false;
    let quiet = 0;
    let shots = 0;

    const shoot = (): void => {
      Object.assign(cue, { vx: aim.speed * Math.cos(aim.angle), vy: aim.speed * Math.sin(aim.angle) });
      aiming = false;
      quiet = 0;
      shots++;
    };
    const rack = (): void => {
      for (const ball of [...balls, cue]) if (ball?.alive) ball.remove();
      balls = layRack(world, restitution, seed);
      cue = layCueBall(world, restitution, breakFrom);
      aim = { angle: Math.atan2(breakOff - breakFrom, 1), speed: 8 };
      shots = 0;
    };
    rack();
    shoot();

    /** Removes what fell; a cue ball that fell comes back where there is room. */
    function clearPockets(): void {
      balls = balls.filter((ball) => {
        if (isPotted(ball)) ball.remove();
        return ball.alive;
      });
      if (!isPotted(cue)) return;
      cue.remove();
      let y = 0;
      while (balls.some((ball) => Math.hypot(ball.x + half.x / 2, ball.y - y) < 2.1 * radius))
        y = (y <= 0 ? 1 : -1) * (Math.abs(y) + radius);
      cue = layCueBall(world, restitution, y);
    }

    function beforeStep(dt: number): void {
      cloth.deceleration = values.cloth;
      clearPockets();
      if (balls.length === 0) rack();
      quiet = energyOf([cue, ...balls]) < 1e-9 ? quiet + dt : 0;
      played ||= world.forces.length > 1; // a hand is a force beside the cloth
      if (played || quiet < 0.6) return;
      // Until somebody takes the cue it plays by itself: first it aims, then it shoots.
      if (!aiming) aim = chooseShot(cue, balls);
      aiming = true;
      if (quiet > 1.5) shoot();
    }

    const take = (): void => {
      played = true;
      aiming = true;
    };
    const turn = (by: number): void => {
      take();
      aim = { ...aim, angle: aim.angle + by };
    };
    const press = (by: number): void => {
      take();
      aim = { ...aim, speed: Math.min(fastest, Math.max(0.5, aim.speed + by)) };
    };
    const pull = ({ x, y }: Point): void => {
      const [dx, dy] = [cue.x - x, cue.y - y];
      const way = Math.hypot(dx, dy);
      if (way > radius)
        aim = { angle: Math.atan2(dy, dx), speed: (Math.min(way, longestPull) / longestPull) * fastest };
    };
    const actions: Action[] = [
      { key: 'ArrowLeft', label: 'Turn left', run: () => turn(0.02) },
      { key: 'ArrowRight', label: 'Turn right', run: () => turn(-0.02) },
      { key: 'ArrowUp', label: 'Harder', run: () => press(0.5) },
      { key: 'ArrowDown', label: 'Softer', run: () => press(-0.5) },
      {
        key: 'Enter',
        label: 'Shoot',
        run() {
          take();
          shoot();
        },
      },
      {
        key: 'b',
        label: 'Break',
        run() {
          rack();
          shoot();
        },
      },
    ];

    return {
      world,
      actions,
      takes: (ball) => ball !== cue,
      pointer: {
        down(at) {
          if (Math.hypot(at.x - cue.x, at.y - cue.y) > 0.22) return false;
          take();
          return true;
        },
        move: pull,
        up(at) {
          pull(at);
          if (Math.hypot(at.x - cue.x, at.y - cue.y) > 1.5 * radius) shoot();
          else aiming = false;
        },
      },
      beforeStep,
      guides: () => [...markings, ...(aiming ? aimingLines(cue, balls, aim) : [])],
      readouts: () => [
        { label: 'Balls left', value: balls.length, digits: 0 },
        { label: 'Energy', value: energyOf([cue, ...balls]), unit: 'J', digits: 3 },
        {
          label: 'Momentum',
          value: mass * Math.hypot(sum([cue, ...balls], 'vx'), sum([cue, ...balls], 'vy')),
          unit: 'kg·m/s',
          digits: 3,
        },
        { label: 'Shots', value: shots, digits: 0 },
      ],
    };
  },

  check(run) {
    const trial = run({ restitution: 1, cloth: 0 });
    const { world } = trial.setup;
    const living = (): Particle[] => {
      const { count, alive } = world.particles;
      return Array.from({ length: count }, (_, slot) => slot)
        .filter((slot) => alive[slot] === 1)
        .map((slot) => world.particleAt(slot));
    };
    const start = energyOf(living());
    let [energy, count, drift, overlap] = [start, world.particleCount, 0, 0];
    trial.run(4, () => {
      const balls = living();
      // What falls into a pocket takes its energy along.
      if (balls.length !== count) [energy, count] = [energyOf(balls), balls.length];
      drift = Math.max(drift, Math.abs(energyOf(balls) / energy - 1));
      for (const [n, a] of balls.entries()) {
        for (const b of balls.slice(0, n)) overlap = Math.max(overlap, 2 - Math.hypot(a.x - b.x, a.y - b.y) / radius);
      }
    });

    const mirrored = [1, -1].map((mirror) => breakOf(mirror as 1 | -1));
    const [one, other] = mirrored.map(({ balls }) => balls);
    const off = Math.max(...one.map((ball, n) => Math.hypot(ball.x - other[n].x, ball.y + other[n].y)));
    const fallen = run();
    for (let n = 0; n < 8; n++) fallen.run(5);
    return [
      { name: 'energy gained or lost, as a share', value: drift, atMost: 1e-12 },
      { name: 'overlap of two balls, as a share of the radius', value: overlap, atMost: 1e-9 },
      {
        name: 'momentum after the break, as a share of that of the cue ball',
        value: mirrored[0].momentum,
        atLeast: 1 - 1e-12,
        atMost: 1 + 1e-12,
      },
      {
        name: 'balls that the break has moved',
        value: one.filter(({ vx, vy }) => Math.hypot(vx, vy) > 0.01).length,
        atLeast: 12,
      },
      { name: 'how far the mirrored break is off the mirror image after half a second, m', value: off, atMost: 1e-9 },
      { name: 'balls potted in 40 s', value: 16 - fallen.setup.world.particleCount, atLeast: 2 },
    ];
  },
};

const markings: readonly Guide[] = [
  { kind: 'curve', points: [-0.5, -half.y, -0.5, half.y], opacity: 0.35 },
  { kind: 'circle', x: 0.5, y: 0, radius: 0.008, filled: true, opacity: 0.5 },
  ...pockets.map(({ x, y }): Guide => ({ kind: 'circle', x, y, radius: pocketRadius - 0.006, filled: true, tone: 17 })),
];

/** The cue, the way to what it will meet, and where that will go. */
function aimingLines(
  cue: Particle,
  balls: readonly Particle[],
  { angle, speed }: { angle: number; speed: number },
): Guide[] {
  const [ux, uy] = [Math.cos(angle), Math.sin(angle)];
  const { at, ball } = firstHit(cue, ux, uy, balls);
  const back = radius * 1.5 + (longestPull * speed) / fastest;
  const stick = [radius * 1.5 + 0.3 * (back - radius), back + 0.35].flatMap((way) => [
    cue.x - way * ux,
    cue.y - way * uy,
  ]);
  const lines: Guide[] = [
    { kind: 'curve', points: stick, tone: 'accent', bold: true },
    { kind: 'curve', points: [cue.x, cue.y, at.x, at.y], dashed: true, tone: 'ink' },
    { kind: 'circle', ...at, radius, tone: 'ink' },
  ];
  if (ball) {
    const [nx, ny] = [(ball.x - at.x) / (2 * radius), (ball.y - at.y) / (2 * radius)];
    const to = { x: ball.x + 0.22 * nx, y: ball.y + 0.22 * ny };
    lines.push({ kind: 'arrow', from: ball, to, tone: 'ink' });
  }
  return lines;
}

/** A break with neither loss nor pockets, or its mirror image, half a second after the shot. */
function breakOf(mirror: 1 | -1): { balls: readonly Particle[]; momentum: number } {
  const world = new World({ resolver: impact() });
  layTable(world, 1);
  const balls = layRack(world, 1, 1, mirror);
  const cue = layCueBall(world, 1, mirror * breakFrom);
  const angle = Math.atan2(breakOff - breakFrom, 1);
  Object.assign(cue, { vx: 7 * Math.cos(angle), vy: mirror * 7 * Math.sin(angle) });
  const all = [cue, ...balls];
  while (energyOf(balls) === 0) world.step(1 / 240);
  const momentum = Math.hypot(sum(all, 'vx'), sum(all, 'vy')) / 7;
  while (world.time < 0.5) world.step(1 / 240);
  return { balls: all, momentum };
}

function sum(balls: readonly Particle[], of: 'vx' | 'vy'): number {
  return balls.reduce((total, ball) => total + ball[of], 0);
}
