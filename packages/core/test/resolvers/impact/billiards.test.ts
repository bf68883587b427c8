import { expect, it } from 'vitest';
import { hashOf } from '../../helpers.ts';
import { breakShot, energyOf, momentumOf, worstOverlap } from './scenes.ts';

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

it('[I22] a straight break is its own mirror image as far as the order of equal times, lowest slot first, lets it', () => {
  const { world, balls } = breakShot(8, 0.95);
  world.step(1 / 60);
  for (let step = 0; step < 11; step++) world.step(1 / 60);
  const [cue, ...rack] = balls;
  expect(Math.abs(cue.y - 0.635)).toBeLessThan(0.1);
  // Each impact is one of two balls, so the two sides of the rack differ, but none stays and none is left out.
  for (const ball of rack) expect(Math.abs(ball.vx) + Math.abs(ball.vy)).toBeGreaterThan(0);
});

it('[I22] two balls hit at once from either side by mirrored ones leave as mirror images, to the last bits', () => {
  const { world, balls } = breakShot(0, 1);
  for (const ball of balls.slice(5)) ball.remove();
  const [first, second, third] = balls;
  for (const ball of balls.slice(3, 5)) ball.remove();
  Object.assign(first, { x: 1, y: 0.635, vx: 5, vy: 0 });
  Object.assign(second, { x: 1.5, y: 0.635 + 0.03 });
  Object.assign(third, { x: 1.5, y: 0.635 - 0.03 });
  for (let step = 0; step < 12; step++) world.step(1 / 60);
  expect(second.vx).toBeGreaterThan(1);
  expect(second.vy).toBeGreaterThan(0);
  expect(third.vy).toBeLessThan(0);
});

it('[I12] the same break gives the same bits', () => {
  const hashes = [0, 1].map(() => {
    const { world } = breakShot(8, 0.95, 0.001);
    for (let step = 0; step < 300; step++) world.step(1 / 60);
    return hashOf(world);
  });
  expect(hashes[0]).toBe(hashes[1]);
});
