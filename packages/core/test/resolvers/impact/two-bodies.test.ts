import {
  Box,
  DiscContacts,
  HalfPlane,
  impact,
  Polyline,
  rod,
  Segment,
  type Shape,
  shapeFinder,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { impactWorld } from './scenes.ts';

describe('two discs', () => {
  it.each([
    [1, 1, 1],
    [1, 3, 0.5],
    [1, 10_000, 1],
    [10_000, 1, 0.7],
    [2, 5, 0],
  ])('[I17] of %d and %d kg at restitution %d leave a head-on impact as in the textbook, to 1e-12', (ma, mb, e) => {
    for (const dt of [1 / 10, 1 / 60, 1 / 1000]) {
      const world = impactWorld();
      const a = world.addParticle({ x: -1, y: 0, vx: 3, mass: ma, radius: 0.1, restitution: e });
      const b = world.addParticle({ x: 1, y: 0, vx: -2, mass: mb, radius: 0.2, restitution: e / 2 });
      for (let step = 0; step < Math.round(0.5 / dt); step++) world.step(dt);
      const centre = (3 * ma - 2 * mb) / (ma + mb);
      expect(Math.abs(a.vx - (centre - (e * 5 * mb) / (ma + mb)))).toBeLessThan(1e-12);
      expect(Math.abs(b.vx - (centre + (e * 5 * ma) / (ma + mb)))).toBeLessThan(1e-12);
      const hit = 1.7 / 5;
      expect(Math.abs(a.x - (-1 + 3 * hit + a.vx * (0.5 - hit)))).toBeLessThan(1e-12);
      expect(Math.abs(b.x - (1 - 2 * hit + b.vx * (0.5 - hit)))).toBeLessThan(1e-12);
    }
  });

  it('[I17] at an angle: along the line of centres as head-on, across it unchanged', () => {
    for (const offset of [-0.25, 0.1, 0.299]) {
      const world = impactWorld();
      const a = world.addParticle({ x: -1, y: offset, vx: 4, mass: 1, radius: 0.1, restitution: 0.8 });
      const b = world.addParticle({ x: 0, y: 0, mass: 2, radius: 0.2 });
      for (let step = 0; step < 30; step++) world.step(1 / 60);
      const ny = offset / 0.3;
      const nx = -Math.sqrt(1 - ny * ny);
      const J = (-(1 + 0.8) * 4 * nx) / (1 + 1 / 2);
      expect(Math.abs(a.vx - (4 + J * nx))).toBeLessThan(1e-12);
      expect(Math.abs(a.vy - J * ny)).toBeLessThan(1e-12);
      expect(Math.abs(b.vx + (J * nx) / 2)).toBeLessThan(1e-12);
      expect(Math.abs(b.vy + (J * ny) / 2)).toBeLessThan(1e-12);
    }
  });

  it('[I17] that fall together hit each other as without gravity', () => {
    const world = impactWorld(-9.81);
    const a = world.addParticle({ x: 0, y: 100, vy: 0.05, radius: 0.1, restitution: 1 });
    const b = world.addParticle({ x: 0, y: 100.21, vy: -0.05, radius: 0.1, restitution: 1 });
    for (let step = 0; step < 60; step++) world.step(1 / 60);
    expect(a.vy + 9.81).toBeCloseTo(-0.05, 11);
    expect(b.vy + 9.81).toBeCloseTo(0.05, 11);
  });

  it('[I17] of which one is drawn aside: their paths curve into each other (a quartic)', () => {
    const world = impactWorld();
    const a = world.addParticle({ x: 0, y: 0, vy: 1, ax: 2, radius: 0.1, restitution: 1 });
    const b = world.addParticle({ x: 1, y: 1, radius: 0.1, restitution: 1 }); // the parabola x = y² leads there
    world.step(2);
    expect(world.contacts.count).toBe(1);
    const { normalX, normalY } = world.contacts;
    const at = { x: 1 + 0.2 * normalX[0], y: 1 + 0.2 * normalY[0] }; // where the centre of a was
    expect(at.x).toBeCloseTo(at.y * at.y, 12);
    expect(a.vx + b.vx).toBeCloseTo(4, 12);
  });

  it('[I17] that only graze each other do not touch', () => {
    const world = impactWorld();
    const a = world.addParticle({ x: -1, y: 0.200001, vx: 100, radius: 0.1 });
    world.addParticle({ x: 0, y: 0, radius: 0.1 });
    world.step(1 / 10);
    expect([a.vx, a.vy]).toEqual([100, 0]);
    expect(world.contacts.count).toBe(0);
  });

  it('[I17] one that is pinned, or is moved by the game, is a wall', () => {
    const world = impactWorld();
    const a = world.addParticle({ x: -1, y: 0, vx: 1, radius: 0.1, restitution: 1 });
    const b = world.addParticle({ x: 1, y: 0, vx: -2, mass: Infinity, radius: 0.1 });
    for (let step = 0; step < 60; step++) world.step(1 / 60);
    expect(a.vx).toBeCloseTo(-5, 12);
    expect(b.vx).toBe(-2);
  });

  it('[I18] without DiscContacts, or joined by a link, they pass through each other; and so do points', () => {
    for (const how of ['none', 'link', 'points']) {
      const world = new World({ resolver: impact() });
      if (how !== 'none') world.addContactGenerator(new DiscContacts());
      const radius = how === 'points' ? 0 : 0.1;
      const a = world.addParticle({ x: -0.15, y: 0, vx: 1, radius });
      const b = world.addParticle({ x: 0.15, y: 0, vx: -1, radius });
      if (how === 'link') world.addLink({ a, b, addContacts() {} });
      for (let step = 0; step < 60; step++) world.step(1 / 60);
      expect(a.vx).toBe(1);
    }
  });
});

describe('at 500 m/s and 1/60 s', () => {
  const ring: Shape = {
    finder: shapeFinder,
    restitution: 1, // a game's own: the inside of a circle
    minX: -2,
    minY: -2,
    maxX: 2,
    maxY: 2,
    findSurface(x, y, reach, surface) {
      const distance = Math.sqrt(x * x + y * y);
      if (distance === 0) surface.add(1, 0, 1);
      else if (1 - distance < reach) surface.add(1 - distance, -x / distance, -y / distance);
    },
  };
  const walls: [string, Shape][] = [
    ['a segment', new Segment({ a: { x: 1, y: -9 }, b: { x: 1, y: 9 }, restitution: 1 })],
    ['a polyline', new Polyline({ points: [1, 0, -1].map((y) => ({ x: 1, y: y * 9 })), restitution: 1 })],
    ['a box of 1 mm', new Box({ centre: { x: 1.0005, y: 0 }, width: 0.001, height: 9, restitution: 1 })],
    ['a half-plane', new HalfPlane({ point: { x: 1, y: 0 }, normal: { x: -1, y: 0 }, restitution: 1 })],
    ["a game's own ring", ring],
  ];

  it.each(walls)('[I19] a disc does not pass %s', (_, shape) => {
    for (const radius of [0.01, 0.1]) {
      const world = new World({ resolver: impact() });
      world.addShape(shape);
      const disc = world.addParticle({ x: 0, y: 0, vx: 500, vy: 3, radius });
      world.step(1 / 60);
      expect(disc.x).toBeLessThan(1 - radius + 1e-9);
      expect(Math.abs(disc.vx ** 2 + disc.vy ** 2 - (500 ** 2 + 9))).toBeLessThan(1e-6);
    }
  });

  it('[I19] a disc does not pass another', () => {
    const world = impactWorld();
    const a = world.addParticle({ x: 0, y: 0, vx: 500, radius: 0.01, restitution: 1 });
    const b = world.addParticle({ x: 4, y: 0, radius: 0.01, restitution: 1 });
    world.step(1 / 60);
    expect(a.x).toBeCloseTo(3.98, 10);
    expect(b.x).toBeCloseTo(4 + 500 / 60 - 3.98, 10);
  });

  it('[I19] nor by an impact on the way: the one that is hit does not pass the next', () => {
    const world = impactWorld();
    for (const x of [0, 2, 4, 6]) world.addParticle({ x, y: 0, vx: x === 0 ? 500 : 0, radius: 0.01, restitution: 1 });
    world.step(1 / 60);
    const { x, vx } = world.particles;
    expect(Array.from(vx.subarray(0, 4), Math.round)).toEqual([0, 0, 0, 500]);
    expect(x[3]).toBeCloseTo(6 + 500 / 60 - 5.94, 10);
  });
});

it('[I20] links are kept, at the end of each step: a rod that is hit turns, and keeps momentum and length', () => {
  const world = impactWorld();
  const a = world.addParticle({ x: 0, y: 0, radius: 0.1 });
  const b = world.addParticle({ x: 0, y: 1, radius: 0.1 });
  const link = world.addLink(rod(a, b));
  world.addParticle({ x: -1, y: 0, vx: 2, radius: 0.1, restitution: 1 });
  for (let step = 0; step < 120; step++) {
    world.step(1 / 60);
    expect(Math.abs(link.strain)).toBeLessThan(1e-12);
  }
  const { vx } = world.particles;
  expect(vx[0] + vx[1] + vx[2]).toBeCloseTo(2, 12);
  expect(Math.abs(vx[2])).toBeLessThan(1e-12);
});
