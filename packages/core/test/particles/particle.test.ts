import { Gravity, Particle, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { failsUnchanged, run, thrownBy } from '../helpers.ts';

const numbers = ['x', 'y', 'vx', 'vy', 'ax', 'ay', 'mass', 'damping', 'radius', 'lifetime', 'group'] as const;

describe('a new particle', () => {
  it('[P1] has a default for everything but its position', () => {
    const particle = new World().addParticle({ x: 2, y: 3 });
    const shown = Object.fromEntries(numbers.map((name) => [name, particle[name]]));
    expect(shown).toEqual({
      x: 2,
      y: 3,
      vx: 0,
      vy: 0,
      ax: 0,
      ay: 0,
      mass: 1,
      damping: 1,
      radius: 0,
      lifetime: Infinity,
      group: 0,
    });
    expect(particle.inverseMass).toBe(1);
    expect(particle.alive).toBe(true);
    expect(particle).toBeInstanceOf(Particle);
  });

  it('[P1] has what it was given, in the handle and in the arrays', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0 });
    const given = {
      x: 1,
      y: 2,
      vx: 3,
      vy: 4,
      ax: 5,
      ay: 6,
      mass: 8,
      damping: 0.5,
      radius: 7,
      lifetime: 9,
      group: 65535,
    };
    const particle = world.addParticle(given);
    expect(particle.slot).toBe(1);
    for (const name of numbers) {
      expect(particle[name]).toBe(given[name]);
      expect(world.particles[name][1]).toBe(given[name]);
    }
    expect(particle.inverseMass).toBe(0.125);
    expect(world.particles.inverseMass[1]).toBe(0.125);
    expect(world.particles.alive[1]).toBe(1);
  });

  it('[P1] does not keep the options: changing them later changes nothing', () => {
    const options = { x: 1, y: 2 };
    const particle = new World().addParticle(options);
    options.x = 50;
    expect(particle.x).toBe(1);
  });

  it('[P1] reads frozen options', () => {
    expect(new World().addParticle(Object.freeze({ x: 1, y: 2, vx: 3 })).vx).toBe(3);
  });
});

describe('a handle', () => {
  it('[P2] writes what the arrays hold, and reads what was written to the arrays', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    const given = { x: 1, y: 2, vx: 3, vy: 4, ax: 5, ay: 6, mass: 8, damping: 0.5, radius: 7, lifetime: 9, group: 10 };
    for (const name of numbers) {
      particle[name] = given[name];
      expect(world.particles[name][0]).toBe(given[name]);
      world.particles[name][0] = 11;
      expect(particle[name]).toBe(11);
    }
  });

  it('[P2] is one object a particle', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    expect(world.particleAt(particle.slot)).toBe(particle);
    world.removeParticle(particle);
    const next = world.addParticle({ x: 0, y: 0 });
    expect(next.slot).toBe(particle.slot);
    expect(next).not.toBe(particle);
    expect(world.particleAt(particle.slot)).toBe(next);
  });

  it('[P2] is made for spawned particles on demand, and the same from then on', () => {
    const world = new World();
    const slot = world.spawn(1, 2);
    const handle = world.particleAt(slot);
    expect(handle.x).toBe(1);
    expect(world.particleAt(slot)).toBe(handle);
  });

  it('[P5] mass and inverse mass go together', () => {
    const particle = new World().addParticle({ x: 0, y: 0, mass: 4 });
    expect(particle.inverseMass).toBe(0.25);
    particle.mass = Infinity;
    expect(particle.inverseMass).toBe(0);
    particle.mass = 0.5;
    expect(particle.inverseMass).toBe(2);
  });

  it('[P6] an impulse changes the velocity at once, by impulse over mass', () => {
    const particle = new World().addParticle({ x: 0, y: 0, vx: 1, mass: 4 });
    particle.applyImpulse(2, -8);
    expect([particle.vx, particle.vy]).toEqual([1.5, -2]);
    expect([particle.x, particle.y]).toEqual([0, 0]);
  });

  it('[P7] forces add up, and act during the next step alone', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, mass: 2 });
    particle.applyForce(3, 0);
    particle.applyForce(1, -2);
    expect(particle.vx).toBe(0);
    world.step(0.5);
    expect([particle.vx, particle.vy]).toEqual([1, -0.5]);
    expect([world.particles.fx[0], world.particles.fy[0]]).toEqual([0, 0]);
    run(world, 10, 0.5);
    expect([particle.vx, particle.vy]).toEqual([1, -0.5]);
  });
});

describe('a removed particle', () => {
  /** Every member that asks for a particle that is there. */
  const uses: [string, (particle: Particle) => unknown][] = [
    ...[...numbers, 'inverseMass' as const].map((name): [string, (p: Particle) => unknown] => [name, (p) => p[name]]),
    ...numbers.map((name): [string, (p: Particle) => unknown] => [name, (p) => (p[name] = 1)]),
    ['applyForce', (p) => p.applyForce(1, 1)],
    ['applyImpulse', (p) => p.applyImpulse(1, 1)],
    ['asleep', (p) => p.asleep],
    ['wake', (p) => p.wake()],
    ['remove', (p) => p.remove()],
  ];

  it.each(uses)('[X5] using its %s is an error that says so, also when its slot lives again', (name, use) => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    particle.remove();
    for (const reused of [false, true]) {
      if (reused) expect(world.addParticle({ x: 5, y: 5 }).slot).toBe(particle.slot);
      const error = failsUnchanged(world, () => use(particle));
      expect(error).toBeInstanceOf(Error);
      expect(error.message).toBe(
        `Particle.${name}: the particle must be in its world; the one of slot 0 was removed. ` +
          'Ask particle.alive before using a handle that may be out of date.',
      );
    }
  });

  it('[P4] tells so by alive, and is in no world', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    expect(particle.isIn(world.particles)).toBe(true);
    particle.remove();
    expect(particle.alive).toBe(false);
    expect(particle.isIn(world.particles)).toBe(false);
    world.addParticle({ x: 0, y: 0 });
    expect(particle.alive).toBe(false);
    expect(particle.slot).toBe(0);
  });

  it('[X5] the member list above is complete', () => {
    const members = Object.entries(Object.getOwnPropertyDescriptors(Particle.prototype)).map(([name]) => name);
    const covered = new Set([...uses.map(([name]) => name), 'constructor', 'alive', 'isIn']);
    // What is added to particles later is named here, and goes into `numbers`.
    expect(members.filter((name) => !covered.has(name) && !LATER.has(name))).toEqual([]);
  });
});

/** Numbers that have tests of their own, with the contacts. */
const LATER = new Set(['restitution', 'friction', 'category', 'mask', 'sensor']);

describe('a particle of another world', () => {
  it('[X5] is an error wherever a world takes a particle', () => {
    const world = new World();
    const stranger = new World().addParticle({ x: 0, y: 0 });
    world.addParticle({ x: 0, y: 0 });
    const must = 'the particle must be in this world; it lives in another world.';
    const force = world.addForce(new Gravity({ x: 0, y: -1 }), []);
    expect(failsUnchanged(world, () => world.removeParticle(stranger)).message).toBe(`World.removeParticle: ${must}`);
    expect(failsUnchanged(world, () => world.addForce(force, [stranger])).message).toBe(`World.addForce: ${must}`);
    expect(stranger.alive).toBe(true);
    expect(stranger.isIn(world.particles)).toBe(false);
  });

  it('[X5] a removed one is told apart from a stranger', () => {
    const world = new World();
    const gone = world.addParticle({ x: 0, y: 0 });
    gone.remove();
    const must = 'the particle must be in this world; it was removed.';
    expect(thrownBy(() => world.removeParticle(gone)).message).toBe(`World.removeParticle: ${must}`);
    expect(thrownBy(() => world.addForce(new Gravity({ x: 0, y: 1 }), [gone])).message).toBe(`World.addForce: ${must}`);
  });
});

describe('a pinned particle', () => {
  it.each(['semi-implicit', 'with damping', 'with an acceleration'])(
    '[P8] no force, impulse, gravity or acceleration moves it: %s',
    (kind) => {
      const world = new World({ gravity: { x: 3, y: -9.81 } });
      const pin = world.addParticle({ x: 1, y: 2, mass: Infinity });
      if (kind === 'with damping') pin.damping = 0.5;
      if (kind === 'with an acceleration') pin.ax = 100;
      world.addForce(new Gravity({ x: 0, y: -5 }));
      for (let i = 0; i < 100; i++) {
        pin.applyForce(1e6, -1e6);
        pin.applyImpulse(1e6, 1e6);
        world.step(0.1);
      }
      expect([pin.x, pin.y, pin.vx, pin.vy]).toEqual([1, 2, 0, 0]);
    },
  );

  it('[P8] one with a velocity keeps it, whatever its damping', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const lift = world.addParticle({ x: 0, y: 0, vx: 0.5, vy: 2, mass: Infinity, damping: 0, ax: 3 });
    run(world, 8, 0.25);
    expect([lift.vx, lift.vy]).toEqual([0.5, 2]);
    expect([lift.x, lift.y]).toEqual([1, 4]);
  });

  it('[P8] can be let go', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const particle = world.addParticle({ x: 0, y: 0, mass: Infinity });
    run(world, 10, 0.1);
    particle.mass = 1;
    world.step(0.1);
    expect(particle.vy).toBe(-1);
  });
});
