import { Drag, type Effect, Gravity, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { Recorder, run, snapshot } from '../helpers.ts';

describe('a world', () => {
  it('[W1] is empty and at time 0, without gravity', () => {
    const world = new World();
    expect([world.time, world.stepCount, world.particleCount, world.particles.count]).toEqual([0, 0, 0, 0]);
    expect(world.gravity).toEqual({ x: 0, y: 0 });
    run(world, 3);
    expect(world.stepCount).toBe(3);
  });

  it('[W2] a step adds its duration to the time, and one to the count', () => {
    const world = new World();
    world.step(0.25);
    world.step(0.5);
    expect([world.time, world.stepCount]).toEqual([0.75, 2]);
  });

  it('[W2] gravity can change between steps, and is a copy that nobody else can change', () => {
    const given = { x: 0, y: -10 };
    const world = new World({ gravity: given });
    const particle = world.addParticle({ x: 0, y: 0 });
    given.y = 99;
    world.step(1);
    world.gravity = { x: 5, y: 0 };
    world.step(1);
    expect([particle.vx, particle.vy]).toEqual([5, -10]);
    expect(Object.isFrozen(world.gravity)).toBe(true);
  });
});

describe('a step of 0', () => {
  it('[W3] changes nothing: no number, no accumulator, no lifetime, no count; forces and effects are not asked', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const particle = world.addParticle({ x: 1, y: 2, vx: 3, vy: 4, ax: 5, damping: 0, lifetime: 0.001 });
    world.addParticle({ x: 0, y: 0, vx: 1, lifetime: 100 });
    const force = world.addForce(new Recorder(7));
    let calls = 0;
    world.addEffect({ afterStep: () => void calls++ });
    particle.applyForce(8, 9);
    const before = snapshot(world);
    run(world, 10, 0);
    run(world, 10, -0);
    expect(snapshot(world)).toEqual(before);
    expect([force.runs.length, calls]).toEqual([0, 0]);
  });

  it('[W3] in between changes no bit of what follows', () => {
    const [plain, paused] = [false, true].map((pause) => {
      const world = new World({ gravity: { x: 0, y: -10 } });
      world.addParticle({ x: 1, y: 2, vx: 3, damping: 0.5, lifetime: 3 });
      for (let i = 0; i < 50; i++) {
        if (pause) world.step(0);
        world.step(1 / 60);
      }
      return snapshot(world);
    });
    expect(paused).toEqual(plain);
  });
});

describe('previous positions', () => {
  it('[W4] are those before the last step', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const particle = world.addParticle({ x: 1, y: 2, vx: 3 });
    for (let i = 0; i < 20; i++) {
      const { x, y } = particle;
      world.step(0.1);
      expect([world.particles.previousX[0], world.particles.previousY[0]]).toEqual([x, y]);
    }
  });

  it('[W4] of a new particle are where it was added, also in a slot that was used before', () => {
    const world = new World();
    const first = world.addParticle({ x: 1, y: 2, vx: 3 });
    world.addParticle({ x: 0, y: 0 });
    run(world, 5);
    first.remove();
    const next = world.addParticle({ x: 50, y: 60, vx: 1 });
    expect(next.slot).toBe(0);
    const { previousX, previousY } = world.particles;
    expect([previousX[0], previousY[0]]).toEqual([50, 60]);
    world.step(0.1);
    expect([world.particles.previousX[0], world.particles.previousY[0]]).toEqual([50, 60]);
    world.step(0.1);
    expect(world.particles.previousX[0]).toBeCloseTo(50.1, 12);
  });

  it('[W4] survive growth between steps', () => {
    const world = new World();
    const particle = world.addParticle({ x: 1, y: 2, vx: 10 });
    world.step(0.1);
    for (let i = 0; i < 200; i++) world.addParticle({ x: 0, y: 0 });
    expect(world.particles.previousX[0]).toBe(1);
    const { x } = particle;
    world.step(0.1);
    expect(world.particles.previousX[0]).toBe(x);
  });
});

describe('the order of a step', () => {
  it('[W5] forces see the state before it, effects the state after it, and the dying while they can still be read', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, vx: 10, lifetime: 0.2 });
    const seen: string[] = [];
    world.addForce({ apply: ({ x }) => void seen.push(`force at ${x[0]}`) });
    const effect: Effect = {
      afterStep({ particles }, expired, dt) {
        seen.push(`effect at ${particles.x[0]}, ${expired.count} dying, dt ${dt}, alive ${particles.alive[0]}`);
      },
    };
    world.addEffect(effect);
    run(world, 2, 0.1);
    expect(seen).toEqual([
      'force at 0',
      'effect at 1, 0 dying, dt 0.1, alive 1',
      'force at 1',
      'effect at 2, 1 dying, dt 0.1, alive 1',
    ]);
    expect(particle.alive).toBe(false);
  });

  it('[W5] forces added between steps act from the next on', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, vx: 8 });
    world.step(0.5);
    world.addForce(new Drag({ k1: 1 }));
    world.addForce(new Gravity({ x: 0, y: -2 }));
    expect([particle.vx, particle.vy]).toEqual([8, 0]);
    world.step(0.5);
    expect([particle.vx, particle.vy]).toEqual([4, -1]);
  });
});
