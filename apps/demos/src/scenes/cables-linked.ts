import { Box, cable, chain, DiscContacts, type DistanceLink, severity, World } from '@mass/core';
import { Stillness } from './floats.ts';
import type { Guide, Point, Scene } from './scene.ts';

const g = 9.81;
const post = 5.6;
const height = 3.2;
const drop = 0.62;
const corePart = 0.15;

/** Where equal weights rest on a cable of equal links that spans a width, from its left end: at equal steps of the slope. */
function restOf(width: number, length: number, links: number): Point[] {
  const slopes = Array.from({ length: links }, (_, n) => n - (links - 1) / 2);
  const each = length / links;
  const reach = (steep: number): number => slopes.reduce((sum, s) => sum + each / Math.hypot(1, s * steep), 0);
  let [low, high] = [0, 1000];
  for (let n = 0; n < 80; n++) {
    const middle = (low + high) / 2;
    if (reach(middle) > width) low = middle;
    else high = middle;
  }
  const points: Point[] = [{ x: 0, y: 0 }];
  for (const s of slopes) {
    const { x, y } = points[points.length - 1];
    const run = each / Math.hypot(1, s * low);
    points.push({ x: x + run, y: y + run * s * low });
  }
  return points;
}

export const cablesLinked: Scene<'links' | 'slack' | 'mass'> = {
  id: 'cables-linked',
  figure: 'Figure 22',
  title: 'Cables that hang on cables',
  summary:
    'Two strings of lights, held straight and let go: each lamp hangs on a cable, which hangs on a string of cables. All is slack at first and falls freely, until one cable after the other is taut. At rest each link carries the lamps between it and the middle, so that its slope grows by the same amount from each to the next: the dotted line, drawn beforehand. Shake a lamp; the mass of the lamps does not change the shape.',
  lookFor: 'The strings come to rest on the dotted line, and no cable ever grows longer than it is.',
  formula: String.raw`|\mathbf p_a-\mathbf p_b|\le L,\qquad\text{at rest:}\quad\tan\alpha_{i+1}-\tan\alpha_i=\frac{m\,g}{H}`,
  parameters: {
    links: { label: 'Links of a string', min: 2, max: 10, step: 1, value: 7 },
    slack: { label: 'Length over span', unit: '×', min: 1.02, max: 1.5, step: 0.01, value: 1.14 },
    mass: { label: 'Mass of a lamp', unit: 'kg', min: 0.2, max: 3, step: 0.1, value: 1 },
  },
  show: { minX: -6.3, maxX: 6.3, minY: -0.3, maxY: 3.9 },
  step: 1 / 240,
  poster: 1.2,
  style: ({ series, quiet, dark }) => ({
    particle: { fill: quiet, minRadius: 2.5 },
    groups: { 1: { fill: series[3], stroke: dark ? '#fff3c4' : '#8a5f00', strokeWidth: 1.5 } },
    links: { cable: { width: 1.5 }, chain: { width: 2.25 } },
  }),

  build({ links, slack, mass }) {
    const world = new World({ gravity: { x: 0, y: -g }, resolver: severity({ iterations: 500 }) });
    world.addContactGenerator(new DiscContacts());
    const length = post * slack;
    const rest = restOf(post, length, links);
    const still: Guide[] = [];
    const strings = [-post, 0].map((left) => {
      const from = { x: left, y: height };
      const body = world.addBody(
        chain({ from, to: { x: left + post, y: height }, links, length, mass: corePart * (links - 1), damping: 0.75 }),
      );
      const lamps = body.particles.map(({ x, y }) =>
        world.addParticle({ x, y: y - drop, mass, radius: 0.19, damping: 0.75, restitution: 0.3, group: 1 }),
      );
      for (const [n, lamp] of lamps.entries()) world.addLink(cable(body.particles[n], lamp));
      still.push({
        kind: 'curve',
        points: rest.flatMap(({ x, y }) => [left + x, height + y]),
        dashed: true,
        tone: 'accent',
      });
      for (const { x, y } of rest.slice(1, -1)) {
        still.push({ kind: 'circle', x: left + x, y: height + y - drop, radius: 0.25, tone: 'accent', opacity: 0.6 });
      }
      return { left, knots: body.particles, lamps };
    });
    for (const x of [-post, 0, post]) {
      world.addShape(new Box({ centre: { x, y: (height - 1.2) / 2 }, width: 0.16, height: height + 1.2 }));
    }

    const lift = (): void => {
      for (const { left, knots, lamps } of strings) {
        for (const [n, knot] of knots.entries()) {
          const x = left + (post * (n + 1)) / links;
          Object.assign(knot, { x, y: height, vx: 0, vy: 0 });
          Object.assign(lamps[n], { x, y: height - 0.1, vx: left < 0 ? 1.6 + 0.15 * n : -0.9, vy: 0 });
        }
      }
    };
    lift();
    const calm = new Stillness(2.5);
    const strain = (): number => Math.max(...(world.links as readonly DistanceLink[]).map((link) => link.strain));

    return {
      world,
      actions: [
        { key: 'h', label: 'Lift and let go', run: lift },
        {
          key: 'w',
          label: 'Gust of wind',
          run() {
            for (const { lamps } of strings)
              for (const lamp of lamps) lamp.applyImpulse(3.2 * lamp.mass, 0.6 * lamp.mass);
          },
        },
      ],
      beforeStep(dt) {
        if (calm.has(world, dt)) lift();
      },
      guides: () => still,
      readouts: () => [
        { label: 'Greatest strain', value: 100 * Math.max(0, strain()), unit: '%', digits: 3 },
        {
          label: 'Off the line at rest',
          value:
            100 *
            offRest(
              strings.flatMap(({ left, knots }) => knots.map(({ x, y }, n) => [x - left, y, n + 1])),
              rest,
            ),
          unit: 'cm',
          digits: 1,
        },
      ],
    };
  },

  check(run) {
    const trial = run();
    const { world } = trial.setup;
    let strain = 0;
    const look = (): void => {
      for (const { strain: now } of world.links as readonly DistanceLink[]) strain = Math.max(strain, now);
    };
    trial.run(0.2, look);
    const fall = height - 0.1 - world.particleAt(6).y;
    trial.run(11.8, look);
    const knots = Array.from({ length: 6 }, (_, n) => world.particleAt(n));
    const off = offRest(
      knots.map(({ x, y }, n) => [x + post, y, n + 1]),
      restOf(post, post * 1.14, 7),
    );
    return [
      { name: 'a lamp falls freely while its cable is slack: m in 0.2 s', value: fall, atLeast: 0.17, atMost: 0.21 },
      { name: 'greatest strain of any cable at any time', value: strain, atMost: 0.02 },
      { name: 'how far a knot is off the law at rest, m', value: off, atMost: 0.01 },
    ];
  },
};

/** How far the knots (x from the left end, y, place) are off their rest, at most. Unit: m. */
function offRest(knots: readonly number[][], rest: readonly Point[]): number {
  return Math.max(...knots.map(([x, y, n]) => Math.hypot(x - rest[n].x, y - height - rest[n].y)));
}
