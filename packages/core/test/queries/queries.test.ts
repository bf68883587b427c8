import {
  Box,
  castRay,
  Disc,
  firstHit,
  HalfPlane,
  nearestParticle,
  type Particle,
  particlesAt,
  particlesInBox,
  particlesInCircle,
  Random,
  Segment,
  type Shape,
  shapeFinder,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';

/** A world of discs at random, some of them removed. */
function scattered(seed: number): World {
  const random = new Random(seed);
  const world = new World();
  for (let i = 0; i < 200; i++) {
    world.addParticle({
      x: random.between(-10, 10),
      y: random.between(-10, 10),
      radius: i % 5 === 0 ? 0 : random.between(0.1, 1),
    });
  }
  for (let slot = 0; slot < 200; slot += 7) world.particleAt(slot).remove();
  return world;
}

function all(world: World): Particle[] {
  return Array.from({ length: world.particles.count }, (_, slot) => slot)
    .filter((slot) => world.particles.alive[slot] === 1)
    .map((slot) => world.particleAt(slot));
}

const distance = (p: Particle, x: number, y: number): number => Math.hypot(p.x - x, p.y - y) - p.radius;

describe('particles at a place', () => {
  it('[Q1] are those whose disc covers the point, touches the circle or the box, by slot', () => {
    const world = scattered(3);
    const random = new Random(4);
    for (let n = 0; n < 200; n++) {
      const [x, y, r] = [random.between(-11, 11), random.between(-11, 11), random.between(0, 3)];
      expect(particlesAt(world, x, y)).toEqual(all(world).filter((p) => distance(p, x, y) <= 0));
      expect(particlesInCircle(world, x, y, r)).toEqual(all(world).filter((p) => distance(p, x, y) <= r));
      const inBox = particlesInBox(world, x, y, x + r, y + 2 * r);
      const clamp = (v: number, low: number, high: number): number => Math.min(Math.max(v, low), high);
      expect(inBox).toEqual(all(world).filter((p) => distance(p, clamp(p.x, x, x + r), clamp(p.y, y, y + 2 * r)) <= 0));
    }
  });

  it('[Q1] a point is found where it is, and nowhere else', () => {
    const world = new World();
    const point = world.addParticle({ x: 1, y: 2 });
    expect(particlesAt(world, 1, 2)).toEqual([point]);
    expect(particlesAt(world, 1, 2 + 1e-12)).toEqual([]);
  });
});

describe('the nearest particle', () => {
  it('[Q2] is the one with the nearest edge, within the distance and through the filter', () => {
    const world = scattered(5);
    const random = new Random(6);
    for (let n = 0; n < 200; n++) {
      const [x, y] = [random.between(-15, 15), random.between(-15, 15)];
      const even = (p: Particle): boolean => p.slot % 2 === 0;
      const byDistance = all(world).sort((p, q) => distance(p, x, y) - distance(q, x, y));
      expect(nearestParticle(world, x, y)).toBe(byDistance[0]);
      expect(nearestParticle(world, x, y, { filter: even })).toBe(byDistance.find(even));
      const expected = distance(byDistance[0], x, y) <= 0.2 ? byDistance[0] : undefined;
      expect(nearestParticle(world, x, y, { maxDistance: 0.2 })).toBe(expected);
    }
  });

  it('[Q2] is the lower slot of two equally near ones, and nobody in an empty world', () => {
    const world = new World();
    expect(nearestParticle(world, 0, 0)).toBeUndefined();
    const left = world.addParticle({ x: -1, y: 0 });
    world.addParticle({ x: 1, y: 0 });
    expect(nearestParticle(world, 0, 0)).toBe(left);
    expect(nearestParticle(world, 0, 0, { maxDistance: 1 })).toBe(left);
    expect(nearestParticle(world, 0, 0, { maxDistance: 0.999 })).toBeUndefined();
  });
});

describe('a ray', () => {
  it('[Q3] meets a disc where the closed form says, with the normal there', () => {
    const world = new World();
    const disc = world.addParticle({ x: 5, y: 0.6, radius: 1 });
    const [hit] = castRay(world, { from: { x: 0, y: 0 }, to: { x: 10, y: 0 } });
    expect(hit.target).toBe(disc);
    expect(hit.x).toBeCloseTo(4.2, 12);
    expect(hit.fraction).toBeCloseTo(0.42, 12);
    expect([hit.normalX, hit.normalY]).toEqual([expect.closeTo(-0.8, 12), expect.closeTo(-0.6, 12)]);
  });

  it('[Q3] meets the same discs, in order, as a walk along it does', () => {
    const world = scattered(7);
    const random = new Random(8);
    for (let n = 0; n < 60; n++) {
      const from = { x: random.between(-12, 12), y: random.between(-12, 12) };
      const to = { x: random.between(-12, 12), y: random.between(-12, 12) };
      const hits = castRay(world, { from, to });
      for (const [index, hit] of hits.entries()) {
        if (index > 0) expect(hit.fraction).toBeGreaterThanOrEqual(hits[index - 1].fraction);
        expect(Math.abs(distance(hit.target as Particle, hit.x, hit.y))).toBeLessThan(1e-9);
      }
      const starts = new Set(particlesAt(world, from.x, from.y));
      const walked = new Set<Particle>();
      for (let s = 0; s <= 4000; s++) {
        const share = s / 4000;
        for (const p of particlesAt(world, from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share)) {
          if (!starts.has(p)) walked.add(p);
        }
      }
      const met = new Set(hits.map(({ target }) => target));
      for (const particle of walked) expect(met.has(particle)).toBe(true);
    }
  });

  it('[Q3] meets shapes, and a shape of the game, to a billionth of a metre', () => {
    const world = new World();
    const wall = world.addShape(new HalfPlane({ point: { x: 8, y: 0 }, normal: { x: -1, y: 0 } }));
    const box = world.addShape(new Box({ centre: { x: 3, y: 0 }, width: 1, height: 2 }));
    const disc = world.addShape(new Disc({ centre: { x: 6, y: 0.5 }, radius: 1 }));
    const line = world.addShape(new Segment({ a: { x: 1, y: -1 }, b: { x: 1, y: 1 } }));
    const own: Shape = {
      finder: shapeFinder,
      restitution: 0,
      minX: 1.5,
      minY: -1,
      maxX: 2,
      maxY: 1,
      findSurface: (x, _y, reach, surface) => {
        if (1.75 - x < reach) surface.add(1.75 - x, -1, 0);
      },
    };
    world.addShape(own);
    const hits = castRay(world, { from: { x: 0, y: 0 }, to: { x: 10, y: 0 } });
    expect(hits.map(({ target }) => target)).toEqual([line, own, box, disc, wall]);
    const places = [1, 1.75, 2.5, 6 - Math.sqrt(0.75), 8];
    for (const [index, hit] of hits.entries()) {
      expect(Math.abs(hit.x - places[index])).toBeLessThan(2e-9);
      expect(hit.normalX).toBeLessThan(0);
      expect(hit.fraction).toBeCloseTo(places[index] / 10, 8);
    }
    expect(firstHit(world, { from: { x: 0, y: 0 }, to: { x: 10, y: 0 } })?.target).toBe(line);
    expect(firstHit(world, { from: { x: 0, y: 0 }, to: { x: 10, y: 0 }, filter: (t) => t === box })?.target).toBe(box);
    expect(firstHit(world, { from: { x: 0, y: 3 }, to: { x: 7, y: 3 } })).toBeUndefined();
  });

  it('[Q3] does not meet what it starts in, what lies behind it, or what lies past its end', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0, radius: 1 });
    world.addParticle({ x: -3, y: 0, radius: 1 });
    world.addParticle({ x: 9, y: 0, radius: 1 });
    world.addShape(new Box({ centre: { x: 0, y: 0 }, width: 1, height: 1 }));
    expect(castRay(world, { from: { x: 0, y: 0 }, to: { x: 7, y: 0 } })).toEqual([]);
  });

  it('[Q3] that grazes a slope, ever so little, still finds where it comes down', () => {
    const world = new World();
    world.addShape(new HalfPlane({ normal: { x: -1, y: 1 } }));
    for (const height of [10, 1, 0.1, 0.01, 0.001]) {
      const hit = firstHit(world, { from: { x: 0, y: height }, to: { x: 100, y: 100 - height } });
      expect(Math.abs((hit?.x ?? 0) - 50)).toBeLessThan(1e-7 / height);
      expect(hit?.normalX).toBeCloseTo(-Math.SQRT1_2, 12);
    }
  });

  it('[Q3] that grazes a floor at one degree still finds where it comes down', () => {
    const world = new World();
    world.addShape(new HalfPlane());
    const slope = Math.tan(Math.PI / 180);
    const hit = firstHit(world, { from: { x: 0, y: 1 }, to: { x: 80, y: 1 - 80 * slope } });
    expect(hit?.x).toBeCloseTo(1 / slope, 5);
  });
});

describe('bad input', () => {
  const world = new World();
  const nan = Number.NaN;
  it.each<[string, () => unknown, RegExp]>([
    [
      'a point that is no number',
      () => particlesAt(world, nan, 0),
      /particlesAt: x must be a finite number of metres; got NaN/,
    ],
    [
      'a negative radius',
      () => particlesInCircle(world, 0, 0, -1),
      /particlesInCircle: radius must be .* 0 or more; got -1/,
    ],
    [
      'a box the wrong way round',
      () => particlesInBox(world, 1, 0, 0, 1),
      /particlesInBox: the greatest x must be at least/,
    ],
    [
      'a negative distance',
      () => nearestParticle(world, 0, 0, { maxDistance: -1 }),
      /nearestParticle: maxDistance must be/,
    ],
    [
      'a ray without length',
      () => castRay(world, { from: { x: 1, y: 1 }, to: { x: 1, y: 1 } }),
      /castRay: the ends must be apart/,
    ],
    [
      'a ray without end',
      () => castRay(world, { from: { x: 1, y: 1 }, to: { x: 1, y: nan } }),
      /castRay: to.y must be a finite number/,
    ],
  ])('[X1] %s is an error that says what must hold', (_, act, message) => {
    expect(act).toThrow(message);
  });
});
