import { type Body, box, Disc, DiscContacts, type DistanceLink, Random, Segment, severity, World } from '@mass/core';
import type { Scene } from './scene.ts';

const g = 9.81;
const pegs = [
  { x: -0.35, y: 1.45 },
  { x: 1.55, y: 3.45 },
  { x: -2.3, y: 1.75 },
];
const slopes = [
  [-5.9, 4.1, -1.3, 3.2],
  [5.3, 2.9, 0.9, 1.95],
  [5.3, 2.9, 5.6, 4.4],
  [-5.3, 2.1, -4.7, 0.7],
  [-4.7, 0.7, 4.4, 0],
];
const starts = [
  { x: -4.4, y: 4.75 },
  { x: 1.5, y: 4.35 },
  { x: 3.9, y: 3.3 },
  { x: -1.6, y: 2.6 },
];

export const aggregatesSquares: Scene<'squares' | 'side' | 'restitution'> = {
  id: 'aggregates-squares',
  figure: 'Figure 26',
  title: 'Squares made of four circles',
  summary:
    'Each square is four particles at its corners and six rods. The engine knows no rotation: there is no angle and no torque anywhere in it. A corner that meets a peg is stopped, the rods pull the others round it, and the square turns. What resists the turning is where the masses are, m·s²/2. What falls out below comes in again above; take hold of a corner and throw.',
  lookFor: 'The squares tumble and turn though nothing but points moves, and they keep their shape.',
  formula: String.raw`I=\sum_i m_i\,|\mathbf r_i|^2=\frac{m\,s^2}{2},\qquad\omega=\frac1I\sum_i m_i\,\mathbf r_i\times\mathbf v_i`,
  parameters: {
    squares: { label: 'Squares', min: 1, max: 14, step: 1, value: 9 },
    side: { label: 'Side', unit: 'm', min: 0.45, max: 0.85, step: 0.05, value: 0.65 },
    restitution: { label: 'Restitution', min: 0, max: 0.8, step: 0.05, value: 0.35 },
  },
  show: { minX: -6.1, maxX: 6.1, minY: -0.55, maxY: 5.1 },
  step: 1 / 240,
  poster: 2.6,
  style: ({ series, paper }) => ({
    particle: { stroke: paper, strokeWidth: 1 },
    groups: Object.fromEntries([1, 3, 4, 5].map((color, n) => [n, { fill: series[color] }])),
    bodies: { skeleton: true, fillAlpha: 0.22, strokeWidth: 0, mark: false },
    links: { rod: { width: 2 } },
  }),

  build({ squares, side, restitution }, seed) {
    const world = new World({ gravity: { x: 0, y: -g }, resolver: severity({ iterations: 400 }) });
    const random = new Random(seed);
    world.addContactGenerator(new DiscContacts());
    for (const [x0, y0, x1, y1] of slopes) {
      world.addShape(new Segment({ a: { x: x0, y: y0 }, b: { x: x1, y: y1 }, thickness: 0.12 }));
    }
    for (const centre of pegs) world.addShape(new Disc({ centre, radius: 0.17 }));

    const bodies: Body[] = [];
    const drop = (place: number, at: { x: number; y: number }): void => {
      bodies[place] = world.addBody(
        box({
          ...at,
          width: side,
          height: side,
          mass: 4,
          radius: side / 3.9, // so that no corner gets in between those of another
          restitution,
          angle: random.between(0, Math.PI / 2),
          angularVelocity: random.between(-3, 3),
          group: place % 4,
        }),
      );
    };
    for (const [place, at] of starts.slice(0, squares).entries()) drop(place, at);
    let last = 0;

    return {
      world,
      beforeStep() {
        for (const body of bodies) if (body.alive && body.y < -1.2) world.removeBody(body);
        if (world.time - last < 0.8) return;
        const place = bodies.findIndex(({ alive }) => !alive);
        if (place < 0 && bodies.length >= squares) return;
        drop(place < 0 ? bodies.length : place, { x: random.between(-5.4, -4.2), y: 5.9 });
        last = world.time;
      },
      readouts: () => [
        {
          label: 'Fastest turning',
          value: Math.max(0, ...world.bodies.map(({ angularVelocity }) => Math.abs(angularVelocity))),
          unit: 'rad/s',
          digits: 1,
        },
        { label: 'Greatest strain', value: 100 * strainOf(world), unit: '%', digits: 3 },
      ],
    };
  },

  check(run) {
    const trial = run();
    const { world } = trial.setup;
    const spins = world.bodies.map(({ angularVelocity }) => angularVelocity);
    trial.run(0.1);
    const free = world.bodies[3]; // still in free fall
    const drift = Math.abs(free.angularVelocity / spins[3] - 1);
    let [strain, overlap, left, right] = [0, 0, 0, 0];
    trial.run(12, () => {
      strain = Math.max(strain, strainOf(world));
      for (const { angularVelocity } of world.bodies) {
        left = Math.max(left, angularVelocity);
        right = Math.max(right, -angularVelocity);
      }
      overlap = Math.max(overlap, overlapOf(world));
    });
    return [
      { name: 'change of the turning in free fall, as a share', value: drift, atMost: 0.01 },
      { name: 'fastest turning to the left, rad/s', value: left, atLeast: 3 },
      { name: 'fastest turning to the right, rad/s', value: right, atLeast: 3 },
      { name: 'strain of any rod at any time', value: strain, atMost: 0.01 },
      { name: 'overlap of two circles, as a share of the radius', value: overlap, atMost: 0.05 },
    ];
  },
};

/** How far any rod is off its length, as a share of it. */
export function strainOf({ links }: World): number {
  return Math.max(0, ...(links as readonly DistanceLink[]).map(({ strain }) => Math.abs(strain)));
}

/** How deep two circles of different bodies are in each other, at most, as a share of the radius. */
export function overlapOf({ bodies }: World): number {
  let most = 0;
  for (const [n, one] of bodies.entries()) {
    for (const other of bodies.slice(0, n)) {
      if (Math.hypot(one.x - other.x, one.y - other.y) > 2) continue;
      for (const a of one.particles) {
        for (const b of other.particles) {
          most = Math.max(most, 1 + (b.radius - Math.hypot(a.x - b.x, a.y - b.y)) / a.radius);
        }
      }
    }
  }
  return most;
}
