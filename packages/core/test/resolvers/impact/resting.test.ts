import { DiscContacts, HalfPlane, impact, Polyline, shapeFinder, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { addWalls, energyOf, impactWorld, momentumOf, pile, worstOverlap } from './scenes.ts';

const G = 9.81;

describe('a disc on a half-plane', () => {
  it('[I15] moves less than 1 µm in 60 s, with gravity as an acceleration or as a generator, and after a long step', () => {
    for (const how of ['world', 'constant', 'force']) {
      const world = new World({ resolver: impact(), gravity: { x: 0, y: how === 'world' ? -G : 0 } });
      world.addShape(new HalfPlane({ restitution: 0.5 }));
      const disc = world.addParticle({ x: 0, y: 0.5, radius: 0.5, ay: how === 'constant' ? -G : 0, mass: 2 });
      if (how === 'force') world.addForce({ apply: ({ fy }) => void (fy[disc.slot] -= 2 * G) });
      for (let step = 0; step < 3600; step++) {
        world.step(step === 1800 ? 1 / 6 : 1 / 60);
        expect(Math.abs(disc.y - 0.5)).toBeLessThan(1e-12);
        expect(disc.x).toBe(0);
      }
    }
  });

  it('[I15] comes to rest from a drop and stays there', () => {
    const world = new World({ resolver: impact(), gravity: { x: 0, y: -G } });
    world.addShape(new HalfPlane({ restitution: 0.5 }));
    const disc = world.addParticle({ x: 0, y: 1, radius: 0.1 });
    for (let step = 0; step < 120; step++) world.step(1 / 60);
    const settled = disc.y;
    for (let step = 0; step < 3600; step++) world.step(1 / 60);
    expect(Math.abs(disc.y - settled)).toBeLessThan(1e-9);
    expect(Math.abs(disc.y - 0.1)).toBeLessThan(1e-9);
  });

  it('[I15] pushes against it with its weight', () => {
    const world = new World({ resolver: impact(), gravity: { x: 0, y: -G } });
    world.addShape(new HalfPlane());
    world.addParticle({ x: 0, y: 0.1, radius: 0.1, mass: 3 });
    world.step(1 / 60);
    expect(world.contacts.count).toBe(1);
    expect(world.contacts.impulse[0]).toBeCloseTo((3 * G) / 60, 12);
  });

  it('[I15] slides down a slope on the exact parabola', () => {
    const world = new World({ resolver: impact(), gravity: { x: 0, y: -G } });
    world.addShape(new HalfPlane({ normal: { x: 3, y: 4 } }));
    const disc = world.addParticle({ x: 0.06, y: 0.08, radius: 0.1 });
    for (let step = 0; step < 60; step++) world.step(1 / 60);
    const along = (G * 0.6) / 2; // g·sin/2 after a second
    expect(disc.x).toBeCloseTo(0.06 + along * 0.8, 10);
    expect(disc.y).toBeCloseTo(0.08 - along * 0.6, 10);
  });

  it('[I15] hit from above it gives the blow on to the floor, and hit from below the blow lifts it', () => {
    const world = impactWorld(-G);
    world.addShape(new HalfPlane({ restitution: 1 }));
    const low = world.addParticle({ x: 0, y: 0.1, radius: 0.1, restitution: 1 });
    const high = world.addParticle({ x: 0, y: 1.3, radius: 0.1, restitution: 1 });
    const before = energyOf(world);
    for (let step = 0; step < 40; step++) {
      world.step(1 / 60);
      expect(low.y).toBeGreaterThan(0.1 - 1e-9);
      expect(high.y - low.y).toBeGreaterThan(0.2 - 1e-9);
    }
    expect(Math.abs(energyOf(world) / before - 1)).toBeLessThan(1e-9);
  });
});

describe('discs at rest on each other', () => {
  it('[I15] two, three, five and ten upon each other stand for 20 s and hardly cost an impact', () => {
    for (const count of [2, 3, 5, 10]) {
      const world = impactWorld(-G);
      world.addShape(new HalfPlane({ restitution: 0.3 }));
      for (let i = 0; i < count; i++) world.addParticle({ x: 0, y: 0.1 + 0.2 * i, radius: 0.1, restitution: 0.3 });
      for (let step = 0; step < 1200; step++) world.step(1 / 60);
      const { x, y } = world.particles;
      for (let i = 0; i < count; i++) {
        expect(Math.abs(y[i] - (0.1 + 0.2 * i))).toBeLessThan(1e-8);
        expect(x[i]).toBe(0);
      }
    }
  });

  it('[I15] a heavy one rests on a light one, 1 : 10 000', () => {
    const world = impactWorld(-G);
    world.addShape(new HalfPlane());
    world.addParticle({ x: 0, y: 0.1, radius: 0.1, mass: 1e-4 });
    const top = world.addParticle({ x: 0, y: 0.3, radius: 0.1, mass: 1 });
    for (let step = 0; step < 600; step++) world.step(1 / 60);
    expect(Math.abs(top.y - 0.3)).toBeLessThan(1e-6);
  });

  it('[I15] 20 settle in a box at restitution 0.5: they lie still, without overlap', { timeout: 60_000 }, () => {
    const world = pile(20, 0.5, 5);
    for (let step = 0; step < 600; step++) world.step(1 / 60);
    const energy = energyOf(world);
    for (let step = 0; step < 600; step++) {
      world.step(1 / 60);
      expect(worstOverlap(world, 2, 100)).toBeLessThan(1e-9);
    }
    expect(Math.abs(energyOf(world) - energy)).toBeLessThan(1e-6);
    const { vx, vy } = world.particles;
    for (let i = 0; i < 20; i++) expect(Math.abs(vx[i]) + Math.abs(vy[i])).toBeLessThan(1e-3);
  });

  it('[I15] 20 settle from other places and at other restitutions, and neither gain energy nor leave the box', {
    timeout: 60_000,
  }, () => {
    for (const [restitution, seed] of [
      [0, 1],
      [0.3, 2],
      [0.5, 3],
      [0.9, 4],
    ]) {
      const world = pile(20, restitution, seed);
      let energy = energyOf(world);
      for (let step = 0; step < 300; step++) {
        world.step(1 / 60);
        expect(energyOf(world)).toBeLessThan(energy + 1e-3 * Math.abs(energy)); // separation lifts a crowd a little
        energy = energyOf(world);
        expect(worstOverlap(world, 2, 100)).toBeLessThan(0.05);
      }
    }
  });

  it('[I23] a crowd of 200 falls into a box, in a time that is bounded, and none leaves it', {
    timeout: 120_000,
  }, () => {
    const world = pile(200, 0.5, 6);
    const start = performance.now();
    for (let step = 0; step < 120; step++) world.step(1 / 60);
    expect((performance.now() - start) / 120).toBeLessThan(500); // some 20 ms on a quiet machine
    expect(worstOverlap(world, 2, 1e9)).toBeLessThan(0.05);
  });

  it('[I15] a groove of two walls holds a disc', () => {
    const world = new World({ resolver: impact(), gravity: { x: 0, y: -G } });
    world.addShape(
      new Polyline({
        points: [
          { x: -1, y: 1 },
          { x: 0, y: 0 },
          { x: 1, y: 1 },
        ],
      }),
    ); // prettier-ignore
    const disc = world.addParticle({ x: 0.3, y: 1, radius: 0.1 });
    for (let step = 0; step < 1200; step++) world.step(1 / 60);
    expect(Math.abs(disc.x)).toBeLessThan(1e-6);
    expect(Math.abs(disc.y - 0.1 * Math.SQRT2)).toBeLessThan(1e-6);
  });
});

describe('guards', () => {
  it('[I23] inelastic collapse of three discs between walls passes its accumulation point', () => {
    const world = impactWorld();
    addWalls(world, 2, 2, 0.3);
    for (const [i, x] of [0.3, 0.9, 1.5].entries()) {
      world.addParticle({ x, y: 1, vx: 3 - 3 * i, radius: 0.2, restitution: 0.1 });
    }
    for (let step = 0; step < 600; step++) {
      world.step(1 / 60);
      expect(worstOverlap(world, 2, 2)).toBeLessThan(1e-9);
    }
    expect(world.time).toBeCloseTo(10, 9);
  });

  it('[I23] a disc in a slot too narrow for it, discs in each other, and discs at one place do not hang a step', () => {
    const world = impactWorld(-G);
    addWalls(world, 0.3, 10, 1);
    world.addParticle({ x: 0.15, y: 1, vx: 3, radius: 0.2, restitution: 1 });
    for (let i = 0; i < 5; i++) world.addParticle({ x: 0.15, y: 3, radius: 0.1, restitution: 1 });
    for (let step = 0; step < 60; step++) world.step(1 / 60);
    const { x, y } = world.particles;
    for (let i = 0; i < 6; i++) expect(Number.isFinite(x[i] + y[i])).toBe(true);
  });

  it('[I24] what overlaps as a step begins is separated as it ends', () => {
    const world = impactWorld();
    const a = world.addParticle({ x: 0, y: 0, radius: 0.1, mass: 3 });
    const b = world.addParticle({ x: 0.1, y: 0, radius: 0.1, mass: 1 });
    world.step(1 / 60);
    expect(a.x).toBeCloseTo(-0.025, 14);
    expect(b.x).toBeCloseTo(0.175, 14);
    expect([a.vx, b.vx]).toEqual([0, 0]);
  });

  it('[I25] a disc that slides round the inside of a bowl, a shape of its own, is not slowed by the guards', () => {
    const world = new World({ resolver: impact() });
    world.addContactGenerator(new DiscContacts());
    world.addShape({
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
    });
    const disc = world.addParticle({ x: 0, y: -0.9, vx: 1, radius: 0.1 });
    for (let step = 0; step < 60; step++) world.step(1 / 60);
    const speed = Math.sqrt(disc.vx ** 2 + disc.vy ** 2);
    expect(Math.abs(Math.sqrt(disc.x ** 2 + disc.y ** 2) - 0.9)).toBeLessThan(1e-3);
    expect(speed).toBeGreaterThan(0.9);
    const turned = Math.atan2(disc.y, disc.x) + Math.PI / 2;
    expect(turned).toBeGreaterThan(0.9 * (1 / 0.9));
    expect(momentumOf(world).x).toBeLessThan(1);
  });
});
