import { type Body, box, EdgeContacts, HalfPlane, World } from '@mass/core';
import { Again } from './again.ts';
import type { Point, Scene } from './scene.ts';

const g = 9.81;
const size = 0.9; // from corner to corner; a corner is a particle with a radius
const radius = 0.05;
const pitch = size + 2 * radius;
const drop = 0.03; // from row to row, as they start
const speed = 18; // of the ball
const [awake, asleep, ballGroup] = [1, 2, 3];

export const boxStack: Scene<'rows' | 'friction' | 'load'> = {
  id: 'box-stack',
  figure: 'Sub-steps',
  title: 'A stack of boxes',
  summary:
    'Each box is four particles and six rods. The engine sees that they hold one shape, and moves it as a rigid body: what pushes a corner pushes the box. Edges meet corners, friction holds them, and the load goes down from row to row. A stack that stands is put to sleep as a whole, and costs nothing until something touches it. Click or tap where the ball shall hit, or take it, or a box by its corner.',
  lookFor: 'The boxes settle, fall asleep where they stand, and wake all at once when the ball comes.',
  formula: String.raw`\sum_i m_i\,|\mathbf v_i|^2\to 0,\qquad |J_t|\le\mu J_n`,
  parameters: {
    rows: { label: 'Rows', min: 2, max: 9, step: 1, value: 7 },
    friction: { label: 'Friction', min: 0, max: 1, step: 0.05, value: 0.6 },
    load: { label: 'The ball, in boxes', min: 1, max: 50, step: 1, value: 8, live: true },
  },
  show: { minX: -11.2, maxX: 11.2, minY: -0.6, maxY: 9.4 },
  poster: 2.9,
  style: ({ series, accent, paper }) => ({
    particle: { fill: series[0] },
    groups: {
      [awake]: { fill: series[3] },
      [asleep]: { fill: series[1] },
      [ballGroup]: { fill: accent, stroke: paper, strokeWidth: 2 },
    },
    bodies: { mark: false, fillAlpha: 0.4 },
  }),

  build(values) {
    const { rows, friction } = values;
    const world = new World({ gravity: { x: 0, y: -g } });
    world.addContactGenerator(new EdgeContacts(world));
    const walls = [-10.6, 10.6].map((x) => ({ point: { x, y: 0 }, normal: { x: -x, y: 0 } }));
    for (const wall of [{}, ...walls]) world.addShape(new HalfPlane({ ...wall, friction: 0.6 }));
    const ball = world.addParticle({ x: -8, y: 0.55, radius: 0.55, friction: 0.3, group: ballGroup });
    let boxes: Body[] = [];
    let thrown = false;
    const again = new Again([world], 10, 'a', 'Build again', () => {
      for (const each of boxes) if (each.alive) each.remove();
      boxes = [];
      for (let row = 0; row < rows; row++) {
        for (let n = row; n < rows; n++) {
          const x = (n - (row + rows - 1) / 2) * (pitch + 0.1);
          const y = pitch / 2 + drop + row * (pitch + drop);
          boxes.push(world.addBody(box({ x, y, width: size, height: size, radius, friction, group: awake })));
        }
      }
      Object.assign(ball, { x: -8, y: 0.55, vx: 0, vy: 0 });
      thrown = false;
    });
    again.action.run();
    const aim = (at: Point): void => {
      const [x, y] = [-9.8, 1.5];
      const time = Math.max(1, at.x - x) / speed;
      Object.assign(ball, { x, y, vx: speed, vy: (at.y - y) / time + (g * time) / 2 });
      thrown = true;
    };
    const hit = (): void => aim({ x: 0, y: rows * 0.45 });
    let begun = 0;
    return {
      world,
      actions: [{ key: 't', label: 'Throw the ball', run: hit }, again.action],
      tap: aim,
      beforeStep(dt) {
        again.beforeStep();
        begun = thrown || again.touched ? 0 : begun + dt;
        if (begun > 2.4) hit();
        if (ball.mass !== values.load) ball.mass = values.load;
        const { group, asleep: sleeps } = world.particles;
        for (const { particles } of boxes)
          for (const { slot } of particles) group[slot] = sleeps[slot] === 1 ? asleep : awake;
      },
      readouts: () => [
        { label: 'Boxes', value: boxes.length, digits: 0 },
        { label: 'Contacts', value: world.contacts.count, digits: 0 },
        { label: 'Asleep', value: world.sleepingCount, digits: 0 },
      ],
    };
  },

  check(run) {
    const { setup, run: go, press } = run();
    const { world } = setup;
    const { bodies } = world;
    const placed = bodies.map(({ x, y }) => ({ x, y }));
    go(2);
    const settled = world.sleepingCount / world.particleCount;
    const top = bodies[bodies.length - 1];
    const sunk = 7 * pitch - pitch / 2 - top.y;
    const astray = Math.max(...bodies.map(({ x }, n) => Math.abs(x - placed[n].x)));
    press('t');
    const start = energyOf(world);
    let most = 0;
    go(7, () => {
      most = Math.max(most, energyOf(world) / start);
    });
    const fallen = bodies.filter(({ y }, n) => y < placed[n].y - 0.5).length;
    return [
      { name: 'share that sleeps after 2 s', value: settled, atLeast: 1 },
      { name: 'how deep the top box has sunk, m', value: sunk, atMost: 0.05, atLeast: -0.01 },
      { name: 'how far a box has slid sideways, m', value: astray, atMost: 0.05 },
      { name: 'boxes that the ball brings down', value: fallen, atLeast: 8 },
      { name: 'energy at any time after the throw, as a share of that before', value: most, atMost: 1.001 },
      { name: 'energy that is left', value: energyOf(world) / start, atMost: 0.5 },
    ];
  },
};

/** Kinetic and potential. Unit: J. */
function energyOf({ particles: { count, mass, y, vx, vy } }: World): number {
  let sum = 0;
  for (let i = 0; i < count; i++) sum += mass[i] * ((vx[i] ** 2 + vy[i] ** 2) / 2 + g * y[i]);
  return sum;
}
