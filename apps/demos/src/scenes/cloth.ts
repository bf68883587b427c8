import { cloth as clothBody, type DistanceLink, type Particle, PointerSpring, Wind, World } from '@mass/core';
import type { Point, Scene } from './scene.ts';

const g = 9.81;
const width = 4.6;
const height = 2.2;
const top = 1.2;
/** What it hangs on is as much narrower: it hangs in bows, so deep as a share of their width. */
const narrow = 0.92;
const sag = Math.sqrt((3 / 8) * (1 / narrow - 1));

export const cloth: Scene<'size' | 'hung' | 'wind' | 'strength'> = {
  id: 'cloth',
  figure: 'Sub-steps',
  title: 'Cloth that tears',
  summary:
    'Rows of particles, each joined to its neighbours by threads that give a little: strain is force times compliance. The colour of a thread is its strain. Pull at the cloth until it tears, or click into it to cut it: the load goes over to the threads beside the hole, which is why a tear runs on. The wind is drag against moving air, in gusts.',
  lookFor: 'The load gathers in bright lines above what is pulled, and where it is too much a tear opens and runs.',
  formula: String.raw`\varepsilon=\frac{|\mathbf p_a-\mathbf p_b|}{L}-1=\frac{C\,F}{L},\qquad\varepsilon>\varepsilon_{\max}\;\Rightarrow\;\text{torn}`,
  parameters: {
    size: { label: 'Threads across', min: 16, max: 64, step: 4, value: 48 },
    hung: { label: 'Hung by', unit: 'points', min: 2, max: 16, step: 1, value: 5 },
    wind: { label: 'Wind', unit: 'm/s', min: 0, max: 12, step: 0.5, value: 4, live: true },
    strength: { label: 'Tears at a strain of', unit: '%', min: 15, max: 60, step: 1, value: 20 },
  },
  show: { minX: -2.9, maxX: 2.9, minY: -1.6, maxY: 1.4 },
  poster: 1.4,
  light: { size: 28 },
  style: ({ series, ink, dark }) => ({
    particle: { fill: ink, minRadius: 0, alpha: 0 },
    links: {
      rod: {
        colorBy: {
          by: 'strain',
          from: 0,
          to: 0.25,
          colors: [dark ? '#3b5f8f' : '#8fb4e0', series[1], series[3], series[2]],
        },
        width: 1.5,
      },
    },
    pins: { radius: 3.5 },
  }),

  build(values) {
    const { size, hung, strength } = values;
    const world = new World({ gravity: { x: 0, y: -g }, capacity: size * size });
    const rows = Math.round((size * height) / width);
    const pins = Array.from({ length: hung }, (_, n) => Math.round((n * (size - 1)) / (hung - 1)));
    const sheet = world.addBody(
      clothBody({
        x: 0,
        y: top - height / 2,
        width,
        height,
        columns: size,
        rows,
        mass: 1,
        kind: 'rod',
        pinned: (column, row) => row === 0 && pins.includes(column),
        // By this it is strained alike, whatever its threads and the points that it hangs on.
        compliance: (0.035 * hung) / size,
        linkDamping: 0.2,
        breakStrain: strength / 100,
        damping: 0.7,
      }),
    );
    for (const [place, particle] of sheet.particles.entries()) {
      const column = place % size;
      const after = Math.max(
        1,
        pins.findIndex((pin) => pin >= column),
      );
      const bow = pins[after] - pins[after - 1];
      const share = (column - pins[after - 1]) / bow;
      particle.x *= narrow;
      particle.y -= (4 * share * (1 - share) * sag * narrow * width * bow) / (size - 1);
    }
    let gust = -1;
    const air = { x: 0, y: 0 };
    world.addForce(
      new Wind({
        k1: 0.4 / (size * rows),
        velocity(x, y, time) {
          const blow = Math.sin(1.3 * time - 0.9 * x) + 0.5 * Math.sin(3.1 * time - 2.2 * x + y);
          air.x = values.wind * blow + (gust >= 0 && time - gust < 0.6 ? 25 : 0);
          air.y = 0.4 * values.wind * Math.max(0, blow);
          return air;
        },
      }),
    );
    const links = world.links.length;
    const reach = Math.max(0.09, (0.7 * width) / size); // of a click: a knot's own threads, at least
    const cut = (hits: (middle: Point) => boolean): void => {
      for (const link of [...world.links]) {
        if (hits({ x: (link.a.x + link.b.x) / 2, y: (link.a.y + link.b.y) / 2 })) world.removeLink(link);
      }
    };
    return {
      world,
      hand: { frequency: 80, maxForce: 60 },
      tap: ({ x, y }) => cut((at) => Math.hypot(at.x - x, at.y - y) < reach),
      actions: [
        { key: 'x', label: 'Cut a slit', run: () => cut((at) => Math.abs(at.x) < (0.55 * width) / size && at.y < 0.3) },
        {
          key: 'g',
          label: 'A gust',
          run() {
            gust = world.time;
          },
        },
      ],
      beforeStep() {
        for (const particle of sheet.particles) if (particle.y < -6) particle.remove();
      },
      readouts: () => [
        { label: 'Greatest strain', value: 100 * strainOf(world), unit: '%', digits: 0 },
        { label: 'Threads torn', value: links - world.links.length, digits: 0 },
      ],
    };
  },

  check(run) {
    const calm = run({ wind: 0, size: 28 });
    const { world } = calm.setup;
    const threads = world.links.length;
    calm.run(5);
    const speed = Math.max(...particlesOf(world).map(({ vx, vy }) => Math.hypot(vx, vy)));
    const strainBetween = (low: number, high: number): number => {
      const there = (world.links as readonly DistanceLink[]).filter(({ a, b }) => {
        return a.y + b.y > 2 * low && a.y + b.y < 2 * high;
      });
      return there.reduce((sum, { strain }) => sum + Math.max(0, strain), 0) / there.length;
    };
    const [above, below] = [strainBetween(0.2, top), strainBetween(-2, -0.3)];
    const torn = threads - world.links.length;

    const hand = world.addForce(new PointerSpring(calm.setup.hand));
    hand.grab(world.particleAt(world.particleCount >> 1));
    hand.moveTo(0.5, -2);
    let strain = 0;
    calm.run(2, () => {
      strain = Math.max(strain, strainOf(world));
    });
    const windy = run({ size: 28 });
    let fastest = 0;
    windy.run(3, () => {
      fastest = Math.max(fastest, ...particlesOf(windy.setup.world).map(({ vx }) => Math.abs(vx)));
    });
    const left = windy.setup.world.links.length;
    windy.setup.tap?.({ x: 0, y: 0 });
    return [
      { name: 'threads torn by its own weight', value: torn, atMost: 0 },
      { name: 'speed in calm air after 5 s, m/s', value: speed, atMost: 0.3 },
      { name: 'strain above, as a multiple of that below', value: above / below, atLeast: 2 },
      { name: 'threads torn by the hand', value: threads - torn - world.links.length, atLeast: 6 },
      { name: 'the strain at which they tear', value: strain, atLeast: 0.12, atMost: 0.2 },
      { name: 'what the wind moves, m/s', value: fastest, atLeast: 0.5 },
      { name: 'threads torn by the wind', value: threads - left, atMost: 0 },
      { name: 'threads cut by a tap', value: left - windy.setup.world.links.length, atLeast: 2 },
    ];
  },
};

function particlesOf(world: World): Particle[] {
  return world.bodies.flatMap(({ particles }) => particles);
}

function strainOf({ links }: World): number {
  return Math.max(0, ...(links as readonly DistanceLink[]).map(({ strain }) => strain));
}
