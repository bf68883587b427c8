import {
  Box,
  Disc,
  DiscContacts,
  HalfPlane,
  impact,
  Polygon,
  Polyline,
  Random,
  Segment,
  type Shape,
  type SurfaceOptions,
  severity,
  substep,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { BoxTree } from '../../src/collision/box-tree.ts';
import { run } from '../helpers.ts';
import { plainPlanes } from './plain-planes.ts';
import { placesOf, searchedDistance, segmentsOf } from './surface.ts';

const DT = 1 / 60;
const EARTH = { x: 0, y: -9.81 };
const centre = { x: 0, y: 0 };
const corners = [centre, { x: 1, y: 0 }, { x: 0, y: 1 }];

const kinds: [string, (options: SurfaceOptions) => Shape][] = [
  ['HalfPlane', (options) => new HalfPlane(options)],
  ['Segment', (options) => new Segment({ a: centre, b: { x: 1, y: 0 }, ...options })],
  ['Polyline', (options) => new Polyline({ points: corners, ...options })],
  ['Polygon', (options) => new Polygon({ points: corners, ...options })],
  ['Box', (options) => new Box({ centre, width: 1, height: 1, ...options })],
  ['Disc', (options) => new Disc({ centre, radius: 1, ...options })],
];

describe.each(kinds)('%s', (name, make) => {
  it('[C23] takes friction, a speed of its surface, a category, a mask, a filter and sensor, and has a default for each', () => {
    const filter = () => true;
    const options = { restitution: 0.5, friction: 2, surfaceSpeed: -3, category: 4, mask: 6, sensor: true, filter };
    expect(make(options)).toMatchObject(options);
    const plain = { restitution: 0, friction: 0, surfaceSpeed: 0, category: 1, mask: 0xffff, sensor: false };
    expect(make({})).toMatchObject(plain);
  });

  it.each<[SurfaceOptions, string]>([
    [{ friction: -1 }, 'friction must be a finite number, 0 or more; got -1'],
    [{ friction: Infinity }, 'friction must be a finite number, 0 or more; got Infinity'],
    [{ surfaceSpeed: Number.NaN }, 'surfaceSpeed must be a finite number of metres per second; got NaN'],
    [{ restitution: 1.1 }, 'restitution must be a number from 0 to 1; got 1.1'],
    [{ category: 0x1_0000 }, 'category must be a whole number from 0 to 65535; got 65536'],
    [{ mask: 0.5 }, 'mask must be a whole number from 0 to 65535; got 0.5'],
    [{ sensor: 1 as never }, 'sensor must be true or false; got 1'],
    [{ filter: 'none' as never }, 'filter must be a function of the slot of a particle; got "none"'],
  ])('[C4] refuses %o', (options, message) => {
    expect(() => make(options)).toThrow(`${name}: ${message}`);
  });
});

describe('a conveyor', () => {
  it.each([
    ['floor', { x: 0, y: 1 }, 'x', 1],
    ['ceiling', { x: 0, y: -1 }, 'x', -1],
    ['wall on the left', { x: 1, y: 0 }, 'y', -1],
  ] as const)('[C24] pulls what lies on it along (normalY, -normalX): a %s', (_, normal, axis, sign) => {
    const gravity = { x: -normal.x * 9.81, y: -normal.y * 9.81 };
    const world = new World({ gravity, resolver: substep() });
    world.addShape(new HalfPlane({ normal, friction: 0.5, surfaceSpeed: 2 }));
    const disc = world.addParticle({ x: normal.x * 0.2, y: normal.y * 0.2, radius: 0.2, friction: 0.5 });
    run(world, 6, DT);
    const early = axis === 'x' ? disc.vx : disc.vy;
    expect(Math.abs(early - sign * 0.5 * 9.81 * 0.1)).toBeLessThan(0.05); // while it slides: friction times weight
    run(world, 120, DT);
    expect(axis === 'x' ? disc.vx : disc.vy).toBeCloseTo(2 * sign, 6);
  });
});

describe('what is solid from one side', () => {
  const platforms: [string, () => Shape][] = [
    ['a segment', () => new Segment({ a: { x: -2, y: 0 }, b: { x: 2, y: 0 }, oneSided: true })],
    [
      'a polyline',
      () =>
        new Polyline({ points: [{ x: -2, y: 0 }, { x: 0.05, y: 0 }, { x: 2, y: 0 }], oneSided: true }), // biome-ignore format: one line
    ],
  ];

  it.each(platforms)('[C25] %s lets through what comes from below, and then holds it', (_, make) => {
    for (const resolver of [severity, substep, plainPlanes]) {
      for (const up of [2.5, 3, 3.4, 5, 9]) {
        const world = new World({ gravity: EARTH, resolver: resolver() });
        world.addShape(make());
        const jumper = world.addParticle({ x: 0, y: -0.3, vy: up, radius: 0.15 });
        const free = new World({ gravity: EARTH, resolver: resolver() });
        free.addShape(new HalfPlane({ point: { x: 0, y: -1000 } }));
        const ghost = free.addParticle({ x: 0, y: -0.3, vy: up, radius: 0.15 });
        while (jumper.vy > 0.2) {
          world.step(DT);
          free.step(DT);
          expect(jumper.y).toBe(ghost.y); // on its way up nothing touches it
        }
        run(world, 180, DT);
        if (ghost.y > 0.3) expect(jumper.y).toBeCloseTo(0.15, 2);
        else if (ghost.y < 0.1) expect(jumper.y).toBeLessThan(-5);
      }
    }
  });

  it.each(platforms)(
    '[C25] %s holds what comes from above at 500 m/s, and not what turns round half-way',
    (_, make) => {
      for (const radius of [0, 0.1]) {
        const world = new World({ gravity: EARTH, resolver: plainPlanes() });
        world.addShape(make());
        const shot = world.addParticle({ x: 0.3, y: 3, vy: -500, radius });
        run(world, 60, DT);
        expect(shot.y).toBeCloseTo(radius, 2);
      }
      const world = new World({ gravity: EARTH, resolver: plainPlanes() });
      world.addShape(make());
      const half = world.addParticle({ x: 0, y: 0.05, vy: 0, radius: 0.15 }); // in it, and not from above
      run(world, 60, DT);
      expect(half.y).toBeLessThan(-1);
    },
  );

  it('[C25] points to the left of the way from a to b: turned round, it holds from below', () => {
    const world = new World({ gravity: { x: 0, y: 9.81 }, resolver: plainPlanes() });
    world.addShape(new Segment({ a: { x: 2, y: 0 }, b: { x: -2, y: 0 }, oneSided: true }));
    const held = world.addParticle({ x: 0, y: -1, radius: 0.1 });
    const through = world.addParticle({ x: 1, y: 1, vy: -15, radius: 0.1 });
    run(world, 300, DT);
    expect(held.y).toBeCloseTo(-0.1, 2);
    expect(through.y).toBeCloseTo(-0.1, 2);
  });
});

describe('filters', () => {
  it.each([severity, substep, impact])(
    '[C26] a particle and a shape touch if each has the other in its mask',
    (resolver) => {
      const cases: [object, object, boolean][] = [
        [{}, {}, true],
        [{ category: 2 }, { mask: 2 }, true],
        [{ category: 2 }, { mask: 1 }, false],
        [{ mask: 4 }, { category: 2 }, false],
        [{ mask: 6 }, { category: 2 }, true],
        [{ category: 0 }, {}, false],
        [{}, { filter: () => false }, false],
        [{}, { filter: (slot: number) => slot === 0 }, true],
      ];
      for (const [options, surface, touches] of cases) {
        const world = new World({ gravity: EARTH, resolver: resolver() });
        world.addShape(new HalfPlane(surface));
        const disc = world.addParticle({ x: 0, y: 0.2, radius: 0.1, ...options });
        run(world, 60, DT);
        expect(disc.y > 0).toBe(touches);
      }
    },
  );

  it('[C26] a mask that changes counts from the next step on', () => {
    const world = new World({ gravity: EARTH, resolver: substep() });
    world.addShape(new HalfPlane({ category: 2 }));
    const disc = world.addParticle({ x: 0, y: 0.1, radius: 0.1 });
    run(world, 30, DT);
    expect(disc.y).toBeCloseTo(0.1, 2);
    disc.mask = 1;
    disc.vy = -0.1; // so that it does not sleep
    run(world, 30, DT);
    expect(disc.y).toBeLessThan(-0.5);
  });

  it.each([
    ['category', 65536],
    ['mask', -1],
  ] as const)('[X1] a particle refuses a %s of %d', (name, value) => {
    const world = new World();
    expect(() => world.addParticle({ x: 0, y: 0, [name]: value })).toThrow(
      `World.addParticle: ${name} must be a whole`,
    );
    const particle = world.addParticle({ x: 0, y: 0 });
    expect(() => {
      particle[name] = value;
    }).toThrow(`Particle.${name}: ${name} must be a whole number from 0 to 65535`);
    expect(particle[name]).toBe(name === 'category' ? 1 : 0xffff);
  });
});

describe('trees', () => {
  it('[C27] a tree of boxes finds those that overlap a place, in order', () => {
    const random = new Random(2);
    for (let count = 0; count < 150; count++) {
      const boxes = new Float64Array(count * 4);
      for (let b = 0; b < count; b++) {
        const x = b * 0.1 + random.between(-1, 1);
        const y = random.between(-1, 1);
        boxes.set([x, y, x + random.next(), y + random.next()], b * 4);
      }
      const tree = new BoxTree(boxes);
      for (let n = 0; n < 10; n++) {
        const x = random.between(-1, count * 0.1);
        const y = random.between(-1, 1);
        const size = random.between(0, 2);
        const expected = Array.from({ length: count }, (_, b) => b).filter((b) => {
          const [minX, minY, maxX, maxY] = boxes.subarray(b * 4, b * 4 + 4);
          return minX <= x + size && minY <= y + size && maxX >= x && maxY >= y;
        });
        const found = tree.find(x, y, x + size, y + size);
        expect([...tree.found.subarray(0, found)]).toEqual(expected);
      }
    }
  });

  it('[C27] a terrain of 10 000 edges reports what a look at each of them does', () => {
    const random = new Random(4);
    const points = Array.from({ length: 10_001 }, (_, i) => ({ x: i * 0.1, y: random.between(-0.1, 0.1) }));
    const terrain = new Polyline({ points });
    const edges = segmentsOf(points, false);
    for (let n = 0; n < 100; n++) {
      const p = { x: random.between(0, 1000), y: random.between(-1, 1) };
      const places = placesOf(terrain, p.x, p.y, 0.5);
      const near = edges.filter(([a]) => Math.abs(a.x - p.x) < 2);
      const distance = searchedDistance(p, near);
      if (distance < 0.499) expect(Math.min(...places.map((place) => place.distance))).toBeCloseTo(distance, 7);
    }
  });

  it('[C27] among a thousand boxes the contacts are those of a look at each of them, whatever came and went', () => {
    const random = new Random(9);
    const world = new World({ gravity: EARTH, resolver: severity() });
    world.addContactGenerator(new DiscContacts());
    const boxes = Array.from({ length: 1000 }, () =>
      world.addShape(
        new Box({
          centre: { x: random.between(-40, 40), y: random.between(-40, 0) },
          width: 1,
          height: 0.5,
          angle: random.next(),
        }),
      ),
    );
    world.addShape(new HalfPlane({ point: { x: 0, y: -41 } }));
    for (let n = 0; n < 300; n++)
      world.addParticle({ x: random.between(-40, 40), y: random.between(-40, 9), radius: 0.2 });
    for (let step = 0; step < 90; step++) {
      if (step % 20 === 19) world.removeShape(boxes[step]);
      const { x, y, vx, vy, radius } = world.particles;
      const places = Array.from(x.subarray(0, 300), (_, i) => [x[i] + vx[i] * DT, y[i] + (vy[i] - 9.81 * DT) * DT]);
      const expected = world.shapes.flatMap((shape, s) =>
        places.flatMap(([px, py], i) =>
          placesOf(shape, px, py, radius[i] * 1.01)
            .filter(({ distance }) => distance < radius[i] * 1.009)
            .map(() => `${s} ${i}`),
        ),
      );
      world.step(DT);
      const { a, source, count } = world.contacts;
      const found = Array.from({ length: count }, (_, c) => `${source[c]} ${a[c]}`);
      for (const pair of expected) expect(found).toContain(pair);
    }
  });
});
