import {
  type Body,
  box,
  chain,
  type DistanceLink,
  EdgeContacts,
  HalfPlane,
  type Particle,
  substep,
  World,
} from '@mass/core';
import { Again } from './again.ts';
import type { Guide, Scene } from './scene.ts';

const g = 9.81;
const hook = { x: -0.4, y: 7.4 };
const rope = 5.6;
const side = 0.6;
const pitch = side * 1.02;
const wall = 1.2;
const columns = 3;
const pulled = 62 * (Math.PI / 180);

export const wreckingBall: Scene<'rows' | 'mass'> = {
  id: 'wrecking-ball',
  figure: 'Sub-steps',
  title: 'The wrecking ball',
  summary:
    'A heavy ball on a light chain, against a wall of boxes: each box is four particles and six rods, and its edges touch those of the others. What rests falls asleep and costs nothing: the whole wall, until it is hit. The engine knows no rotation; corners are stopped, and so boxes turn. Pull the ball back and let it go, throw boxes about, or cut the chain.',
  lookFor: 'The wall stands still to the last box, until the ball comes down the dotted arc and goes through it.',
  formula: String.raw`\tfrac12 v^2=g\,L\,(1-\cos\theta_0),\qquad m\,(v-v')=\sum_i m_i\,v_i`,
  parameters: {
    rows: { label: 'Rows of boxes', min: 2, max: 10, step: 1, value: 7 },
    mass: { label: 'The ball', unit: 'kg', min: 50, max: 800, step: 50, value: 400 },
  },
  show: { minX: -6.6, maxX: 8.4, minY: -0.6, maxY: 8.1 },
  poster: 1.7,
  style: ({ ink, series, quiet, dark }) => ({
    particle: { fill: quiet, minRadius: 1.5 },
    groups: { 1: { fill: dark ? quiet : ink }, 2: { fill: series[2] }, 3: { fill: series[3] } },
    bodies: { fillAlpha: 0.85, mark: false, strokeWidth: 2, stroke: dark ? '#14171c' : '#ffffff' },
    links: { cable: { color: quiet, width: 3 } },
  }),

  build({ rows, mass }) {
    const world = new World({ gravity: { x: 0, y: -g }, resolver: substep({ subSteps: 8 }) });
    world.addContactGenerator(new EdgeContacts(world));
    world.addShape(new HalfPlane({ point: { x: 0, y: 0 }, friction: 0.6 }));
    const radius = 0.2 + 0.02 * Math.sqrt(mass);
    const ball = world.addParticle({ x: 0, y: 0, mass, radius, friction: 0.3, group: 1 });
    let boxes: Body[] = [];
    let line: Body;
    const build = (): void => {
      for (const each of boxes) if (each.alive) each.remove();
      boxes = Array.from({ length: rows * columns }, (_, n) => {
        const row = Math.floor(n / columns);
        const at = { x: wall + (n % columns) * pitch, y: (row + 0.5) * side };
        const corner = { radius: 0.03, friction: 0.6 };
        const size = { width: side - 0.06, height: side - 0.06 };
        return world.addBody(box({ ...at, ...size, ...corner, mass: 20, group: 2 + ((row + (n % columns)) % 2) }));
      });
    };
    const pull = (): void => {
      if (line?.alive) line.remove();
      const place = { x: hook.x - rope * Math.sin(pulled), y: hook.y - rope * Math.cos(pulled) };
      Object.assign(ball, { ...place, vx: 0, vy: 0 });
      line = world.addBody(chain({ from: hook, to: ball, links: 10, mass: 10, radius: 0.05, friction: 0.3 }));
    };
    const again = new Again([world], 9, 'a', 'Build and swing again', () => {
      build();
      pull();
    });
    again.action.run();

    const moved = (): number =>
      boxes.filter(({ x, y }, n) => {
        return Math.hypot(x - wall - (n % columns) * side, y - (Math.floor(n / columns) + 0.5) * side) > side / 2;
      }).length;
    return {
      world,
      actions: [
        { key: 'p', label: 'Pull back and let go', run: pull },
        { key: 'b', label: 'Build the wall again', run: build },
        { key: 'c', label: 'Cut the chain', run: () => line.alive && line.remove() },
        again.action,
      ],
      beforeStep: () => again.beforeStep(),
      guides: () => still,
      readouts: () => [
        { label: 'Speed of the ball', value: Math.hypot(ball.vx, ball.vy), unit: 'm/s', digits: 1 },
        { label: 'Boxes knocked out', value: moved(), digits: 0 },
        { label: 'Particles that sleep', value: world.sleepingCount, digits: 0 },
      ],
    };
  },

  check(run) {
    const trial = run();
    const { world } = trial.setup;
    const ball = world.particleAt(0);
    const crates = world.bodies.filter(({ closed }) => closed);
    const places = crates.map(({ x, y }) => ({ x, y }));
    const off = (): number[] => crates.map(({ x, y }, n) => Math.hypot(x - places[n].x, y - places[n].y));
    const start = energyOf(ball);
    let [loss, drift, asleep, strain] = [0, 0, 0, 0];
    let hit = false;
    trial.run(6, () => {
      strain = Math.max(strain, ...(world.links as readonly DistanceLink[]).map((link) => Math.abs(link.strain)));
      hit ||= ball.x + ball.radius > wall - side / 2 - 0.15;
      if (hit) return;
      loss = Math.max(loss, Math.abs(energyOf(ball) / start - 1));
      drift = Math.max(drift, ...off());
      asleep = Math.max(asleep, world.sleepingCount);
    });
    return [
      { name: 'energy of the ball until it hits, change as a share', value: loss, atMost: 0.03 },
      { name: 'strain of any link at any time', value: strain, atMost: 0.05 },
      { name: 'how far any box moves before that, m', value: drift, atMost: 0.01 },
      { name: 'particles of the wall that sleep before that', value: asleep, atLeast: 4 * crates.length },
      { name: 'boxes that were knocked out', value: off().filter((way) => way > side / 2).length, atLeast: 12 },
    ];
  },
};

/** Above the lowest place of the ball, for each kilogram. */
function energyOf({ y, vx, vy }: Particle): number {
  return (vx * vx + vy * vy) / 2 + g * (y - hook.y + rope);
}

/** Down the arc to the wall. */
const arc = Array.from({ length: 41 }, (_, n) => {
  const angle = (n / 40) * (pulled + 0.14) - pulled;
  return [hook.x + rope * Math.sin(angle), hook.y - rope * Math.cos(angle)];
}).flat();

/** A beam of two rails and the struts between them, upright or along. */
function lattice(x: number, y: number, length: number, upright: boolean): Guide[] {
  const [wide, count] = [0.44, Math.round(length / 0.62)];
  const at = (way: number, off: number) => (upright ? [x + off, y + way] : [x + way, y + off]);
  const struts = Array.from({ length: count + 1 }, (_, n) => at((n / count) * length, n % 2 === 0 ? 0 : wide)).flat();
  return [
    { kind: 'curve', points: struts, opacity: 0.7 },
    ...[0, wide].map((off): Guide => ({ kind: 'curve', points: [...at(0, off), ...at(length, off)], bold: true })),
  ];
}

/** A crane that holds the chain: only to be seen. */
const still: readonly Guide[] = [
  { kind: 'curve', points: arc, dashed: true },
  ...lattice(-5.9, 0, hook.y + 0.44, true),
  ...lattice(-5.46, hook.y, 5.9, false),
];
