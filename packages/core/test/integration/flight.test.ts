import { explicitEuler, Gravity, type Integrator, semiImplicitEuler, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../helpers.ts';

const integrators: [string, Integrator][] = [
  ['semi-implicit', semiImplicitEuler],
  ['explicit', explicitEuler],
];

/** Flight under gravity g with the share d of the velocity kept per second: dv/dt = g + λ·v, λ = ln d. */
function flight(v0: number, g: number, d: number, t: number): { position: number; velocity: number } {
  if (d === 1) return { position: v0 * t + (g * t * t) / 2, velocity: v0 + g * t };
  const lambda = Math.log(d);
  const grown = Math.expm1(lambda * t);
  return {
    position: ((v0 + g / lambda) * grown) / lambda - (g * t) / lambda,
    velocity: (v0 + g / lambda) * (grown + 1) - g / lambda,
  };
}

/** The scene of the four projectiles of the thesis, 20 pixels to the metre. */
const projectiles: [string, number, number, number, number][] = [
  ['pistol', 17.5, 0, -0.5, 0.99],
  ['artillery', 20, 15, -10, 0.99],
  ['fireball', 12.5, 0, 1.5, 0.9],
  ['laser', 50, 0, 0, 0.99],
  ['a heavily damped shot', 30, 40, -9.81, 0.1],
  ['an undamped shot', 5, 12, -9.81, 1],
];

describe.each(integrators)('projectile motion, %s', (_name, integrator) => {
  it.each(projectiles.slice(0, 4))('[I3] %s: within 1 %% of the distance flown, at 60 steps a second', (...shot) => {
    const [, vx, vy, ay, damping] = shot;
    const world = new World({ integrator });
    const particle = world.addParticle({ x: 0, y: 0, vx, vy, ay, damping });
    let flown = 0;
    let before = { x: 0, y: 0 };
    for (let i = 1; i <= 300; i++) {
      world.step(1 / 60);
      const exact = {
        x: flight(vx, 0, damping, i / 60).position,
        y: flight(vy, ay, damping, i / 60).position,
      };
      flown += Math.hypot(exact.x - before.x, exact.y - before.y);
      before = exact;
      expect(Math.hypot(particle.x - exact.x, particle.y - exact.y)).toBeLessThan(0.01 * flown);
    }
  });

  it.each(projectiles)('[I4] %s: half the step, half the error', (_kind, vx, vy, ay, damping) => {
    const errors = [64, 128, 256].map((steps) => {
      const world = new World({ integrator });
      const shot = world.addParticle({ x: 0, y: 0, vx, vy, ay, damping });
      run(world, steps, 2 / steps);
      const x = flight(vx, 0, damping, 2).position;
      const y = flight(vy, ay, damping, 2).position;
      return Math.hypot(shot.x - x, shot.y - y);
    });
    for (const [coarse, fine] of [errors.slice(0, 2), errors.slice(1)]) {
      expect(coarse).toBeGreaterThan(1e-6);
      expect(Math.log2(coarse / fine)).toBeGreaterThan(0.97);
      expect(Math.log2(coarse / fine)).toBeLessThan(1.03);
    }
  });
});

describe('the formulas, step by step', () => {
  it('[I1] semi-implicit: v = (v + a·dt)·d^dt, then p = p + v·dt', () => {
    const world = new World({ gravity: { x: 0, y: -8 } });
    const particle = world.addParticle({ x: 1, y: 2, vx: 4, vy: 6, ax: 2, mass: 2, damping: 0.25 });
    particle.applyForce(0, 8);
    world.step(0.5); // a = (2, -8 + 4); d^dt = 1/2
    expect([particle.vx, particle.vy]).toEqual([2.5, 2]);
    expect([particle.x, particle.y]).toEqual([2.25, 3]);
  });

  it('[I2] explicit, the order of the thesis: p = p + v·dt with the old velocity, then v = (v + a·dt)·d^dt', () => {
    const world = new World({ gravity: { x: 0, y: -8 }, integrator: explicitEuler });
    const particle = world.addParticle({ x: 1, y: 2, vx: 4, vy: 6, ax: 2, mass: 2, damping: 0.25 });
    particle.applyForce(0, 8);
    world.step(0.5);
    expect([particle.x, particle.y]).toEqual([3, 5]);
    expect([particle.vx, particle.vy]).toEqual([2.5, 2]);
  });

  it('[I1] semi-implicit is the default', () => {
    const [a, b] = [new World(), new World({ integrator: semiImplicitEuler })].map((world) => {
      const particle = world.addParticle({ x: 0, y: 0, ax: 1, damping: 0.7 });
      run(world, 50);
      return particle.x;
    });
    expect(a).toBe(b);
  });
});

describe('damping', () => {
  it('[I5] 0 stops the particle at once, whatever drives it', () => {
    for (const [, integrator] of integrators) {
      const world = new World({ gravity: { x: 0, y: -10 }, integrator });
      const particle = world.addParticle({ x: 0, y: 0, vx: 9, vy: 9, damping: 0 });
      world.step(0.1);
      expect([particle.vx, particle.vy]).toEqual([0, 0]);
      const { x, y } = particle;
      run(world, 10, 0.1);
      expect([particle.x, particle.y]).toEqual([x, y]);
    }
  });

  it('[I5] 1 keeps everything', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, vx: 0.1, vy: -0.3 });
    run(world, 100_000);
    expect([particle.vx, particle.vy]).toEqual([0.1, -0.3]);
  });

  it('[I5] keeps the same share a second, however a second is cut', () => {
    for (const steps of [1, 7, 60, 1000]) {
      const world = new World();
      const particle = world.addParticle({ x: 0, y: 0, vx: 8, damping: 0.3 });
      run(world, steps, 1 / steps);
      expect(particle.vx).toBeCloseTo(2.4, 12);
    }
  });

  it('[I5] 0 with a step of 0 keeps the velocity: 0 to the power 0 is 1', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, vx: 8, damping: 0 });
    world.step(0);
    expect(particle.vx).toBe(8);
  });

  it('[I5] of many kinds side by side acts on each alone', () => {
    const world = new World();
    const dampings = [1, 0.5, 0.5, 0, 0.25, 0.25, 1, 0.5, 0];
    const particles = dampings.map((damping) => world.addParticle({ x: 0, y: 0, vx: 8, vy: -4, damping }));
    world.addParticle({ x: 0, y: 0, mass: Infinity, vx: 3, damping: 0.5 });
    world.step(2);
    particles.forEach(({ vx, vy }, i) => {
      expect(vx).toBeCloseTo(8 * dampings[i] ** 2, 14);
      expect(vy).toBeCloseTo(-4 * dampings[i] ** 2, 14);
    });
    expect(world.particles.vx[9]).toBe(3);
  });

  it('[I5] can change at any time, as can the step, the particle of a slot, and how many there are', () => {
    const world = new World();
    const other = world.addParticle({ x: 0, y: 0, vx: 8, damping: 0.125 });
    const particle = world.addParticle({ x: 0, y: 0, vx: 8, damping: 0.25 });
    const keptBy = (dt: number) => {
      const before = particle.vx;
      world.step(dt);
      return particle.vx / before;
    };
    expect([keptBy(0.5), keptBy(0.5), keptBy(1), keptBy(0.5)]).toEqual([0.5, 0.5, 0.25, 0.5]);
    particle.damping = 0.0625;
    expect([keptBy(0.5), keptBy(0.25)]).toEqual([0.25, 0.5]);
    other.remove();
    const next = world.addParticle({ x: 0, y: 0, vx: 8, damping: 0.5 });
    for (let i = 0; i < 500; i++) world.addParticle({ x: 0, y: 0, damping: 0.9 });
    world.step(2);
    expect(next.vx).toBe(2);
  });

  it('[I9] motion that decays ends at 0, not in subnormal numbers', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, vx: 10, vy: -10, damping: 0.01 });
    for (let i = 0; i < 1000; i++) {
      world.step(1);
      for (const v of [particle.vx, particle.vy]) expect(v === 0 || Math.abs(v) > 1e-217).toBe(true);
    }
    expect([particle.vx, particle.vy]).toEqual([0, 0]);
  });
});

describe('three ways to fall', () => {
  const g = { x: 1.5, y: -9.81 };
  const masses = [0.3, 1, 7];

  function fall(way: 'world' | 'acceleration' | 'generator', damping: number, integrator: Integrator): number[][] {
    const world = new World({ integrator, ...(way === 'world' && { gravity: g }) });
    const particles = masses.map((mass) =>
      world.addParticle({
        x: 0,
        y: 0,
        vx: 3,
        mass,
        damping,
        ...(way === 'acceleration' && { ax: g.x, ay: g.y }),
      }),
    );
    if (way === 'generator') world.addForce(new Gravity(g));
    run(world, 300);
    return particles.map(({ x, y, vx, vy }) => [x, y, vx, vy]);
  }

  it.each([1, 0.8])('[I8] gravity of the world, constant acceleration and generator agree (damping %d)', (damping) => {
    for (const [, integrator] of integrators) {
      const byWorld = fall('world', damping, integrator);
      expect(fall('acceleration', damping, integrator)).toEqual(byWorld);
      const byForce = fall('generator', damping, integrator);
      byWorld.forEach((numbers, i) => {
        numbers.forEach((value, j) => {
          expect(Math.abs(byForce[i][j] - value)).toBeLessThan(Math.abs(value) * 1e-12);
        });
      });
    }
  });

  it('[I8] they add up', () => {
    const world = new World({ gravity: { x: 0, y: -1 } });
    const particle = world.addParticle({ x: 0, y: 0, ay: -2 });
    world.addForce(new Gravity({ x: 0, y: -4 }));
    world.step(1);
    expect(particle.vy).toBe(-7);
  });

  it('[I8] looking at the accelerations and dampings changes no bit', () => {
    const results = [false, true].map((look) => {
      const world = new World({ gravity: g });
      const particle = world.addParticle({ x: 0.1, y: 0.2, vx: 0.3, vy: -0.7, mass: 3 });
      particle.applyForce(0.1, 0.7);
      if (look) expect([world.particles.ax[0], world.particles.ay[0], world.particles.damping[0]]).toEqual([0, 0, 1]);
      run(world, 1000);
      return [particle.x, particle.y, particle.vx, particle.vy];
    });
    expect(results[0]).toEqual(results[1]);
  });
});
