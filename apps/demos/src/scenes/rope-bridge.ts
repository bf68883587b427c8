import {
  Box,
  Buoyancy,
  cable,
  chain,
  type DistanceLink,
  EdgeContacts,
  type Particle,
  Polygon,
  substep,
  World,
} from '@mass/core';
import { Again } from './again.ts';
import type { Guide, Point, Scene } from './scene.ts';

const g = 9.81;
const half = 6; // of the way between the ends
const length = 13;
const water = -3.1;
const thick = 0.07;
const rail = 1.1;

export const ropeBridge: Scene<'load' | 'planks'> = {
  id: 'rope-bridge',
  figure: 'Sub-steps',
  title: 'A rope bridge',
  summary:
    'Planks are rods joined end to end, ropes are cables, and the ball is heavy. A solver that passes the load from link to link would let the bridge stretch like rubber; this one solves all that hangs together at once, and keeps it to length. The heavier the ball, the straighter it pulls both halves: in the end the way from one end to the other by the ball is the whole length of the bridge, and the ball rolls along an ellipse. Push it, drag it, pull at the planks, or cut the ropes.',
  lookFor: 'The ball bends the bridge wherever it is, and never leaves the dotted ellipse around the two ends.',
  formula: String.raw`|\mathbf p-\mathbf a|+|\mathbf p-\mathbf b|\le L,\qquad\frac{x^2}{(L/2)^2}+\frac{y^2}{(L/2)^2-c^2}=1`,
  parameters: {
    load: { label: 'The ball', unit: 'kg', min: 20, max: 400, step: 20, value: 200 },
    planks: { label: 'Planks', min: 8, max: 40, step: 1, value: 22 },
  },
  show: { minX: -8.6, maxX: 8.6, minY: -4.3, maxY: 2.2 },
  poster: 2.1,
  style: ({ ink, accent, series, paper, quiet }) => ({
    particle: { fill: quiet, minRadius: 1.5 },
    groups: { 1: { fill: accent, stroke: paper, strokeWidth: 1.5 }, 2: { fill: ink } },
    links: { rod: { color: series[3], width: 7 }, cable: { color: quiet, width: 1.25 } },
    liquids: { fill: series[1], alpha: 0.16 },
    pins: null,
  }),

  build({ load, planks }) {
    const world = new World({ gravity: { x: 0, y: -g }, resolver: substep({ subSteps: 8 }) });
    world.addContactGenerator(new EdgeContacts(world));
    world.addForce(new Buoyancy({ level: water, k1: 60, k2: 200 }));
    for (const side of [-1, 1]) {
      const at = (x: number, y: number): Point => ({ x: side * x, y });
      const rock = [at(half, thick), at(10, thick), at(10, -5), at(5.1, -5), at(5.4, -3.4), at(5.9, -2.2), at(5.7, -1)];
      world.addShape(new Polygon({ points: rock }));
      world.addShape(new Box({ centre: at(9.1, 0.6), width: 1, height: 1.4 }));
    }
    const [from, to] = [-half, half].map((x) =>
      world.addParticle({ x, y: 0, mass: Infinity, radius: thick, group: 2 }),
    );
    const radius = 0.3 + 0.016 * Math.sqrt(load);
    const ball = world.addParticle({ x: 0, y: 0, mass: load, radius, restitution: 0.3, group: 1 });
    const posts = [from, to].map(({ x }) => world.addParticle({ x, y: rail, mass: Infinity, group: 2 }));
    let parts: readonly Particle[] = [];
    /** A deck of rods, above it as long a rope, and cables between the two. */
    const build = (): void => {
      for (const part of parts) part.remove();
      const deck = world.addBody(
        chain({
          from,
          to,
          length,
          links: planks,
          kind: 'rod',
          mass: 200,
          radius: thick,
          damping: 0.9,
          linkDamping: 0.3,
        }),
      );
      const rope = deck.particles.map(({ x, y }) =>
        world.addParticle({ x, y: y + rail, mass: 50 / planks, damping: 0.9 }),
      );
      const knots = [posts[0], ...rope, posts[1]];
      for (const [n, knot] of knots.slice(1).entries()) world.addLink(cable(knots[n], knot));
      for (const [n, knot] of rope.entries()) world.addLink(cable(deck.particles[n], knot));
      parts = [...deck.particles, ...rope];
    };
    const again = new Again([world], 15, 'a', 'Begin again', () => {
      build();
      Object.assign(ball, { x: -half - 0.8, y: radius + thick, vx: 3.2, vy: 0 });
    });
    again.action.run();

    const push = (speed: number) => () => ball.applyImpulse(speed * load, 0);
    const cut = (): void => {
      for (const link of world.links) if (link.a === from || link.a === posts[0]) world.removeLink(link);
    };
    return {
      world,
      actions: [
        { key: 'ArrowLeft', label: 'Push left', run: push(-1.5) },
        { key: 'ArrowRight', label: 'Push right', run: push(1.5) },
        { key: 'c', label: 'Cut the ropes', run: cut },
        again.action,
      ],
      beforeStep: () => again.beforeStep(),
      guides: () => still,
      readouts: () => [
        { label: 'Way from end to end by the ball', value: wayBy(ball), unit: 'm' },
        { label: 'Length of the bridge', value: length, unit: 'm' },
        { label: 'Greatest strain', value: 100 * strainOf(world), unit: '%', digits: 2 },
      ],
    };
  },

  check(run) {
    const [light, heavy] = [20, 400].map((load) => {
      const { setup, run: go } = run({ load });
      const ball = setup.world.particleAt(2);
      let [right, most, strain, sum, steps] = [0, 0, 0, 0, 0];
      go(10, () => {
        const way = wayBy(ball);
        right = Math.max(right, ball.x);
        most = Math.max(most, way);
        strain = Math.max(strain, strainOf(setup.world));
        if (setup.world.time > 2) [sum, steps] = [sum + way, steps + 1];
      });
      return { right, most, strain, mean: sum / steps };
    });
    const fallen = run();
    fallen.run(2);
    fallen.press('c');
    fallen.run(6);
    const ball = fallen.setup.world.particleAt(2);
    return [
      { name: 'a light ball rolls beyond the middle, m', value: light.right, atLeast: 2 },
      { name: 'so does a heavy one', value: heavy.right, atLeast: 2 },
      { name: 'way by the light ball, m', value: light.most, atMost: length * 1.001 },
      { name: 'way by the heavy ball, m', value: heavy.most, atMost: length * 1.001 },
      { name: 'the heavy ball bends the bridge more, m', value: heavy.mean - light.mean, atLeast: 0.05 },
      { name: 'strain of any link at any time', value: Math.max(light.strain, heavy.strain), atMost: 0.03 },
      { name: 'after the cut the ball floats, m above the water', value: ball.y - water, atLeast: -0.5, atMost: 0.6 },
    ];
  },
};

/** From end to end by the place where a ball touches the bridge; 0 where it is not on it. */
function wayBy({ x, y, radius }: Particle): number {
  const low = y - radius - thick;
  return Math.abs(x) < half ? Math.hypot(x + half, low) + Math.hypot(x - half, low) : 0;
}

/** What a weight on a rope without one reaches: the lower half of an ellipse around the two ends. */
const still: readonly Guide[] = [
  {
    kind: 'curve',
    points: Array.from({ length: 121 }, (_, n) => {
      const angle = (n / 120) * Math.PI;
      return [(-length / 2) * Math.cos(angle), -Math.sqrt(length ** 2 / 4 - half ** 2) * Math.sin(angle)];
    }).flat(),
    dashed: true,
  },
  ...[-half, half].map((x): Guide => ({ kind: 'curve', points: [x, 0, x, rail + 0.15], tone: 'ink', bold: true })),
];

function strainOf({ links }: World): number {
  return Math.max(0, ...(links as readonly DistanceLink[]).map(({ strain }) => Math.abs(strain)));
}
