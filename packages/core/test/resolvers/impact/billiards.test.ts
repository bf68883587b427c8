import { expect, it } from 'vitest';
import { hashOf } from '../../helpers.ts';
import { BALL, breakShot, energyOf, impactWorld, momentumOf, worstOverlap } from './scenes.ts';

it('[I22] a break of 15 balls keeps its energy to 1e-9 and never overlaps by 1e-9 of a radius', () => {
  const { world } = breakShot(8, 1);
  const before = energyOf(world);
  for (let step = 0; step < 600; step++) {
    world.step(1 / 60);
    expect(worstOverlap(world, 2.54, 1.27)).toBeLessThan(1e-9);
  }
  expect(Math.abs(energyOf(world) / before - 1)).toBeLessThan(1e-9);
});

it('[I22] with a restitution of 0.95 it only loses energy, and it keeps its momentum until it meets a cushion', () => {
  const { world } = breakShot(8, 0.95);
  const before = momentumOf(world).x;
  let energy = energyOf(world);
  for (let step = 0; step < 600; step++) {
    world.step(1 / 60);
    expect(energyOf(world)).toBeLessThanOrEqual(energy * (1 + 1e-14));
    energy = energyOf(world);
    if (world.time < 0.18) {
      expect(Math.abs(momentumOf(world).x - before)).toBeLessThan(1e-12);
      expect(Math.abs(momentumOf(world).y)).toBeLessThan(1e-12);
    }
  }
  expect(energy).toBeGreaterThan(0);
});

it('[I22] what happens on either side of a line and does not meet is its own mirror image, to the last bit', () => {
  const world = impactWorld();
  const sides = [1, -1].map((side) => {
    const ball = { radius: BALL, restitution: 0.95 };
    const balls = [world.addParticle({ x: 0, y: side * 0.3, vx: 4, vy: side * 0.1, ...ball })];
    for (const [x, y] of [
      [0.5, 0.32],
      [0.56, 0.35],
      [0.6, 0.29],
      [0.8, 0.31],
    ]) {
      balls.push(world.addParticle({ x, y: side * y, ...ball }));
    }
    return balls;
  });
  for (let step = 0; step < 60; step++) world.step(1 / 60);
  for (const [k, ball] of sides[0].entries()) {
    const image = sides[1][k];
    expect([image.x, image.y, image.vx, image.vy]).toEqual([ball.x, 0 - ball.y, ball.vx, 0 - ball.vy]);
  }
  expect(sides[0].filter((ball) => ball.vx !== 0).length).toBeGreaterThan(2);
});

it('[I12] of two balls that one touches at one time the lower slot is hit first, and takes more', () => {
  const world = impactWorld();
  const ball = { radius: 0.1, restitution: 1 };
  world.addParticle({ x: -1, y: 0, vx: 1, ...ball });
  const first = world.addParticle({ x: 0, y: 0.11, ...ball });
  const second = world.addParticle({ x: 0, y: -0.11, ...ball });
  for (let step = 0; step < 90; step++) world.step(1 / 60);
  const n = { x: Math.sqrt(0.04 - 0.0121) / 0.2, y: 0.55 }; // towards the first
  expect(first.vx).toBeCloseTo(n.x * n.x, 12); // as if it were alone
  expect(first.vy).toBeCloseTo(n.x * n.y, 12);
  expect(second.vx).toBeLessThan(first.vx);
  expect(second.vy).toBeLessThan(0);
});

it('[I22] after a straight break every ball of the rack moves, and the cue ball stays near the line', () => {
  const { world, balls } = breakShot(8, 0.95);
  for (let step = 0; step < 12; step++) world.step(1 / 60);
  const [cue, ...rack] = balls;
  expect(Math.abs(cue.y - 0.635)).toBeLessThan(0.1);
  for (const ball of rack) expect(Math.abs(ball.vx) + Math.abs(ball.vy)).toBeGreaterThan(0);
});

it('[I12] the same break gives the same bits', () => {
  const hashes = [0, 1].map(() => {
    const { world } = breakShot(8, 0.95, 0.001);
    for (let step = 0; step < 300; step++) world.step(1 / 60);
    return hashOf(world);
  });
  expect(hashes[0]).toBe(hashes[1]);
});
