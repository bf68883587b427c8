import { Drag, forEachParticle, Gravity, type Particle, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../helpers.ts';

describe('Gravity', () => {
  it('[F10] pulls with m·g: masses fall alike', () => {
    const world = new World();
    const particles = [0.001, 1, 10_000].map((mass) => world.addParticle({ x: 0, y: 0, mass }));
    world.addForce(new Gravity({ x: 1, y: -10 }));
    run(world, 100, 0.01);
    for (const { vx, vy } of particles) {
      expect(vx).toBeCloseTo(1, 12);
      expect(vy).toBeCloseTo(-10, 11);
    }
  });

  it('[F10] may differ from particle to particle, on top of the gravity of the world', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const [stone, feather, balloon] = [0, 1, 2].map((x) => world.addParticle({ x, y: 0, mass: 2 }));
    world.addForce(new Gravity({ x: 0, y: 9 }), [feather]);
    world.addForce(new Gravity({ x: 0, y: 12 }), [balloon]);
    world.step(1);
    expect([stone.vy, feather.vy, balloon.vy]).toEqual([-10, -1, 2]);
  });

  it('[F10] an infinite mass feels none: the accumulator stays finite', () => {
    const world = new World();
    const pin = world.addParticle({ x: 0, y: 0, mass: Infinity });
    const loose = world.addParticle({ x: 0, y: 0 });
    world.addForce(new Gravity({ x: 3, y: -10 }));
    run(world, 10, 0.1);
    expect([pin.x, pin.y, pin.vx, pin.vy]).toEqual([0, 0, 0, 0]);
    expect(loose.vy).toBeCloseTo(-10, 12);
  });

  it('[F10] keeps a copy of g', () => {
    const g = { x: 0, y: -1 };
    const gravity = new Gravity(g);
    g.y = 5;
    expect(gravity.g).toEqual({ x: 0, y: -1 });
    expect(new Gravity(Object.freeze({ x: 0, y: -1 })).g.y).toBe(-1);
  });
});

describe('Drag', () => {
  /** The force that drag gives a particle in one step, from the change of velocity. */
  function forceOn(vx: number, vy: number, k1: number, k2: number, mass = 1): { x: number; y: number } {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, vx, vy, mass });
    world.addForce(new Drag({ k1, k2 }));
    const dt = 2 ** -20;
    world.step(dt);
    return { x: ((particle.vx - vx) / dt) * mass, y: ((particle.vy - vy) / dt) * mass };
  }

  it.each([
    [3, 4, 0.5, 0],
    [-3, 4, 0, 0.5],
    [3, -4, 0.25, 0.125],
    [-30, -40, 1, 2],
  ])('[F11] points against (%d, %d) with k1·|v| + k2·|v|² (k1 %d, k2 %d)', (vx, vy, k1, k2) => {
    const speed = Math.sqrt(vx * vx + vy * vy);
    const size = k1 * speed + k2 * speed * speed;
    const force = forceOn(vx, vy, k1, k2);
    expect(force.x).toBeCloseTo((-vx / speed) * size, 5);
    expect(force.y).toBeCloseTo((-vy / speed) * size, 5);
  });

  it('[F11] slows a heavy particle less', () => {
    const world = new World();
    const [light, heavy] = [1, 4].map((mass) => world.addParticle({ x: 0, y: 0, vx: 8, mass }));
    world.addForce(new Drag({ k1: 1 }));
    world.step(0.5);
    expect([light.vx, heavy.vx]).toEqual([4, 7]);
  });

  it('[F11] at rest there is none, and no NaN', () => {
    for (const options of [{ k1: 1 }, { k2: 1 }, { k1: 1, k2: 1 }]) {
      const world = new World();
      const particle = world.addParticle({ x: 1, y: 2 });
      world.addForce(new Drag(options));
      run(world, 10, 0.1);
      expect([particle.x, particle.y, particle.vx, particle.vy]).toEqual([1, 2, 0, 0]);
    }
  });

  it('[F11] k1 alone: each step keeps exactly 1 - k1·dt/m, which tends to e^(-k1·t/m)', () => {
    const [k1, mass, time] = [0.8, 2, 3];
    const exact = 10 * Math.exp((-k1 * time) / mass);
    const errors = [300, 600, 1200].map((steps) => {
      const world = new World();
      const particle = world.addParticle({ x: 0, y: 0, vx: 10, mass });
      world.addForce(new Drag({ k1 }));
      run(world, steps, time / steps);
      expect(particle.vx).toBeCloseTo(10 * (1 - (k1 * time) / steps / mass) ** steps, 12);
      return Math.abs(particle.vx - exact);
    });
    expect(errors[0] / errors[1]).toBeCloseTo(2, 1);
    expect(errors[1] / errors[2]).toBeCloseTo(2, 1);
  });

  it('[F11] k2 alone: the speed falls as v0 / (1 + k2·v0·t/m)', () => {
    const [k2, mass, time] = [0.3, 1.5, 2];
    const exact = 10 / (1 + (k2 * 10 * time) / mass);
    const errors = [500, 1000].map((steps) => {
      const world = new World();
      const particle = world.addParticle({ x: 0, y: 0, vx: 6, vy: -8, mass });
      world.addForce(new Drag({ k2 }));
      run(world, steps, time / steps);
      expect(particle.vy / particle.vx).toBeCloseTo(-8 / 6, 12);
      return Math.abs(Math.sqrt(particle.vx ** 2 + particle.vy ** 2) - exact);
    });
    expect(errors[0]).toBeLessThan(0.005 * exact);
    expect(errors[0] / errors[1]).toBeCloseTo(2, 1);
  });

  it.each([
    [0.1, 0, 0.2],
    [2, 0, 5],
    [0, 0.05, 0.2],
    [0, 3, 10],
    [0.3, 0.02, 1],
  ])('[F12] a fall ends at the terminal speed: k1 %d, k2 %d, mass %d', (k1, k2, mass) => {
    const g = 9.81;
    const world = new World({ gravity: { x: 0, y: -g } });
    const particle = world.addParticle({ x: 0, y: 0, mass });
    world.addForce(new Drag({ k1, k2 }));
    run(world, 60 * 300);
    // k2·v² + k1·v = m·g
    const terminal = k2 === 0 ? (mass * g) / k1 : (Math.sqrt(k1 * k1 + 4 * k2 * mass * g) - k1) / (2 * k2);
    expect(particle.vy / -terminal).toBeCloseTo(1, 10);
    if (k1 === 0) expect(terminal).toBeCloseTo(Math.sqrt((mass * g) / k2), 12);
  });

  it('[F12] a body that is faster than its terminal speed slows down to it', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const particle = world.addParticle({ x: 0, y: 0, vy: -100 });
    world.addForce(new Drag({ k1: 1 }));
    let previous = particle.vy;
    for (let i = 0; i < 600; i++) {
      world.step(1 / 60);
      expect(particle.vy >= previous && particle.vy <= -10).toBe(true);
      previous = particle.vy;
    }
    expect(particle.vy).toBeCloseTo(-10, 2);
  });

  it('[F11] acts alike on a chosen list', () => {
    const world = new World();
    const [a, b] = [0, 1].map((x) => world.addParticle({ x, y: 0, vx: 8 }));
    world.addForce(new Drag({ k1: 1 }), [b]);
    world.step(0.25);
    expect([a.vx, b.vx]).toEqual([8, 6]);
  });
});

describe('forEachParticle', () => {
  it('[F6] calls its function with each target and the duration', () => {
    const world = new World();
    const [a, , c] = [0, 1, 2].map((x) => world.addParticle({ x, y: 0 }));
    const calls: [Particle, number][] = [];
    world.addForce(
      forEachParticle((particle, dt) => void calls.push([particle, dt])),
      [c, a],
    );
    world.step(0.5);
    expect(calls.map(([particle]) => particle)).toEqual([c, a]);
    expect(calls.map(([, dt]) => dt)).toEqual([0.5, 0.5]);
  });

  it('[F6] the same force per particle and over the arrays gives the same bits', () => {
    const results = [0, 1].map((way) => {
      const world = new World({ gravity: { x: 0, y: -10 } });
      const particles = [1, 2, 3].map((mass) => world.addParticle({ x: mass, y: 0, vx: mass, mass }));
      if (way === 0) {
        world.addForce(forEachParticle((p) => p.applyForce(-0.3 * p.vx, -0.3 * p.vy)));
      } else {
        world.addForce({
          apply({ vx, vy, fx, fy }, { slots, count }) {
            for (let t = 0; t < count; t++) {
              fx[slots[t]] += -0.3 * vx[slots[t]];
              fy[slots[t]] += -0.3 * vy[slots[t]];
            }
          },
        });
      }
      run(world, 100);
      return particles.map(({ x, y, vx, vy }) => [x, y, vx, vy]);
    });
    expect(results[0]).toEqual(results[1]);
  });
});
