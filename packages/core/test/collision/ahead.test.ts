import {
  Box,
  HalfPlane,
  Polygon,
  Polyline,
  Random,
  Segment,
  type Shape,
  shapeFinder,
  substep,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { plainPlanes } from './plain-planes.ts';
import { type Point, placesOf, searchedDistance, segmentsOf, windsAround } from './surface.ts';

const DT = 1 / 60;
const EARTH = { x: 0, y: -9.81 };

/** A room, what it is made of, and whether a point is in it. */
interface Room {
  readonly shapes: readonly Shape[];
  isInside(p: Point): boolean;
}

function ring(random: Random, least: number, most: number): Point[] {
  const corners = random.integer(3, 12);
  return Array.from({ length: corners }, (_, i) => {
    const angle = ((i + random.between(0, 0.6)) / corners) * 2 * Math.PI;
    const size = random.between(least, most);
    return { x: size * Math.cos(angle), y: size * Math.sin(angle) };
  });
}

const sides: Point[] = [{ x: 1, y: 0 }, { x: -1, y: 0 }, { x: 0, y: 1 }, { x: 0, y: -1 }]; // biome-ignore format: one line

const rooms: Record<string, (random: Random, e: number) => Room> = {
  'a closed polyline': (random, restitution) => {
    const points = ring(random, 4, 4);
    return {
      shapes: [new Polyline({ points, closed: true, restitution })],
      isInside: (p) => windsAround(p, points),
    };
  },
  'a closed polyline with corners that point in': (random, restitution) => {
    const points = ring(random, 1.5, 4);
    return {
      shapes: [new Polyline({ points, closed: true, restitution })],
      isInside: (p) => windsAround(p, points),
    };
  },
  'thin segments': (random, restitution) => {
    const points = ring(random, 4, 4);
    const shapes = segmentsOf(points, true).map(([a, b]) => new Segment({ a, b, restitution }));
    return { shapes, isInside: (p) => windsAround(p, points) };
  },
  'thick segments': (random, restitution) => {
    const points = ring(random, 4, 4);
    const shapes = segmentsOf(points, true).map(([a, b]) => new Segment({ a, b, restitution, thickness: 0.01 }));
    return { shapes, isInside: (p) => windsAround(p, points) };
  },
  'half-planes': (_, restitution) => ({
    shapes: sides.map(({ x, y }) => new HalfPlane({ point: { x: -4 * x, y: -4 * y }, normal: { x, y }, restitution })),
    isInside: ({ x, y }) => Math.abs(x) < 4.001 && Math.abs(y) < 4.001, // a point rests on the very surface
  }),
  'boxes 20 mm thick': (_, restitution) => ({
    shapes: sides.map(
      ({ x, y }) =>
        new Box({
          centre: { x: -4 * x, y: -4 * y },
          width: x === 0 ? 8.02 : 0.02,
          height: y === 0 ? 8.02 : 0.02,
          restitution,
        }),
    ),
    isInside: ({ x, y }) => Math.abs(x) < 4 && Math.abs(y) < 4,
  }),
  'polygons 20 mm thick': (_, restitution) => ({
    shapes: sides.map(({ x, y }) => {
      const at = (across: number, along: number) => ({ x: -across * x - along * y, y: -across * y + along * x });
      return new Polygon({ points: [at(4, -4.02), at(4.02, -4.02), at(4.02, 4.02), at(4, 4.02)], restitution });
    }),
    isInside: ({ x, y }) => Math.abs(x) < 4.001 && Math.abs(y) < 4.001,
  }),
};

/** Throws a particle about in a room. Returns how often it got out. */
function escapes(random: Random, make: (random: Random, e: number) => Room, rounds: number): number {
  let out = 0;
  for (let round = 0; round < rounds; round++) {
    const restitution = random.next() < 0.5 ? 0 : random.next();
    const { shapes, isInside } = make(random, restitution);
    const start = { x: random.between(-0.3, 0.3), y: random.between(-0.3, 0.3) };
    const radius = random.next() < 0.3 ? 0 : random.between(0.01, 0.2);
    const isFree = shapes.every((shape) => placesOf(shape, start.x, start.y, radius + 0.01).length === 0);
    if (!isFree || !isInside(start)) continue;
    const world = new World({ gravity: round % 2 === 0 ? EARTH : { x: 0, y: 0 }, resolver: plainPlanes() });
    for (const shape of shapes) world.addShape(shape);
    const particle = world.addParticle({ ...start, radius, restitution });
    for (let step = 0; step < 60; step++) {
      if (step % 15 === 0) {
        const angle = random.between(0, 2 * Math.PI);
        const speed = random.between(0, 500);
        particle.vx = speed * Math.cos(angle);
        particle.vy = speed * Math.sin(angle);
      }
      world.step(DT);
      if (isInside(particle)) continue;
      out++;
      break;
    }
  }
  return out;
}

describe('at up to 500 m/s and 1/60 s', () => {
  it.each(Object.keys(rooms))('[C20] a disc or a point stays in a room: %s', (name) => {
    expect(escapes(new Random(3), rooms[name], 150)).toBe(0);
  });

  it("[C20] a game's own shape stops discs by the distances that it reports", () => {
    const ball: Shape = {
      finder: shapeFinder,
      restitution: 0,
      minX: -2,
      minY: -2,
      maxX: 2,
      maxY: 2,
      findSurface(x, y, reach, surface) {
        const distance = Math.sqrt(x * x + y * y);
        if (1 - distance < reach && distance > 0) surface.add(1 - distance, -x / distance, -y / distance);
      },
    };
    for (let n = 0; n < 100; n++) {
      const world = new World({ resolver: plainPlanes() });
      world.addShape(ball);
      const speed = 5 * (n + 1);
      const disc = world.addParticle({ x: 0, y: 0.1, vx: speed, vy: speed / 3, radius: 0.1 });
      for (let step = 0; step < 30; step++) world.step(DT);
      expect(Math.hypot(disc.x, disc.y)).toBeLessThan(0.95); // half of it is still inside
    }
  });

  it('[C20] a disc stops at the closed form of the place of impact', () => {
    for (const speed of [1, 30, 500]) {
      const world = new World({ resolver: plainPlanes() });
      world.addShape(new Segment({ a: { x: 3, y: -9 }, b: { x: 3, y: 9 } }));
      const disc = world.addParticle({ x: 3 - 0.1 - (speed * DT) / 3, y: 0, vx: speed, vy: 0.5, radius: 0.1 });
      world.step(DT);
      expect(disc.x).toBeCloseTo(2.9, 12);
      expect(disc.vx).toBeCloseTo(0, 9);
      expect(disc.vy).toBe(0.5); // along the wall nothing changes
    }
  });
});

/** Shapes with corners, and their edges. */
const obstacles: [string, Shape, readonly (readonly [Point, Point])[]][] = [
  ['a segment', new Segment({ a: { x: -1, y: 0 }, b: { x: 1, y: 0.5 } }), [[{ x: -1, y: 0 }, { x: 1, y: 0.5 }]]], // biome-ignore format: one line
  ...[new Box({ centre: { x: 0, y: 0 }, width: 1, height: 2, angle: 0.3 })].map(
    (box): [string, Shape, readonly (readonly [Point, Point])[]] => ['a box', box, segmentsOf(box.corners, true)],
  ),
  ...[
    [
      { x: -1, y: 1 },
      { x: 0, y: 0 },
      { x: 1, y: 1 },
      { x: 0, y: -1 },
    ],
  ].map((points): [string, Shape, readonly (readonly [Point, Point])[]] => [
    'a polygon',
    new Polygon({ points }),
    segmentsOf(points, true),
  ]),
  ...[
    [
      { x: -1, y: 1 },
      { x: 0, y: 0 },
      { x: 1, y: 1 },
      { x: 1.5, y: -1 },
    ],
  ].map((points): [string, Shape, readonly (readonly [Point, Point])[]] => [
    'a polyline',
    new Polyline({ points }),
    segmentsOf(points, false),
  ]),
];

/** The distance of a way to the nearest of some segments: that of an end to the other, if they do not cross. */
function apart(from: Point, to: Point, segments: readonly (readonly [Point, Point])[]): number {
  const turn = (a: Point, b: Point, c: Point) => Math.sign((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  let least = Infinity;
  for (const [a, b] of segments) {
    if (turn(a, b, from) !== turn(a, b, to) && turn(from, to, a) !== turn(from, to, b)) return 0;
    const ends = [searchedDistance(from, [[a, b]]), searchedDistance(to, [[a, b]])];
    least = Math.min(least, ...ends, searchedDistance(a, [[from, to]]), searchedDistance(b, [[from, to]]));
  }
  return least;
}

describe('what passes by', () => {
  it.each(obstacles)('[C21] %s does not touch a fast disc that passes by, be it by 0.1 mm', (_, shape, edges) => {
    const random = new Random(11);
    let passed = 0;
    for (let n = 0; n < 1500; n++) {
      const gravity = n % 2 === 0 ? { x: 0, y: 0 } : EARTH;
      const world = new World({ gravity, resolver: plainPlanes() });
      world.addShape(shape);
      const radius = random.between(0, 0.3);
      const speed = random.between(20, 500);
      const angle = random.between(0, 7);
      const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
      const aside = random.between(-1.6, 1.6);
      const before = Math.min(2.5, speed * DT * random.next());
      const at = (way: number): Point => ({
        x: -dy * aside + dx * (way - before),
        y: dx * aside + dy * (way - before),
      });
      const [from, to] = [at(0), at(speed * DT)];
      const isSolid = shape instanceof Box || shape instanceof Polygon;
      if (isSolid && windsAround(from, edges.map(([a]) => a))) continue; // biome-ignore format: one line
      if (apart(from, to, edges) < radius + 1e-4 + (n % 2) * 3e-3) continue;
      passed++;
      const disc = world.addParticle({ ...at(0), vx: speed * dx, vy: speed * dy, radius });
      world.step(DT);
      expect(disc.vx).toBeCloseTo(speed * dx, 9);
      expect(disc.vy).toBeCloseTo(speed * dy + gravity.y * DT, 9);
    }
    expect(passed).toBeGreaterThan(300);
  });

  it('[C21] a way that gravity bends down onto a platform ends on it, though the straight way passes over', () => {
    for (const radius of [0, 0.05]) {
      const world = new World({ gravity: EARTH, resolver: plainPlanes() });
      world.addShape(new Segment({ a: { x: 3, y: 0 }, b: { x: 30, y: 0 } }));
      const flyer = world.addParticle({ x: 0, y: radius + 1.2e-3, vx: 500, radius });
      world.step(DT);
      expect(flyer.x).toBeGreaterThan(8);
      expect(flyer.y).toBeGreaterThan(radius - 1e-3);
      expect(flyer.vx).toBeCloseTo(500, 6);
    }
  });
});

const floors: Record<string, () => Shape[]> = {
  'a flat polyline': () => [new Polyline({ points: level(0.7, 900, 0) })],
  'a fine one': () => [new Polyline({ points: level(0.05, 12000, 0) })],
  'a thick one': () => [new Polyline({ points: level(0.7, 900, -0.1), thickness: 0.2 })],
  'a one-sided one': () => [new Polyline({ points: level(0.7, 900, 0), oneSided: true })],
  'a polygon': () => [new Polygon({ points: [{ x: -5, y: -1 }, { x: 600, y: -1 }, ...level(0.7, 850, 0).reverse()] })],
  'boxes side by side': () =>
    Array.from({ length: 600 }, (_, i) => new Box({ centre: { x: i - 4, y: -0.5 }, width: 1, height: 1 })),
  'segments end to end': () =>
    Array.from({ length: 600 }, (_, i) => new Segment({ a: { x: i - 4, y: 0 }, b: { x: i - 3, y: 0 } })),
};

function level(length: number, count: number, y: number): Point[] {
  return Array.from({ length: count }, (_, i) => ({ x: i * length - 4, y }));
}

describe('joints', () => {
  it.each(Object.keys(floors))('[C22] a disc slides over those of %s at any speed: not slowed, not lifted', (name) => {
    const shapes = floors[name]();
    for (const resolver of [plainPlanes, substep]) {
      for (const speed of [0.5, 5, 50, 500]) {
        const world = new World({ gravity: EARTH, resolver: resolver() });
        for (const shape of shapes) world.addShape(shape);
        const disc = world.addParticle({ x: 0, y: 0.25, vx: speed, radius: 0.25 });
        for (let step = 0; step < 60; step++) {
          world.step(DT);
          expect(disc.vx).toBeCloseTo(speed, 6);
          expect(disc.y).toBeLessThan(0.25 + 1e-6);
          expect(disc.y).toBeGreaterThan(0.25 * 0.97);
        }
      }
    }
  });

  it('[C22] a flat that rises from a joint is met, as are both sides of a corner that points in', () => {
    const world = new World({ gravity: EARTH, resolver: plainPlanes() });
    world.addShape(new Polyline({ points: [{ x: -9, y: 0 }, { x: 1, y: 0 }, { x: 9, y: 2 }] })); // biome-ignore format: one line
    const disc = world.addParticle({ x: 0, y: 0.1, vx: 300, radius: 0.1 });
    world.step(DT);
    const slope = Math.atan2(2, 8);
    expect(Math.atan2(disc.vy, disc.vx)).toBeCloseTo(slope, 3);
    const corner = new World({ gravity: EARTH, resolver: plainPlanes() });
    corner.addShape(new Polyline({ points: [{ x: -3, y: 3 }, { x: 0, y: 0 }, { x: 3, y: 3 }] })); // biome-ignore format: one line
    corner.addParticle({ x: 0, y: 0.1 * Math.SQRT2, radius: 0.1 });
    corner.step(DT);
    expect(corner.contacts.count).toBe(2);
  });
});
