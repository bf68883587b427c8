import { explicitEuler, type Particle, PointerSpring, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { garbagePerStep, run } from './measure.ts';

function held(mass: number, options: object = {}, worldOptions: object = {}): [World, Particle, PointerSpring] {
  const world = new World(worldOptions);
  const ball = world.addParticle({ x: 0, y: 0, mass });
  const hand = world.addForce(new PointerSpring(options));
  hand.grab(ball);
  return [world, ball, hand];
}

describe('dragging by a pointer', () => {
  it('[F80] does nothing until the pointer moves, then draws the particle there and stops without overshoot', () => {
    const [world, ball, hand] = held(1);
    run(world, 1, 1 / 60);
    expect([ball.x, ball.y, hand.x, hand.y]).toEqual([0, 0, 0, 0]);
    hand.moveTo(10, -5);
    let farthest = 0;
    run(world, 2, 1 / 60, () => {
      farthest = Math.max(farthest, ball.x);
    });
    expect(farthest).toBeLessThanOrEqual(10 + 1e-9);
    expect(ball.x).toBeCloseTo(10, 6);
    expect(ball.y).toBeCloseTo(-5, 6);
  });

  it('[F80] moves 10 g and 10 t alike', () => {
    const place = (mass: number) => {
      const [world, ball, hand] = held(mass);
      hand.moveTo(1, 1);
      run(world, 0.1, 1 / 60);
      return ball.x;
    };
    expect(place(0.01)).toBeCloseTo(place(1), 12);
    expect(place(10000)).toBeCloseTo(place(1), 12);
    expect(place(1)).toBeGreaterThan(0.5);
  });

  it('[F80] swings at its frequency when not damped much, in short steps', () => {
    const [world, ball, hand] = held(3, { frequency: 2, dampingRatio: 0.02 });
    hand.moveTo(1, 0);
    run(world, 0.25, 1 / 2000);
    expect(ball.x).toBeGreaterThan(1.9); // half a swing
    run(world, 0.25, 1 / 2000);
    expect(ball.x).toBeLessThan(0.2);
  });

  for (const integrator of [undefined, explicitEuler]) {
    const name = integrator ? 'explicit' : 'semi-implicit';
    it.each(
      [0.01, 1, 10000].flatMap((mass) => [0.1, 5, 60, 1000, 1e6].flatMap((f) => [0.1, 1, 20].map((z) => [mass, f, z]))),
    )(`[F81] is stable at 1/60 s, ${name}: %d kg, %d Hz, damping ratio %d`, (mass, frequency, dampingRatio) => {
      const options = { frequency, dampingRatio, maxForce: Infinity };
      const [world, ball, hand] = held(mass, options, integrator ? { integrator } : {});
      hand.moveTo(1, 0);
      let farthest = 0;
      run(world, 5, 1 / 60, () => {
        farthest = Math.max(farthest, Math.abs(ball.x - 1));
      });
      expect(farthest).toBeLessThan(2);
      const start = Math.abs(ball.x - 1) + Math.abs(ball.vx) / (2 * Math.PI * frequency);
      run(world, 20, 1 / 60);
      const end = Math.abs(ball.x - 1) + Math.abs(ball.vx) / (2 * Math.PI * frequency);
      expect(end).toBeLessThanOrEqual(start + 1e-12);
    });
  }

  it('[F82] never pulls harder than its limit, and comes to rest all the same', () => {
    const [world, ball, hand] = held(2, { frequency: 2, maxForce: 50 });
    hand.moveTo(8, 6);
    let greatest = 0;
    run(world, 20, 1 / 60, () => {
      greatest = Math.max(greatest, Math.sqrt(hand.fx ** 2 + hand.fy ** 2));
      expect(Math.sqrt((ball.x - 8) ** 2 + (ball.y - 6) ** 2)).toBeLessThanOrEqual(10);
    });
    expect(greatest).toBeLessThanOrEqual(50 * (1 + 1e-12));
    expect(greatest).toBeGreaterThan(49.9);
    expect(ball.x).toBeCloseTo(8, 6);
    expect(ball.y).toBeCloseTo(6, 6);
  });

  it('[F82] by default lifts whatever it holds, and with a limit not what is too heavy', () => {
    const lifted = (options: object) => {
      const [world, ball, hand] = held(100, options, { gravity: { x: 0, y: -10 } });
      hand.moveTo(0, 1);
      run(world, 1, 1 / 60);
      return ball.y;
    };
    expect(lifted({})).toBeGreaterThan(0.95);
    expect(lifted({ maxForce: 900 })).toBeLessThan(-0.4);
    const [world, , hand] = held(3);
    hand.moveTo(1e6, 0);
    world.step(1 / 60);
    expect(hand.fx).toBeCloseTo(3000, 9);
  });

  it('[F83] lets go with the velocity that the particle has', () => {
    const [world, ball, hand] = held(1);
    hand.moveTo(5, 0);
    run(world, 0.1, 1 / 60);
    expect(hand.held).toBe(ball);
    hand.release();
    const { vx } = ball;
    expect([hand.held, hand.fx, vx > 1]).toEqual([undefined, 0, true]);
    run(world, 1, 1 / 60);
    expect(ball.vx).toBe(vx);
  });

  it('[F83] a removed particle drops out, also when its slot is used again; a pinned one stays', () => {
    const [world, ball, hand] = held(1);
    hand.moveTo(5, 0);
    ball.remove();
    const next = world.addParticle({ x: 0, y: 0 });
    expect(next.slot).toBe(ball.slot);
    world.step(1 / 60);
    expect([hand.held, next.vx]).toEqual([undefined, 0]);
    expect(() => hand.grab(ball)).toThrow('removed');
    next.mass = Infinity;
    hand.grab(next);
    hand.moveTo(1, 1);
    world.step(1 / 60);
    expect([next.x, hand.fx]).toEqual([0, 0]);
  });

  it.each([
    [{ frequency: 0 }, 'frequency must be a positive, finite number of hertz'],
    [{ dampingRatio: -1 }, 'dampingRatio must be'],
    [{ maxForce: 0 }, 'maxForce must be a positive number of newtons'],
    [null, 'options must be an object'],
  ])('[F84] refuses %o', (options, message) => {
    expect(() => new PointerSpring(options as object)).toThrow(`PointerSpring: ${message}`);
  });

  it('[F84] refuses what is no particle and no place', () => {
    const [, ball, hand] = held(1);
    expect(() => hand.grab({} as Particle)).toThrow('PointerSpring.grab: a particle must be');
    expect(hand.held).toBe(ball);
    expect(() => hand.moveTo(NaN, 0)).toThrow('PointerSpring.moveTo: x must be a finite number of metres');
    expect(() => hand.moveTo(0, '1' as never)).toThrow('PointerSpring.moveTo: y');
    expect([hand.x, hand.y]).toEqual([0, 0]);
  });

  it('[F85] a step leaves no garbage', () => {
    const [world, , hand] = held(1, { frequency: 1, dampingRatio: 0 });
    hand.moveTo(3, 0);
    expect(garbagePerStep(world)).toBeLessThan(250);
  });
});
