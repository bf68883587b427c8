import { Random, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run, thrownBy } from '../helpers.ts';

describe('slots', () => {
  it('[P3] keep their particles while others come and go', () => {
    const world = new World();
    const particles = Array.from({ length: 10 }, (_, i) => world.addParticle({ x: i, y: -i }));
    for (const i of [2, 7, 4]) particles[i].remove();
    for (const i of [0, 1, 3, 5, 6, 8, 9]) {
      expect(particles[i].alive).toBe(true);
      expect([particles[i].slot, particles[i].x, particles[i].y]).toEqual([i, i, -i]);
    }
    expect(world.particleCount).toBe(7);
  });

  it('[P3] are used again, the last freed first', () => {
    const world = new World();
    const particles = Array.from({ length: 5 }, (_, i) => world.addParticle({ x: i, y: 0 }));
    particles[1].remove();
    particles[3].remove();
    expect(world.addParticle({ x: 9, y: 0 }).slot).toBe(3);
    expect(world.addParticle({ x: 9, y: 0 }).slot).toBe(1);
    expect(world.addParticle({ x: 9, y: 0 }).slot).toBe(5);
  });

  it('[P4] remove, reuse, remove a different one, ask again', () => {
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0 });
    const b = world.addParticle({ x: 1, y: 0 });
    a.remove();
    const c = world.addParticle({ x: 2, y: 0 });
    expect(c.slot).toBe(a.slot);
    b.remove();
    expect([a.alive, b.alive, c.alive]).toEqual([false, false, true]);
    expect(c.x).toBe(2);
    const d = world.addParticle({ x: 3, y: 0 });
    expect([d.slot, d.x, c.x]).toEqual([b.slot, 3, 2]);
    c.remove();
    expect([a.alive, b.alive, c.alive, d.alive]).toEqual([false, false, false, true]);
  });

  it('[P3] start over when the world is empty, and old handles stay dead', () => {
    const world = new World();
    const old = Array.from({ length: 3 }, () => world.addParticle({ x: 0, y: 0 }));
    for (const particle of old) particle.remove();
    expect([world.particleCount, world.particles.count]).toEqual([0, 0]);
    const fresh = Array.from({ length: 3 }, () => world.addParticle({ x: 0, y: 0 }));
    expect(fresh.map(({ slot }) => slot)).toEqual([0, 1, 2]);
    expect(old.some(({ alive }) => alive)).toBe(false);
    expect(fresh.every(({ alive }) => alive)).toBe(true);
  });

  it('[P3] a reused slot has nothing of the particle before', () => {
    const world = new World();
    const fields = ['x', 'y', 'vx', 'vy', 'ax', 'ay', 'mass', 'damping', 'radius', 'lifetime', 'group'] as const;
    world.addParticle({ x: 0, y: 0 });
    const old = world.addParticle({
      x: 1,
      y: 1,
      vx: 1,
      vy: 1,
      ax: 1,
      ay: 1,
      mass: 5,
      damping: 0.1,
      radius: 3,
      lifetime: 9,
      group: 4,
    });
    old.applyForce(7, 7);
    old.remove();
    const next = world.addParticle({ x: 0, y: 0 });
    const reference = new World().addParticle({ x: 0, y: 0 });
    expect(next.slot).toBe(old.slot);
    for (const name of fields) expect(next[name]).toBe(reference[name]);
    const { fx, fy, previousX, previousY } = world.particles;
    expect([fx[1], fy[1], previousX[1], previousY[1]]).toEqual([0, 0, 0, 0]);
  });

  it('[P3] a free slot stays finite and where it is', () => {
    const world = new World({ gravity: { x: 1, y: -10 } });
    const gone = world.addParticle({ x: 5, y: 5, vx: 9, vy: 9, ax: 3, ay: 3, damping: 0.5 });
    world.addParticle({ x: 0, y: 0 });
    gone.remove();
    run(world, 100);
    const { x, y, vx, vy, alive } = world.particles;
    expect([x[0], y[0], vx[0], vy[0], alive[0]]).toEqual([0, 0, 0, 0, 0]);
  });

  it('[P4] a thousand random arrivals and departures agree with a plain list', () => {
    const random = new Random(17);
    const world = new World();
    const living = new Map<ReturnType<typeof world.addParticle>, number>();
    const dead: ReturnType<typeof world.addParticle>[] = [];
    for (let i = 0; i < 5000; i++) {
      if (living.size === 0 || random.next() < 0.52) {
        living.set(world.addParticle({ x: i, y: 0 }), i);
      } else {
        const particle = [...living.keys()][random.integer(0, living.size - 1)];
        particle.remove();
        living.delete(particle);
        dead.push(particle);
      }
    }
    expect(world.particleCount).toBe(living.size);
    for (const [particle, x] of living) {
      expect(particle.alive && particle.x === x && world.particleAt(particle.slot) === particle).toBe(true);
    }
    expect(dead.some(({ alive }) => alive)).toBe(false);
    expect(new Set([...living.keys()].map(({ slot }) => slot)).size).toBe(living.size);
  });
});

describe('growth', () => {
  it('[P9] keeps every number of every particle', () => {
    const world = new World();
    const options = (i: number) => ({
      x: i,
      y: 2 * i,
      vx: 3 * i,
      vy: -i,
      ax: i / 2,
      ay: i / 3,
      mass: i + 1,
      damping: 1 / (i + 1),
      radius: i / 7,
      lifetime: i + 2,
      group: i,
    });
    const particles = Array.from({ length: 1000 }, (_, i) => {
      const particle = world.addParticle(options(i));
      particle.applyForce(i, 2 * i);
      return particle;
    });
    for (let i = 0; i < 1000; i++) {
      expect(particles[i]).toMatchObject(options(i));
      expect([world.particles.fx[i], world.particles.fy[i]]).toEqual([i, 2 * i]);
    }
  });

  it('[P9] in the middle of a run changes no bit of the motion', () => {
    const finals = [0, 4096].map((capacity) => {
      const world = new World({ gravity: { x: 0, y: -10 }, capacity });
      const particle = world.addParticle({ x: 0, y: 0, vx: 3, damping: 0.9 });
      for (let i = 0; i < 200; i++) {
        world.addParticle({ x: i, y: i });
        world.step(0.01);
      }
      return [particle.x, particle.y, particle.vx, particle.vy, world.particles.previousX[0]];
    });
    expect(finals[0]).toEqual(finals[1]);
  });

  it('[P9] room that was asked for is there, and the arrays stay the same objects until it is used up', () => {
    const world = new World({ capacity: 200 });
    const { x } = world.particles;
    expect(x.length).toBe(201); // and scenery's slot
    for (let i = 0; i < 200; i++) world.addParticle({ x: i, y: 0 });
    expect(world.particles.x).toBe(x);
    world.addParticle({ x: 200, y: 0 });
    expect(world.particles.x).not.toBe(x);
    expect(world.particles.x.length).toBe(402);
  });
});

describe('the low way', () => {
  it('[P10] spawn adds a particle at rest with the defaults, and a lifetime', () => {
    const world = new World();
    const slot = world.spawn(1, 2, 3);
    expect(world.particleAt(slot)).toMatchObject({ x: 1, y: 2, vx: 0, vy: 0, mass: 1, damping: 1, lifetime: 3 });
    expect(world.particleAt(world.spawn(0, 0)).lifetime).toBe(Infinity);
  });

  it('[P10] generations tell one particle of a slot from the next', () => {
    const world = new World();
    const slot = world.spawn(0, 0);
    const generation = world.generationAt(slot);
    world.particleAt(slot).remove();
    expect(world.spawn(0, 0)).toBe(slot);
    expect(world.generationAt(slot)).not.toBe(generation);
  });

  it('[X5] particleAt of a slot where nothing lives is an error', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0 }).remove();
    for (const slot of [0, 1, -1, 0.5, NaN, 1e9]) {
      const error = thrownBy(() => world.particleAt(slot));
      expect(error).toBeInstanceOf(RangeError);
      expect(error.message).toBe(`World.particleAt: slot must be one where a particle lives; got ${slot}.`);
    }
  });
});

describe('lifetime', () => {
  it('[P11] ends with the step nearest to it', () => {
    for (const [lifetime, steps] of [
      [1, 10],
      [0.24, 2],
      [0.26, 3],
      [0.1, 1],
      [0.001, 1],
      [1.04999, 10],
      [1.05001, 11],
    ]) {
      const world = new World();
      const particle = world.addParticle({ x: 0, y: 0, lifetime });
      let taken = 0;
      while (particle.alive) {
        world.step(0.1);
        taken++;
      }
      expect([lifetime, taken]).toEqual([lifetime, steps]);
      expect(world.particleCount).toBe(0);
    }
  });

  it('[P11] is not spent by rounding: a whole number of steps is that many', () => {
    for (const dt of [1 / 60, 1 / 30, 0.1, 1 / 144, 0.007]) {
      for (const steps of [1, 3, 60, 600, 5000]) {
        const world = new World();
        const particle = world.addParticle({ x: 0, y: 0, lifetime: steps * dt });
        run(world, steps - 1, dt);
        expect(particle.alive).toBe(true);
        world.step(dt);
        expect(particle.alive).toBe(false);
      }
    }
  });

  it('[P11] can be set and taken back', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    particle.lifetime = 0.2;
    world.step(0.1);
    expect(particle.lifetime).toBeCloseTo(0.1, 12);
    particle.lifetime = Infinity;
    run(world, 100, 0.1);
    expect(particle.alive).toBe(true);
    particle.lifetime = 0.1;
    world.step(0.1);
    expect(particle.alive).toBe(false);
  });

  it('[P11] a thousand that end at once all end, and the others stay', () => {
    const world = new World();
    const mortal = Array.from({ length: 1000 }, () => world.addParticle({ x: 0, y: 0, lifetime: 0.5 }));
    const others = Array.from({ length: 10 }, () => world.addParticle({ x: 0, y: 0, lifetime: 0.6 }));
    run(world, 5, 0.1);
    expect(mortal.some(({ alive }) => alive)).toBe(false);
    expect(others.every(({ alive }) => alive)).toBe(true);
    expect(world.particleCount).toBe(10);
  });

  it('[P11] of a pinned particle runs, too', () => {
    const world = new World();
    const pin = world.addParticle({ x: 0, y: 0, mass: Infinity, lifetime: 0.1 });
    world.step(0.1);
    expect(pin.alive).toBe(false);
  });
});
