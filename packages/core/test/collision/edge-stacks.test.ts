import { box, EdgeContacts, HalfPlane, regularPolygon, rod, substep, triangle, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../helpers.ts';

function floor(subSteps: number): World {
  const world = new World({ gravity: { x: 0, y: -9.81 }, resolver: substep({ subSteps }) });
  world.addContactGenerator(new EdgeContacts(world));
  world.addShape(new HalfPlane({ friction: 0.5 }));
  return world;
}

function allSleep({ particles }: World): boolean {
  return particles.asleep.subarray(0, particles.count).every((asleep) => asleep === 1);
}

describe('what is made of rods', () => {
  it.each([1, 2, 4, 8])(
    '[C49] stands still on the floor within two seconds, and sleeps: with %i small steps',
    (subSteps) => {
      for (const height of [1, 2, 3]) {
        const world = floor(subSteps);
        const column = Array.from({ length: height + 1 }, (_, n) =>
          world.addParticle({ x: 0, y: 0.05 + n * 0.5, radius: 0.05, friction: 0.5 }),
        );
        for (let n = 0; n < height; n++) world.addLink(rod(column[n], column[n + 1]));
        run(world, 120);
        expect(allSleep(world)).toBe(true);
        expect(Math.abs(column[height].y - 0.05 - height * 0.5)).toBeLessThan(1e-3);
      }
    },
  );

  it('[C49] so do boxes, triangles and polygons', () => {
    const shape = { radius: 0.05, friction: 0.5 };
    for (const plan of [
      box({ x: 0, y: 0.3, width: 0.5, height: 0.5, ...shape }),
      box({ x: 0, y: 0.25, width: 1, height: 0.4, ...shape }),
      triangle({ x: 0, y: 0.2, width: 0.5, height: 0.4, ...shape }),
      regularPolygon({ x: 0, y: 0.6, sides: 6, circumradius: 0.5, ...shape }),
    ]) {
      const world = floor(4);
      world.addBody(plan);
      run(world, 300);
      expect(allSleep(world)).toBe(true);
    }
  });
});

describe('a stack of 10 boxes of 0.5 m', () => {
  it('[C46] stands for a minute, and sleeps, with 8 small steps', () => {
    const world = floor(8);
    const boxes = Array.from({ length: 10 }, (_, n) =>
      world.addBody(box({ x: 0, y: 0.3 + n * 0.6, width: 0.5, height: 0.5, radius: 0.05, friction: 0.5 })),
    );
    run(world, 3600);
    expect(allSleep(world)).toBe(true);
    for (const [n, { x, y, angle }] of boxes.entries()) {
      expect(Math.abs(x)).toBeLessThan(0.01);
      expect(Math.abs(y - 0.3 - n * 0.6)).toBeLessThan(0.02);
      expect(Math.abs(angle)).toBeLessThan(0.01);
    }
  });
});
