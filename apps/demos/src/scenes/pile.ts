import { DiscContacts, type Particle, Polyline, Random, substep, World } from '@mass/core';
import type { Point, Scene } from './scene.ts';

const g = 9.81;
const half = 10; // of the box
const high = 9;
const apart = 0.11; // from disc to disc, as they start
const rows = 70;
const [awake, asleep, ballGroup] = [1, 2, 3];

export const pile: Scene<'count' | 'friction' | 'tilt'> = {
  id: 'pile',
  figure: 'Sub-steps',
  title: 'A pile of thousands',
  summary:
    'A wall of loose discs that nothing holds. Every touch is a contact with friction, solved a little in each of four small steps and begun from what it was the step before; so thousands come to rest, and what rests falls asleep and costs next to nothing. Tap to blow a hole into the pile, drag the ball through it, tilt the box, or pour more in.',
  lookFor: 'The wall caves in, washes around the ball and comes to rest in a slope that friction alone holds up.',
  formula: String.raw`J_n\ge 0,\qquad |J_t|\le\mu J_n`,
  parameters: {
    count: { label: 'Discs', min: 100, max: 8000, step: 100, value: 3000, live: true },
    friction: { label: 'Friction', min: 0, max: 1, step: 0.05, value: 0.3, live: true },
    tilt: { label: 'Tilt', unit: '°', min: -30, max: 30, step: 1, value: 0, live: true },
  },
  light: { count: 1800 },
  show: { minX: -half - 0.4, maxX: half + 0.4, minY: -0.4, maxY: high },
  poster: 1.4,
  style: ({ series, accent, paper }) => ({
    particle: { minRadius: 0, fill: series[0] },
    groups: {
      [awake]: { colorBy: { by: 'speed', from: 0, to: 6, colors: [series[1], series[4], series[3]] } },
      [ballGroup]: { fill: accent, stroke: paper, strokeWidth: 2 },
    },
  }),

  build(values, seed) {
    const random = new Random(seed);
    const world = new World({ capacity: 8192, resolver: substep({ sleepSpeed: 0.06 }) });
    world.addContactGenerator(new DiscContacts());
    const corners = [-half, -half, half, half].map((x, n) => ({ x, y: n === 0 || n === 3 ? 4 * high : 0 }));
    world.addShape(new Polyline({ points: corners, thickness: 0.2, friction: 0.6 }));
    const ball = world.addParticle({ x: -3.2, y: 4.6, radius: 0.8, mass: 3000, friction: 0.5, group: ballGroup });
    const discs: Particle[] = [];
    const add = (x: number, y: number, vy = 0): void => {
      const radius = random.between(0.04, 0.053);
      discs.push(
        world.addParticle({ x, y, vy, radius, mass: 3000 * radius * radius, friction: values.friction, group: awake }),
      );
    };
    for (let n = 0; n < values.count; n++) {
      const row = n % rows;
      add(-half + 0.17 + (Math.floor(n / rows) + (row % 2) / 2) * apart, 0.17 + row * apart);
    }
    const blow = (at: Point): void => {
      world.wake();
      for (const disc of discs) {
        const [dx, dy] = [disc.x - at.x, disc.y - at.y + 0.5];
        const distance = Math.hypot(dx, dy);
        const push = (16 * Math.max(0, 2 - distance)) / 2;
        disc.applyImpulse((disc.mass * push * dx) / distance, (disc.mass * push * dy) / distance);
      }
    };
    return {
      world,
      actions: [{ key: 'b', label: 'Blow from below', run: () => blow({ x: random.between(-half, half), y: 0 }) }],
      tap: blow,
      takes: (particle) => particle === ball,
      beforeStep() {
        for (let n = 0; n < 40 && discs.length < values.count; n++) add((n - 19.5) * 0.48, high + 1, -8);
        while (discs.length > values.count) discs.pop()?.remove();
        const { gravity, particles } = world;
        const angle = (values.tilt * Math.PI) / 180;
        const x = g * Math.sin(angle);
        if (gravity.x !== x || gravity.y === 0) world.gravity = { x, y: -g * Math.cos(angle) };
        if (discs[0].friction !== values.friction) for (const disc of discs) disc.friction = values.friction;
        for (const { slot } of discs) particles.group[slot] = particles.asleep[slot] === 1 ? asleep : awake;
      },
      readouts: () => [
        { label: 'Contacts', value: world.contacts.count, digits: 0 },
        { label: 'Asleep', value: world.sleepingCount, digits: 0 },
      ],
    };
  },

  check(run) {
    const discs = Array.from({ length: 600 }, (_, n) => n + 1); // the first particle is the ball
    const [rough, smooth] = [0.8, 0].map((friction) => {
      const trial = run({ count: 600, friction });
      trial.run(6);
      const { particles, sleepingCount } = trial.setup.world;
      const { x, y, vy } = particles;
      const top = Math.max(...discs.map((n) => y[n]));
      trial.setup.tap?.({ x: -9, y: 0 });
      trial.run(0.2);
      const outside = discs.filter((n) => Math.abs(x[n]) > half || y[n] < 0).length;
      return { top, outside, sleepingCount, blown: discs.filter((n) => vy[n] > 1).length };
    });
    return [
      { name: 'discs that left the box', value: rough.outside + smooth.outside, atMost: 0 },
      { name: 'asleep after 6 s, of 600 and the ball', value: rough.sleepingCount, atLeast: 595 },
      { name: 'how much higher friction holds the slope, m', value: rough.top - smooth.top, atLeast: 1 },
      { name: 'discs that a tap throws up', value: rough.blown, atLeast: 50 },
    ];
  },
};
