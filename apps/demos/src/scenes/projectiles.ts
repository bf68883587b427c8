import { World } from '@mass/core';
import { arcOf, Flight } from './ballistics.ts';
import type { Guide, Scene } from './scene.ts';

// The thesis gives pixels, y down; here at 20 pixels a metre, y up.
const kinds = [
  { name: 'Pistol', mass: 2, vx: 17.5, vy: 0, ay: -0.5, damping: 0.99, radius: 0.4 },
  { name: 'Artillery', mass: 200, vx: 20, vy: 15, ay: -10, damping: 0.99, radius: 0.8 },
  { name: 'Fireball', mass: 1, vx: 12.5, vy: 0, ay: 1.5, damping: 0.9, radius: 0.6 },
  { name: 'Laser', mass: 0.1, vx: 50, vy: 0, ay: 0, damping: 0.99, radius: 0.3 },
];
const flightTime = 4;

export const projectiles: Scene<'speed' | 'gravity'> = {
  id: 'projectiles',
  figure: 'Chapter 5',
  title: 'Four projectiles',
  summary:
    'Real muzzle speeds do not play well: a bullet is gone within a frame. So each kind flies at a speed that the eye can follow, gravity is weakened to match, and mass is raised so that hits tell. Each dotted line is the closed form of its flight, with a the acceleration and d the share of the velocity that is kept each second.',
  lookFor:
    'Four arcs from one point: the fireball rises, the laser is straight, and each keeps to the line drawn for it beforehand.',
  formula: String.raw`\mathbf{x}(t)=\mathbf{x}_0+\Bigl(\mathbf{v}_0+\frac{\mathbf{a}}{\lambda}\Bigr)\frac{e^{\lambda t}-1}{\lambda}-\frac{\mathbf{a}}{\lambda}\,t,\qquad\lambda=\ln d`,
  parameters: {
    speed: { label: 'Muzzle speed', unit: '×', min: 0.5, max: 1.5, step: 0.05, value: 1, live: true },
    gravity: { label: 'Gravity', unit: '×', min: 0, max: 2, step: 0.05, value: 1, live: true },
  },
  show: { minX: -2, maxX: 64, minY: -9, maxY: 15 },
  style: ({ series }) => ({
    groups: kinds.map((_, kind) => ({ fill: series[kind + 1], minRadius: 4, trail: { seconds: 0.35, width: 5 } })),
  }),

  build(values) {
    const world = new World();
    let flights: Flight[] = [];
    let aimed = false;

    function fire(kind: number): void {
      const { mass, radius, damping, vx, vy, ay } = kinds[kind];
      const { speed, gravity } = values;
      const thrown = { x: 0, y: 0, vx: vx * speed, vy: vy * speed, ax: 0, ay: ay * gravity, damping };
      const particle = world.addParticle({ ...thrown, mass, radius, group: kind, lifetime: flightTime });
      flights.push(new Flight(particle, thrown, world.time));
    }

    return {
      world,
      actions: kinds.map(({ name }, kind) => ({
        key: `${kind + 1}`,
        label: name,
        group: kind,
        run() {
          aimed = true;
          fire(kind);
        },
      })),
      beforeStep() {
        flights = flights.filter(({ particle }) => particle.alive);
        for (const flight of flights) flight.follow(world.time);
        // Until somebody takes aim, the battery fires by itself, one kind after the other.
        if (!aimed && world.stepCount % 45 === 0) fire([1, 2, 0, 3][(world.stepCount / 45) % 4]);
      },
      guides: () => [
        { kind: 'circle', x: 0, y: 0, radius: 0.9 },
        ...flights.map(
          ({ thrown, group }): Guide => ({
            kind: 'curve',
            points: arcOf(thrown, flightTime),
            dashed: true,
            tone: group,
          }),
        ),
      ],
      readouts: () => [
        { label: 'Off the line', value: 100 * Math.max(0, ...flights.map(({ error }) => error)), unit: '%' },
      ],
    };
  },

  check: (run) =>
    kinds.flatMap(({ name, vx, vy, ay, damping }, kind) => {
      const trial = run();
      trial.press(`${kind + 1}`);
      const particle = trial.setup.world.particleAt(0);
      const flight = new Flight(particle, { x: 0, y: 0, vx, vy, ax: 0, ay, damping }, 0);
      let error = 0;
      trial.run(flightTime - 0.1, () => {
        flight.follow(trial.setup.world.time);
        error = Math.max(error, flight.error);
      });
      const height = [-4, -18, 10, 0][kind];
      return [
        { name: `${name}: share of the way that it is off its closed form`, value: error, atMost: 0.01 },
        { name: `${name}: height after the flight`, value: particle.y, atLeast: height - 0.5, atMost: height + 0.5 },
      ];
    }),
};
