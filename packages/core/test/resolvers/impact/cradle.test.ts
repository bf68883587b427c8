import { type Particle, rod } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { impactWorld } from './scenes.ts';

describe("Newton's cradle of five balls that touch", () => {
  it.each([1, 2, 3, 4])('[I21] in a line: %d come, as many leave', (count) => {
    const world = impactWorld();
    const balls: Particle[] = [];
    for (let i = 0; i < 5; i++) {
      const comes = i < count;
      const x = i * 0.2 - (comes ? 0.5 : 0);
      balls.push(world.addParticle({ x, y: 0, vx: comes ? 1 : 0, radius: 0.1, restitution: 1 }));
    }
    for (let step = 0; step < 60; step++) world.step(1 / 60);
    for (const [i, ball] of balls.entries()) expect(Math.abs(ball.vx - (i < 5 - count ? 0 : 1))).toBeLessThan(1e-12);
  });

  it.each([1, 2, 3])('[I21] on rods: %d fall, as many rise, nearly as high, and the others stay', (count) => {
    const world = impactWorld(-9.81);
    const balls: Particle[] = [];
    for (let i = 0; i < 5; i++) {
      const angle = i < count ? 0.3 : 0;
      const ball = { x: i * 0.2 - Math.sin(angle), y: -Math.cos(angle), radius: 0.1, restitution: 1 };
      balls.push(world.addParticle(ball));
      world.addLink(rod(balls[i], { x: i * 0.2, y: 0 }));
    }
    let highest = -1;
    for (let step = 0; step < 240; step++) {
      world.step(1 / 240);
      for (const [i, ball] of balls.entries()) {
        const rises = i >= 5 - count;
        if (rises) highest = Math.max(highest, ball.y);
        else if (world.time > 0.55 && world.time < 0.95) expect(Math.abs(ball.x - i * 0.2)).toBeLessThan(1e-4);
      }
    }
    const share = (highest + 1) / (1 - Math.cos(0.3));
    expect(share).toBeGreaterThan(0.9); // the rods take some
    expect(share).toBeLessThan(1.001);
  });
});
