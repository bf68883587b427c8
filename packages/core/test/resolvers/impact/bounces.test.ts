import { Box, HalfPlane, impact, World } from '@mass/core';
import { describe, expect, it } from 'vitest';

const G = 9.81;

/** The heights of a ball's hops, from the energy after each bounce. */
function hops(restitution: number, height: number, dt: number, count: number): number[] {
  const world = new World({ resolver: impact(), gravity: { x: 0, y: -G } });
  world.addShape(new HalfPlane({ restitution }));
  const ball = world.addParticle({ x: 0, y: height + 0.1, radius: 0.1 });
  const heights = [height];
  while (heights.length <= count && world.stepCount < 100_000) {
    world.step(dt);
    const top = ball.y - 0.1 + ball.vy ** 2 / (2 * G);
    if (world.contacts.count > 0) heights.push(top);
  }
  return heights;
}

describe('a bouncing ball', () => {
  it.each([0.5, 0.8, 0.9, 1])('[I14] at restitution %d takes up e² of the height with each bounce, to 1e-9', (e) => {
    for (const dt of [1 / 60, 1 / 240]) {
      const rests = (G * dt) ** 2 / (2 * G); // what a step's acceleration builds counts as rest
      const heights = hops(e, 2, dt, 12);
      for (const [n, height] of heights.entries()) {
        const exact = 2 * e ** (2 * n);
        if (exact < 2 * rests) break;
        expect(Math.abs(height / exact - 1)).toBeLessThan(1e-9);
      }
    }
  });

  it('[I14] thrown, it bounces at the time and the place of the closed form', () => {
    for (const dt of [1 / 30, 1 / 60, 1 / 1000]) {
      const world = new World({ resolver: impact(), gravity: { x: 0, y: -G } });
      world.addShape(new HalfPlane({ restitution: 0.7 }));
      const ball = world.addParticle({ x: 0, y: 1.5, vx: 3, vy: 4, radius: 0.25 });
      const steps = Math.round(1.8 / dt);
      for (let step = 0; step < steps; step++) world.step(dt);
      const hit = (4 + Math.sqrt(16 + 2 * G * 1.25)) / G;
      const up = 0.7 * (G * hit - 4);
      const left = 1.8 - hit;
      expect(left).toBeLessThan((2 * up) / G);
      expect(ball.x).toBeCloseTo(5.4, 11);
      expect(Math.abs(ball.y - (0.25 + up * left - (G * left * left) / 2))).toBeLessThan(1e-11);
      expect(Math.abs(ball.vy - (up - G * left))).toBeLessThan(1e-11);
    }
  });

  it('[I15] at restitution 0.5 it gets past the time at which its bounces accumulate, and lies still', () => {
    const world = new World({ resolver: impact(), gravity: { x: 0, y: -G } });
    world.addShape(new HalfPlane({ restitution: 0.5 }));
    const ball = world.addParticle({ x: 0, y: 1.1, vx: 1, radius: 0.1 });
    for (let step = 0; step < 120; step++) world.step(1 / 60);
    expect(ball.y).toBeCloseTo(0.1, 11);
    expect(ball.vy).toBe(0);
    expect(ball.x).toBeCloseTo(2, 12);
  });

  it('[I11] flight is exact whatever the step: the parabola, with a constant acceleration and a force', () => {
    for (const dt of [1 / 10, 1 / 60, 1 / 240]) {
      const world = new World({ resolver: impact(), gravity: { x: 0, y: -G } });
      const ball = world.addParticle({ x: 0, y: 0, vx: 2, vy: 5, ax: 0.5, mass: 2 });
      world.addForce({ apply: ({ fx }) => void (fx[ball.slot] += 3) });
      for (let step = 0; step < Math.round(3 / dt); step++) world.step(dt);
      expect(ball.x).toBeCloseTo(2 * 3 + ((0.5 + 3 / 2) * 9) / 2, 10);
      expect(ball.y).toBeCloseTo(5 * 3 - (G * 9) / 2, 10);
    }
  });

  it('[I16] a damping takes its share off the velocity at the end of each step', () => {
    const world = new World({ resolver: impact() });
    const ball = world.addParticle({ x: 0, y: 0, vx: 8, damping: 0.5 });
    world.step(1);
    expect([ball.x, ball.vx]).toEqual([8, 4]);
  });

  it('[I14] it bounces off the corner of a box along the line to the corner', () => {
    const world = new World({ resolver: impact() });
    world.addShape(new Box({ centre: { x: 1, y: -1 }, width: 2, height: 2, restitution: 1 })); // corner at (0, 0)
    const r = 0.1;
    const ball = world.addParticle({ x: -1, y: r * Math.SQRT1_2, vx: 1, radius: r });
    world.step(1.5);
    expect(Math.abs(ball.vx)).toBeLessThan(1e-12); // reflected about 45 degrees
    expect(ball.vy).toBeCloseTo(1, 12);
    expect(ball.x).toBeCloseTo(-r * Math.SQRT1_2, 12);
  });
});
