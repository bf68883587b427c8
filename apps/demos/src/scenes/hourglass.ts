import { Box, DiscContacts, type Particle, Polyline, Random, Segment, type Shape, World } from '@mass/core';
import type { Point, Scene } from './scene.ts';

const g = 2.5;
const sand = 2.69; // diameter of one grain, had all the sand gone into one, m
const [wide, tall, shoulder] = [1.85, 3.7, 2.7];
const turning = 1.4; // s

/** From the axis to the glass, at a height. */
function widthAt(y: number, neck: number): number {
  const t = Math.min(1, Math.abs(y) / shoulder);
  const round = Math.max(0, (Math.abs(y) - tall + 0.5) / 0.5);
  return neck / 2 + (wide * (1 - Math.cos(Math.PI * t))) / 2 - 0.5 * (1 - Math.sqrt(1 - Math.min(1, round) ** 2));
}

export const hourglass: Scene<'count' | 'neck' | 'friction'> = {
  id: 'hourglass',
  figure: 'Sub-steps',
  title: 'An hourglass',
  summary:
    'Five thousand grains with friction, none of which knows of the glass as a whole. Grains hold each other up by arches that form and break above the neck, and carry most of the weight to the walls: so sand runs out at the same rate however high it stands, where water would slow down. That is why there are hourglasses. Gravity is a quarter of the Earth’s, to leave time to look. Narrow the neck, or make the grains rougher, and an arch may hold for good: then turn it over.',
  lookFor: 'The sand sinks in a funnel, and as many grains a second run through at the end as at the start.',
  formula: String.raw`\dot n\;\propto\;\sqrt{g}\,(D-k\,d)^{3/2},\qquad\text{whatever the height}`,
  parameters: {
    count: { label: 'Grains', min: 500, max: 5000, step: 100, value: 5000 },
    neck: { label: 'Neck, in grains', min: 3, max: 14, step: 0.5, value: 8 },
    friction: { label: 'Friction', min: 0, max: 1, step: 0.05, value: 0.3, live: true },
  },
  light: { count: 1500 },
  show: { minX: -3.2, maxX: 3.2, minY: -4.4, maxY: 4.4 },
  poster: 5,
  style: ({ series, accent, ink }) => ({
    particle: { minRadius: 0 },
    groups: { 1: { fill: series[3] }, 2: { fill: accent } },
    shapes: { stroke: series[0], fill: ink, hatch: null },
  }),

  build(values, seed) {
    const random = new Random(seed);
    const { count } = values;
    const grain = sand / Math.sqrt(count);
    const neck = values.neck * grain;
    const world = new World({ gravity: { x: 0, y: -g }, capacity: count });
    world.addContactGenerator(new DiscContacts());
    const grains: Particle[] = [];
    for (let row = 0; grains.length < count; row++) {
      const y = 0.15 + row * grain * 0.92;
      const room = widthAt(y, neck) - grain * 0.8;
      for (let x = -room + random.between(0, grain); x < room && grains.length < count; x += grain * 1.1) {
        const radius = grain * random.between(0.42, 0.54);
        const group = 1 + (Math.floor(y / 0.36) % 2);
        grains.push(world.addParticle({ x, y, radius, mass: 1e4 * radius * radius, friction: values.friction, group }));
      }
    }
    let angle = 0;
    let since = turning;
    let shapes: readonly Shape[] = [];
    const place = (): void => {
      for (const shape of shapes) world.removeShape(shape);
      shapes = glass(neck, angle);
      for (const shape of shapes) world.addShape(shape);
    };
    place();
    const turn = (): void => {
      if (since >= turning) since = 0;
    };
    const above = (): number => world.particles.y.subarray(0, count).reduce((sum, y) => sum + (y > 0 ? 1 : 0), 0);
    return {
      world,
      actions: [{ key: 't', label: 'Turn over', run: turn }],
      tap: turn,
      takes: ({ y }) => Math.abs(y) > 1.7,
      hand: { frequency: 15 },
      beforeStep(dt) {
        if (grains[0].friction !== values.friction) for (const each of grains) each.friction = values.friction;
        if (since >= turning && world.stepCount % 120 === 119 && above() === 0) turn();
        if (since >= turning) return;
        const part = (time: number): number => (Math.PI * (1 - Math.cos((Math.PI * time) / turning))) / 2;
        const by = part(Math.min(turning, since + dt)) - part(since);
        since += dt;
        angle += by;
        rotate(world, by);
        place();
      },
      readouts: () => [{ label: 'Grains above', value: above(), digits: 0 }],
    };
  },

  check(run) {
    const flow = run({ count: 1200 });
    const { particles } = flow.setup.world;
    const above = (): number => flow.setup.readouts?.()[0].value ?? Number.NaN;
    const counts: number[] = [];
    for (let n = 0; n < 6; n++) {
      flow.run(1.5);
      counts.push(above());
    }
    const [early, late] = [counts[0] - counts[2], counts[3] - counts[5]];
    const outside = particles.x.subarray(0, 1200).filter((x, n) => Math.abs(x) > widthAt(particles.y[n], 0.65)).length;
    flow.press('t');
    flow.run(2);
    const turned = above();
    const jammed = run({ count: 1200, neck: 3, friction: 1 });
    jammed.run(4);
    return [
      { name: 'grains through in 3 s', value: early, atLeast: 100 },
      { name: 'late, with less sand above, as a share of early', value: late / early, atLeast: 0.8, atMost: 1.25 },
      { name: 'grains outside the glass', value: outside, atMost: 0 },
      { name: 'grains above once it was turned over', value: turned, atLeast: 1000 },
      { name: 'grains that a narrow neck holds back', value: jammed.setup.readouts?.()[0].value ?? 0, atLeast: 900 },
    ];
  },
};

function rotate({ particles: { count, x, y, vx, vy } }: World, by: number): void {
  const [c, s] = [Math.cos(by), Math.sin(by)];
  for (let i = 0; i < count; i++) {
    [x[i], y[i]] = [c * x[i] - s * y[i], s * x[i] + c * y[i]];
    [vx[i], vy[i]] = [c * vx[i] - s * vy[i], s * vx[i] + c * vy[i]];
  }
}

/** Glass, lids and posts, turned by an angle. */
function glass(neck: number, angle: number): Shape[] {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const at = (x: number, y: number): Point => ({ x: c * x - s * y, y: s * x + c * y });
  const side = Array.from({ length: 81 }, (_, n) => tall * Math.sin(((n - 40) / 80) * Math.PI));
  const points = [
    ...side.map((y) => at(widthAt(y, neck) + 0.03, y)),
    ...side.toReversed().map((y) => at(-widthAt(y, neck) - 0.03, y)),
  ];
  return [
    new Polyline({ points, closed: true, thickness: 0.06, friction: 0.3 }),
    ...[-1, 1].map((end) => new Box({ centre: at(0, end * 3.95), width: 5, height: 0.4, angle })),
    ...[-1, 1].map((end) => new Segment({ a: at(end * 2.3, -3.8), b: at(end * 2.3, 3.8), thickness: 0.12 })),
  ];
}
