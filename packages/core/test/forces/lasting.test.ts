import { type ForceGenerator, fuelled, lasting, Springs, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { garbagePerStep, run } from './measure.ts';

/** A force of (3, -4) N on each target. */
const push: ForceGenerator = {
  apply({ fx, fy }, { slots, count }) {
    for (let t = 0; t < count; t++) {
      fx[slots[t]] += 3;
      fy[slots[t]] -= 4;
    }
  },
};

const weight: ForceGenerator = {
  apply({ fy }, { slots, count }) {
    for (let t = 0; t < count; t++) fy[slots[t]] -= 10;
  },
};

describe('a force that lasts', () => {
  it.each([
    [1, 1 / 60],
    [0.123, 1 / 60],
    [0.001, 1 / 60],
    [1.5, 0.7],
    [10, 1 / 240],
  ])('[F70] gives an impulse of exactly F·t: %d s in steps of %d s', (duration, dt) => {
    const world = new World();
    const rocket = world.addParticle({ x: 0, y: 0 });
    world.addForce(lasting(push, duration), [rocket]);
    run(world, duration + 3 * dt, dt);
    expect(rocket.vx / (3 * duration)).toBeCloseTo(1, 12);
    expect(rocket.vy / (-4 * duration)).toBeCloseTo(1, 12);
  });

  it('[F70] says what is left, ends with the step that it ends in, and leaves other forces alone', () => {
    const world = new World();
    const rocket = world.addParticle({ x: 0, y: 0 });
    world.addForce(weight);
    const burn = world.addForce(lasting(push, 0.25));
    world.addForce({ ...weight });
    expect([burn.remaining, burn.ended]).toEqual([0.25, false]);
    world.step(0.1);
    expect(burn.remaining).toBeCloseTo(0.15, 12);
    world.step(0.1);
    expect(burn.ended).toBe(false);
    world.step(0.1);
    expect([burn.remaining, burn.ended]).toEqual([0, true]);
    expect(rocket.vx).toBeCloseTo(0.75, 12);
    expect(rocket.vy).toBeCloseTo(-1 - 0.3 * 20, 12);
  });

  it.each([7, 60, 240, 1000])(
    '[F70] a duration of whole steps ends with the last of them, whatever the rounding: 1 / %d s',
    (rate) => {
      const world = new World();
      world.addParticle({ x: 0, y: 0 });
      run(world, 3, 1 / rate);
      const burn = world.addForce(lasting(push, 50 / rate));
      for (let step = 0; step < 49; step++) world.step(1 / rate);
      expect(burn.ended).toBe(false);
      world.step(1 / rate);
      expect(burn.ended).toBe(true);
    },
  );

  it('[F70] starts with the first step that it takes part in, and again when restarted', () => {
    const world = new World();
    const rocket = world.addParticle({ x: 0, y: 0 });
    run(world, 1, 0.1);
    const burn = world.addForce(lasting(push, 0.2));
    run(world, 1, 0.1);
    expect(rocket.vx).toBeCloseTo(0.6, 12);
    burn.restart();
    expect([burn.remaining, burn.ended]).toEqual([0.2, false]);
    run(world, 1, 0.1);
    expect(rocket.vx).toBeCloseTo(1.2, 12);
  });

  it('[F70] a step that failed does not count', () => {
    const world = new World();
    const rocket = world.addParticle({ x: 0, y: 0 });
    world.addForce(lasting(push, 0.25), [rocket]);
    let fault = false;
    world.addForce({ apply: ({ fx }) => void (fx[rocket.slot] *= fault ? Number.NaN : 1) });
    world.step(0.1);
    fault = true;
    expect(() => world.step(0.1)).toThrow('finite');
    fault = false;
    run(world, 1, 0.1);
    expect(rocket.vx).toBeCloseTo(0.75, 12);
  });

  it('[F70] the share of the last step holds for particles that are no targets too, as with springs', () => {
    const world = new World();
    const bob = world.addParticle({ x: 2, y: 0 });
    const springs = new Springs();
    springs.add({ x: 0, y: 0 }, bob, { stiffness: 4, restLength: 1 });
    world.addForce(lasting(springs, 0.001));
    world.step(0.01);
    expect(bob.vx).toBeCloseTo(-0.004, 12);
  });
});

describe('a force that runs on fuel', () => {
  it.each([
    [5, 1, 1 / 60],
    [0.7, 0.3, 1 / 60],
    [10, 2, 0.3],
  ])(
    '[F71] gives exactly the impulse that the fuel is good for: %d at %d for each N·s, steps of %d s',
    (fuel, per, dt) => {
      const world = new World();
      const rocket = world.addParticle({ x: 0, y: 0, mass: 2 });
      const engine = world.addForce(fuelled(push, { fuel, perNewtonSecond: per }), [rocket]);
      run(world, 5, dt);
      expect((Math.sqrt(rocket.vx ** 2 + rocket.vy ** 2) * 2 * per) / fuel).toBeCloseTo(1, 12);
      expect([engine.fuel, engine.empty]).toEqual([0, true]);
    },
  );

  it('[F71] uses none while the force is off, and goes on when filled up', () => {
    const world = new World();
    const rocket = world.addParticle({ x: 0, y: 0 });
    let throttle = 0;
    const thrust: ForceGenerator = {
      apply({ fx }, { slots, count }) {
        for (let t = 0; t < count; t++) fx[slots[t]] += throttle;
      },
    };
    const engine = world.addForce(fuelled(thrust, { fuel: 3 }), [rocket]);
    run(world, 1, 0.1);
    expect([engine.fuel, engine.empty, rocket.vx]).toEqual([3, false, 0]);
    throttle = 10;
    world.step(0.1);
    expect(engine.fuel).toBeCloseTo(2, 12);
    run(world, 1, 0.1);
    expect([engine.empty, rocket.vx]).toEqual([true, expect.closeTo(3, 12)]);
    engine.fuel = 1;
    run(world, 1, 0.1);
    expect(rocket.vx).toBeCloseTo(4, 12);
  });

  it('[F71] targets share the tank, and other forces use none of it', () => {
    const world = new World();
    const [a, b] = [0, 1].map((x) => world.addParticle({ x, y: 0 }));
    world.addForce(weight);
    world.addForce(fuelled(push, { fuel: 4 }));
    run(world, 1, 0.1);
    expect(a.vx).toBeCloseTo((4 / 2 / 5) * 3, 12);
    expect(b.vx).toBe(a.vx);
    expect(a.vy).toBeCloseTo(-10 - (4 / 2 / 5) * 4, 12);
  });
});

it.each([0, -1, NaN, Infinity, '1' as never])('[F72] refuses a duration of %s', (duration) => {
  expect(() => lasting(push, duration)).toThrow('lasting: duration must be a positive, finite number of seconds');
});

it('[F72] refuses what is no generator and no fuel', () => {
  expect(() => lasting(undefined as never, 1)).toThrow('lasting: a force generator must have a method apply');
  expect(() => fuelled(5 as never, { fuel: 1 })).toThrow('fuelled: a force generator must have a method apply');
  expect(() => lasting((() => {}) as never, 1)).toThrow('Wrap a function of one particle in forEachParticle.');
  expect(() => fuelled(push, undefined as never)).toThrow('fuelled: options must be an object');
  expect(() => fuelled(push, { fuel: -1 })).toThrow('fuelled: fuel must be a finite number');
  expect(() => fuelled(push, { fuel: 1, perNewtonSecond: 0 })).toThrow('fuelled: perNewtonSecond must be');
  expect(() => {
    fuelled(push, { fuel: 1 }).fuel = NaN;
  }).toThrow('Fuelled.fuel');
});

it('[F72] a force that is not finite is named, and does not hide in the fuel', () => {
  const world = new World();
  world.addParticle({ x: 0, y: 0 });
  const bad: ForceGenerator = { apply: ({ fx }) => void fx.fill(NaN) };
  world.addForce(fuelled(bad, { fuel: 5 }));
  expect(() => world.step(1 / 60)).toThrow('Fuelled');
});

it('[F73] a step leaves no garbage', () => {
  const world = new World();
  for (let i = 0; i < 200; i++) world.addParticle({ x: i, y: 0 });
  world.addForce(lasting(push, 1e6));
  world.addForce(fuelled(push, { fuel: 1e12 }));
  expect(garbagePerStep(world)).toBeLessThan(250);
});
