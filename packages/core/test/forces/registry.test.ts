import { type ForceGenerator, Gravity, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { Recorder, run } from '../helpers.ts';

describe('which particles a force acts on', () => {
  it('[F1] without a list on all, those to come included', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0 });
    const force = world.addForce(new Recorder());
    world.step(0.1);
    expect(force.last).toEqual([0]);
    world.addParticle({ x: 0, y: 0 });
    const third = world.addParticle({ x: 0, y: 0 });
    world.step(0.1);
    expect(force.last).toEqual([0, 1, 2]);
    third.remove();
    world.step(0.1);
    expect(force.last).toEqual([0, 1]);
  });

  it('[F2] with a list on those alone, in the order of the list', () => {
    const world = new World();
    const [a, b, c] = [0, 1, 2].map((x) => world.addParticle({ x, y: 0 }));
    const force = world.addForce(new Recorder(), [c, a]);
    world.step(0.1);
    expect(force.last).toEqual([2, 0]);
    world.addForce(force, [b]);
    world.step(0.1);
    expect(force.last).toEqual([2, 0, 1]);
  });

  it('[F2] the list may be any iterable, and changing it later changes nothing', () => {
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0 });
    const b = world.addParticle({ x: 0, y: 0 });
    const chosen = new Set([a]);
    const force = world.addForce(new Recorder(), chosen);
    chosen.add(b);
    world.step(0.1);
    expect(force.last).toEqual([0]);
    expect(world.addForce(new Recorder(), [])).toBeInstanceOf(Recorder);
  });

  it('[F2] added twice for a particle it acts once', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    const force = world.addForce(new Recorder(1), [particle, particle]);
    world.addForce(force, [particle]);
    world.step(1);
    expect(force.runs.length).toBe(1);
    expect(particle.vx).toBe(1);
    const everywhere = world.addForce(new Recorder(1));
    world.addForce(everywhere);
    world.step(1);
    expect(particle.vx).toBe(3);
  });

  it('[F2] chosen particles, then all: it acts on all, once', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    world.addParticle({ x: 0, y: 0 });
    const force = world.addForce(new Recorder(1), [particle]);
    world.addForce(force);
    world.step(1);
    expect(force.runs).toEqual([[0, 1]]);
    world.addForce(force, [particle]);
    world.step(1);
    expect(force.last).toEqual([0, 1]);
  });

  it('[F3] a removed particle drops out, and what lives in its slot later is not acted on', () => {
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0 });
    const b = world.addParticle({ x: 0, y: 0 });
    const force = world.addForce(new Recorder(1), [a, b]);
    a.remove();
    const c = world.addParticle({ x: 0, y: 0 });
    expect(c.slot).toBe(a.slot);
    world.step(1);
    expect(force.last).toEqual([b.slot]);
    expect([c.vx, b.vx]).toEqual([0, 1]);
  });

  it('[F3] when all its particles are gone it acts on none, not on all', () => {
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0 });
    const force = world.addForce(new Recorder(1), [a]);
    a.remove();
    const c = world.addParticle({ x: 0, y: 0 });
    world.step(1);
    expect(force.last).toEqual([]);
    expect(c.vx).toBe(0);
    const none = world.addForce(new Recorder(1), []);
    world.step(1);
    expect(none.last).toEqual([]);
  });

  it('[F3] particles that come and go in numbers, checked against a plain list', () => {
    const world = new World();
    let chosen = Array.from({ length: 200 }, () => world.addParticle({ x: 0, y: 0 }));
    const force = world.addForce(new Recorder(1), chosen);
    for (let round = 0; round < 20; round++) {
      const [gone, kept] = [chosen.filter((_, i) => i % 5 === round % 5), chosen.filter((_, i) => i % 5 !== round % 5)];
      for (const particle of gone) particle.remove();
      const fresh = Array.from({ length: 30 }, () => world.addParticle({ x: 0, y: 0 }));
      chosen = [...kept, ...fresh];
      world.addForce(force, fresh);
      for (let i = 0; i < 5; i++) world.addParticle({ x: 0, y: 0 });
      world.step(0.1);
      expect(force.last).toEqual(chosen.map(({ slot }) => slot));
    }
  });
});

describe('taking a force out', () => {
  it('[F4] without a list it is out of the world, and may come back', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    const force = world.addForce(new Recorder(1));
    world.removeForce(force);
    world.step(1);
    expect([particle.vx, force.runs.length]).toEqual([0, 0]);
    world.addForce(force, [particle]);
    world.step(1);
    expect(particle.vx).toBe(1);
  });

  it('[F4] with a list it leaves those particles alone', () => {
    const world = new World();
    const [a, b] = [0, 1].map((x) => world.addParticle({ x, y: 0 }));
    const force = world.addForce(new Recorder(1), [a, b]);
    world.removeForce(force, [a]);
    world.step(1);
    expect(force.last).toEqual([1]);
    world.removeForce(force, [b]);
    world.step(1);
    expect(force.last).toEqual([]);
  });

  it('[F4] one that is not in the world is an error, and so is freeing one particle of a force on all', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    const force = new Gravity({ x: 0, y: -1 });
    expect(() => world.removeForce(force)).toThrow(
      /^World\.removeForce: a force must be in the world to be taken out; Gravity is not\./,
    );
    world.addForce(force);
    expect(() => world.removeForce(force, [particle])).toThrow(
      /^World\.removeForce: the force acts on all particles; single ones cannot be freed of it\. Add it with a list/,
    );
    world.step(1);
    expect(particle.vy).toBe(-1);
    world.removeForce(force);
    expect(() => world.removeForce(force)).toThrow(/is not\.$/);
  });
});

describe('the accumulator', () => {
  it('[F5] holds the sum of all forces, whatever their order', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, mass: 2 });
    for (const force of [1, 2, 4, 8]) world.addForce(new Recorder(force));
    particle.applyForce(16, 0);
    world.step(1);
    expect(particle.vx).toBe(31 / 2);
  });

  it('[F5] is cleared by each step', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, damping: 1 });
    const seen: number[] = [];
    world.addForce({ apply: ({ fx, fy }) => void seen.push(fx[0], fy[0]) });
    world.addForce(new Recorder(5));
    run(world, 3, 0.1);
    expect(seen).toEqual([0, 0, 0, 0, 0, 0]);
    expect(world.particles.fx[0]).toBe(0);
    expect(particle.vx).toBeCloseTo(1.5, 12);
  });

  it('[F5] generators run once a step, in the order in which they were first added', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    const order: string[] = [];
    const named = (name: string): ForceGenerator => ({ apply: () => void order.push(name) });
    const [a, b, c] = ['a', 'b', 'c'].map(named);
    world.addForce(a);
    world.addForce(b, [particle]);
    world.addForce(c);
    world.addForce(a);
    run(world, 2, 0.1);
    expect(order.join('')).toBe('abcabc');
    world.removeForce(a);
    world.addForce(a);
    world.step(0.1);
    expect(order.join('')).toBe('abcabcbca');
  });
});

describe("a game's own force", () => {
  it('[F6] over the arrays: gets the arrays, its targets and the duration', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0 });
    const target = world.addParticle({ x: 0, y: 0, mass: 4 });
    const durations: number[] = [];
    const wind: ForceGenerator = {
      apply({ fx, mass }, targets, dt) {
        durations.push(dt);
        for (let t = 0; t < targets.count; t++) {
          expect(targets.particle(t)).toBe(target);
          fx[targets.slots[t]] += 2 * mass[targets.slots[t]];
        }
      },
    };
    expect(world.addForce(wind, [target])).toBe(wind);
    world.step(0.5);
    world.step(0.25);
    expect(durations).toEqual([0.5, 0.25]);
    expect(target.vx).toBe(1.5);
  });

  it('[F6] one generator may serve several worlds', () => {
    const gravity = new Gravity({ x: 0, y: -2 });
    const worlds = [new World(), new World()];
    const particles = worlds.map((world) => {
      world.addForce(gravity);
      return world.addParticle({ x: 0, y: 0 });
    });
    worlds[0].step(1);
    worlds[1].step(2);
    expect(particles.map(({ vy }) => vy)).toEqual([-2, -4]);
  });
});
