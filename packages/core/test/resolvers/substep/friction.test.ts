import { Box, DiscContacts, HalfPlane, type Particle, Segment, type Shape, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../../helpers.ts';

const DT = 1 / 60;
const G = 9.81;

/** A disc at rest on a slope, and how far it is down the slope. */
function onSlope(angle: number, friction: number, radius = 0.25): { world: World; disc: Particle; down: () => number } {
  const world = new World({ gravity: { x: 0, y: -G } });
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  world.addShape(new HalfPlane({ normal: { x: sin, y: cos }, friction }));
  const disc = world.addParticle({ x: radius * sin, y: radius * cos, radius, mass: 2, friction });
  return { world, disc, down: () => disc.x * cos - disc.y * sin };
}

describe('a slope', () => {
  const angles = [5, 15, 30, 45, 60];

  it.each(angles)('[S4] of %s degrees: what has friction above its tangent sticks', (degrees) => {
    const angle = (degrees * Math.PI) / 180;
    const { world, down } = onSlope(angle, Math.tan(angle) * 1.02);
    run(world, 60);
    const start = down();
    run(world, 540);
    expect(Math.abs(start)).toBeLessThan(1e-3);
    expect(Math.abs(down() - start)).toBeLessThan(1e-4);
  });

  it.each(angles)('[S4] of %s degrees: what has less slides down at g·(sin - µ·cos), to 1 %%', (degrees) => {
    const angle = (degrees * Math.PI) / 180;
    for (const share of [0, 0.3, 0.6, 0.9]) {
      const friction = Math.tan(angle) * share;
      const { world, disc, down } = onSlope(angle, friction);
      run(world, 120);
      const a = G * (Math.sin(angle) - friction * Math.cos(angle));
      expect(Math.hypot(disc.vx, disc.vy) / (2 * a)).toBeCloseTo(1, 2);
      expect(Math.abs(down() / (2 * a) - 1)).toBeLessThan(0.01);
    }
  });
});

describe('a point', () => {
  it('[S4] that slides down a slope stays on it, at whatever angle', () => {
    for (let degrees = 0; degrees < 90; degrees += 3) {
      const angle = (degrees * Math.PI) / 180;
      const { world, disc } = onSlope(angle, 0, 0);
      disc.y += 0.3;
      for (let step = 0; step < 200; step++) {
        world.step(DT);
        expect(disc.x * Math.sin(angle) + disc.y * Math.cos(angle)).toBeGreaterThan(-2e-4);
      }
    }
  });
});

describe('a level floor', () => {
  it.each([0.1, 0.3, 0.8])(
    '[S4] with friction %s stops what slides after v² / 2µg, to 1 %%, and it stays',
    (friction) => {
      for (const v of [2, 5, 20]) {
        const { world, disc } = onSlope(0, friction);
        disc.vx = v;
        run(world, Math.ceil(v / (friction * G) / DT) + 30);
        expect(disc.vx).toBe(0);
        const way = (v * v) / (2 * friction * G);
        expect(Math.abs(disc.x / way - 1)).toBeLessThan(0.01 + (v * DT) / 4 / way);
        const { x } = disc;
        run(world, 300);
        expect(Math.abs(disc.x - x)).toBeLessThan(1e-9);
      }
    },
  );

  it('[S4] the friction of two is the geometric mean of theirs', () => {
    const world = new World({ gravity: { x: 0, y: -G } });
    world.addShape(new HalfPlane({ friction: 0.9 }));
    const disc = world.addParticle({ x: 0, y: 0.25, vx: 10, radius: 0.25, friction: 0.1 });
    run(world, 60);
    expect(disc.vx).toBeCloseTo(10 - 0.3 * G, 1);
  });
});

describe('a conveyor', () => {
  const belts: [string, (surfaceSpeed: number) => Shape][] = [
    ['half-plane', (surfaceSpeed) => new HalfPlane({ friction: 0.5, surfaceSpeed })],
    ['box', (surfaceSpeed) => new Box({ centre: { x: 0, y: -1 }, width: 200, height: 2, friction: 0.5, surfaceSpeed })],
    [
      'segment',
      (surfaceSpeed) => new Segment({ a: { x: -99, y: 0 }, b: { x: 99, y: 0 }, friction: 0.5, surfaceSpeed }),
    ],
  ];
  it.each(belts)('[S5] made of a %s drags what lies on it to its speed, at µ·g, and holds it there', (_, belt) => {
    for (const speed of [3, -3]) {
      const world = new World({ gravity: { x: 0, y: -G } });
      world.addShape(belt(speed));
      const disc = world.addParticle({ x: 0, y: 0.25, radius: 0.25, friction: 0.5 });
      run(world, 18);
      expect(disc.vx / (Math.sign(speed) * 0.5 * G * 0.3)).toBeCloseTo(1, 1);
      run(world, 60);
      expect(disc.vx).toBeCloseTo(speed, 6);
      run(world, 600);
      expect(disc.vx).toBeCloseTo(speed, 6);
      expect(disc.asleep).toBe(false);
    }
  });

  it('[S5] a disc that stands on a moving one of infinite mass goes with it', () => {
    const world = new World({ gravity: { x: 0, y: -G } });
    world.addContactGenerator(new DiscContacts());
    world.addParticle({ x: 0, y: 0, vx: 1, mass: Infinity, radius: 50, friction: 1 });
    const rider = world.addParticle({ x: 0, y: 50.1, radius: 0.1, friction: 1 });
    run(world, 240);
    expect(rider.vx).toBeCloseTo(1, 2);
  });
});
