import { Wind, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { forceOn, garbagePerStep, run } from './measure.ts';

describe('wind', () => {
  it('[F50] pushes along the motion of the air relative to the particle, with k1·|u| + k2·|u|²', () => {
    const world = new World();
    const leaf = world.addParticle({ x: 0, y: 0, vx: 2, vy: -1 });
    world.addForce(new Wind({ velocity: { x: 5, y: 3 }, k1: 0.5, k2: 0.1 }), [leaf]);
    const force = forceOn(world, leaf); // u = (3, 4)
    expect(force.x).toBeCloseTo((0.5 + 0.1 * 5) * 3, 8);
    expect(force.y).toBeCloseTo((0.5 + 0.1 * 5) * 4, 8);
  });

  it.each([
    [0.3, 0],
    [0, 2],
    [0.3, 2],
  ])('[F51] brings a particle to the speed of the air: k1 = %d, k2 = %d', (k1, k2) => {
    const world = new World();
    const leaf = world.addParticle({ x: 0, y: 0, vx: 3, vy: 9, mass: 0.5 });
    world.addForce(new Wind({ velocity: { x: 6, y: -2 }, k1, k2 }));
    run(world, 60, 1 / 60);
    expect(leaf.vx).toBeCloseTo(6, 1);
    expect(leaf.vy).toBeCloseTo(-2, 1);
  });

  it('[F51] what falls in it falls at the terminal velocity, m·g / k1, on top', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const leaf = world.addParticle({ x: 0, y: 0, mass: 0.1 });
    world.addForce(new Wind({ velocity: { x: 4, y: 0 }, k1: 0.5 }));
    run(world, 20, 1 / 60);
    expect(leaf.vx).toBeCloseTo(4, 10);
    expect(leaf.vy).toBeCloseTo(-2, 10);
  });

  it('[F52] never throws a particle beyond the speed of the air, and leaves a pinned one', () => {
    const world = new World();
    const dust = world.addParticle({ x: 0, y: 0, mass: 1e-4 });
    const pin = world.addParticle({ x: 0, y: 0, mass: Infinity });
    world.addForce(new Wind({ velocity: { x: 30, y: 0 }, k1: 5, k2: 5 }));
    for (let step = 0; step < 100; step++) {
      world.step(1 / 60);
      expect(dust.vx).toBeLessThanOrEqual(30 * (1 + 1e-12));
    }
    expect(dust.vx).toBeCloseTo(30, 9);
    expect([pin.x, pin.vx]).toEqual([0, 0]);
  });

  it('[F53] its velocity may be a function of place and time: gusts and eddies', () => {
    const world = new World();
    const left = world.addParticle({ x: -1, y: 0 });
    const right = world.addParticle({ x: 1, y: 0 });
    const air = { x: 0, y: 0 };
    const wind = new Wind({
      k1: 1,
      velocity: (x, y, time) => {
        air.x = x < 0 ? 2 : 0;
        air.y = time < 0.5 ? y : 100;
        return air;
      },
    });
    world.addForce(wind);
    run(world, 0.5, 1 / 64);
    expect(left.vx).toBeGreaterThan(0.5);
    expect([right.vx, right.vy, left.vy]).toEqual([0, 0, 0]);
    world.step(1 / 64);
    expect(left.vy).toBeGreaterThan(1);
  });

  it('[F53] its velocity may be set', () => {
    const world = new World();
    const leaf = world.addParticle({ x: 0, y: 0 });
    const air = { x: 1, y: 0 };
    const wind = world.addForce(new Wind({ velocity: air, k1: 1 }));
    air.x = 50;
    expect(wind.velocity).toEqual({ x: 1, y: 0 });
    wind.velocity = { x: 0, y: 3 };
    expect(forceOn(world, leaf).y).toBeCloseTo(3, 9);
    expect(() => {
      wind.velocity = { x: NaN, y: 0 };
    }).toThrow('Wind.velocity: velocity.x must be a finite number');
  });

  it.each([
    [undefined, 'options must be an object'],
    [{ k1: 1 }, 'velocity must be { x, y }'],
    [{ velocity: { x: 0, y: Infinity } }, 'velocity.y must be a finite number of metres per second'],
    [{ velocity: { x: 0, y: 0 }, k1: -1 }, 'k1 must be a finite number'],
    [{ velocity: { x: 0, y: 0 }, k2: NaN }, 'k2 must be a finite number'],
  ])('[F54] refuses %o', (options, message) => {
    expect(() => new Wind(options as never)).toThrow(`Wind: ${message}`);
  });

  it('[F55] a step leaves no garbage', () => {
    const world = new World();
    for (let i = 0; i < 200; i++) world.addParticle({ x: i, y: 0 });
    world.addForce(new Wind({ velocity: { x: 3, y: 1 }, k1: 0.1, k2: 0.1 }));
    expect(garbagePerStep(world)).toBeLessThan(250);
  });
});
