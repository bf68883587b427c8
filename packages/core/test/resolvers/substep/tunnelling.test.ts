import { Box, DiscContacts, HalfPlane, type Particle, Polygon, Polyline, Segment, type Shape, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../../helpers.ts';

const DT = 1 / 60;
const OFFSETS = 25;

/** Walls whose surface is at x = 0, seen from the left. */
const walls: [string, () => Shape][] = [
  ['a half-plane', () => new HalfPlane({ normal: { x: -1, y: 0 } })],
  ['a segment', () => new Segment({ a: { x: 0, y: -40 }, b: { x: 0, y: 40 } })],
  ['a thick segment', () => new Segment({ a: { x: 0.05, y: -40 }, b: { x: 0.05, y: 40 }, thickness: 0.1 })],
  ['a polyline', () => new Polyline({ points: Array.from({ length: 41 }, (_, k) => ({ x: 0, y: 2 * k - 40 })) })],
  [
    'a polygon',
    () =>
      new Polygon({
        points: [
          { x: 0, y: -40 },
          { x: 0.02, y: -40 },
          { x: 0.02, y: 40 },
          { x: 0, y: 40 },
        ],
      }),
  ],
  ['a box', () => new Box({ centre: { x: 0.01, y: 0 }, width: 0.02, height: 80 })],
];

/** Throws a particle at the place (0, 0) so that it comes there within some step, from all distances within one. */
function throwAt(world: World, speed: number, degrees: number, offset: number, options: object): Particle {
  const angle = (degrees * Math.PI) / 180;
  const way = 3 + (speed * DT * offset) / OFFSETS;
  const [x, y] = [-way * Math.cos(angle), -way * Math.sin(angle)];
  return world.addParticle({ x, y, vx: speed * Math.cos(angle), vy: speed * Math.sin(angle), ...options });
}

describe('static geometry', () => {
  const radii = [0, 0.01, 0.1, 0.5];
  const cases = walls.flatMap(([name, wall]) => radii.map((radius) => [name, radius, wall] as const));

  it.each(cases)(
    '[S12] %s stops what has a radius of %s m, at any speed up to 500 m/s and any angle',
    (_, radius, wall) => {
      for (const speed of [1, 20, 100, 500]) {
        for (const degrees of [0, 30, -60, 80]) {
          for (let offset = 0; offset < OFFSETS; offset++) {
            const world = new World();
            world.addShape(wall());
            const thrown = throwAt(world, speed, degrees, offset, { radius, restitution: offset % 2 });
            run(world, Math.ceil((3 / speed + DT) / DT) + 3);
            expect(thrown.x).toBeLessThan(1e-9);
          }
        }
      }
    },
  );
});

describe('each other', () => {
  it.each([0.01, 0.1, 0.5])('[S12] discs of %s m do not pass through each other, at up to 500 m/s each', (radius) => {
    for (const speed of [20, 100, 500]) {
      for (const aside of [-0.9, -0.4, 0, 0.7]) {
        for (let offset = 0; offset < OFFSETS; offset++) {
          const world = new World();
          world.addContactGenerator(new DiscContacts());
          const a = throwAt(world, speed, 0, offset, { radius });
          const b = world.addParticle({ x: 3, y: aside * 2 * radius, vx: offset % 2 ? -speed : 0, radius });
          const start = b.vy - a.vy;
          run(world, Math.ceil(8 / speed / DT) + 2);
          // They met: the closing speed along the line of the centres is gone.
          const cos = Math.sqrt(1 - aside * aside);
          const closing = (a.vx - b.vx) * cos + (a.vy - b.vy) * aside;
          expect(start).toBe(0);
          expect(closing).toBeLessThan(1e-6 * speed);
        }
      }
    }
  });
});

describe('what is hit on its way', () => {
  it.each([0.05, 0.3])('[S12] does not pass through a wall, however fast it is thrown, from %s m away', (gap) => {
    for (const mass of [0.01, 1, 100]) {
      const world = new World();
      world.addShape(new Segment({ a: { x: 1, y: -40 }, b: { x: 1, y: 40 } }));
      world.addContactGenerator(new DiscContacts());
      const hit = world.addParticle({ x: 0, y: 0, radius: 0.1, mass, restitution: 1 });
      const hits = world.addParticle({ x: -0.2 - gap, y: 0, vx: 250, radius: 0.1, mass: 1, restitution: 1 });
      for (let step = 0; step < 10; step++) {
        world.step(DT);
        expect(hit.x).toBeLessThan(1);
        expect(hits.x).toBeLessThan(1);
      }
    }
  });
});

describe('a graze', () => {
  it('[S13] what passes by is not touched: no ghost', () => {
    for (const speed of [5, 50, 500]) {
      for (const clearance of [0.02, 0.1, 1]) {
        for (let offset = 0; offset < OFFSETS; offset++) {
          const world = new World();
          world.addContactGenerator(new DiscContacts());
          world.addShape(new Segment({ a: { x: 0, y: -0.2 - clearance }, b: { x: 0, y: -9 } }));
          world.addShape(new Box({ centre: { x: 6, y: 1.2 + clearance }, width: 2, height: 2 }));
          const passes = throwAt(world, speed, 0, offset, { radius: 0.2, restitution: 1, friction: 1 });
          const peg = world.addParticle({ x: 12, y: -0.4 - clearance, radius: 0.2, restitution: 1, friction: 1 });
          run(world, Math.ceil(20 / speed / DT));
          expect([passes.vx, passes.vy, passes.y]).toEqual([speed, 0, 0]);
          expect([peg.vx, peg.vy]).toEqual([0, 0]);
        }
      }
    }
  });

  it('[S13] a disc that slides over the joints of a floor keeps its speed', () => {
    const points = Array.from({ length: 201 }, (_, k) => ({ x: k - 5, y: 0 }));
    for (const speed of [1, 10, 100]) {
      const world = new World({ gravity: { x: 0, y: -9.81 } });
      world.addShape(new Polyline({ points }));
      const disc = world.addParticle({ x: 0, y: 0.2, vx: speed, radius: 0.2, restitution: 0.5 });
      for (let step = 0; step < Math.min(600, (190 / speed) * 60); step++) {
        world.step(DT);
        expect(Math.abs(disc.vy)).toBeLessThan(0.01);
      }
      expect(disc.vx).toBeCloseTo(speed, 9);
    }
  });
});
