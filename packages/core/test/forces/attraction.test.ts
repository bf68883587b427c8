import { Attraction, type Particle, Random, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { forceOn, garbagePerStep, momentum, period, run } from './measure.ts';

describe('attraction', () => {
  it('[F40] pulls two masses together with G·m₁·m₂ / r², each as much as the other', () => {
    const world = new World();
    const a = world.addParticle({ x: 1, y: 2, mass: 3 });
    const b = world.addParticle({ x: 1 + 6, y: 2 + 8, mass: 5 });
    world.addForce(new Attraction({ G: 20 }), [a, b]);
    const force = forceOn(world, a); // 20·3·5 / 100
    expect(force.x).toBeCloseTo(3 * 0.6, 9);
    expect(force.y).toBeCloseTo(3 * 0.8, 9);
    expect(5 * b.vx).toBeCloseTo(-3 * a.vx, 20);
  });

  it('[F40] repels with a negative constant, and has that of nature by default', () => {
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0 });
    const b = world.addParticle({ x: 1, y: 0 });
    world.addForce(new Attraction({ G: -2 }), [a, b]);
    expect(forceOn(world, a).x).toBeCloseTo(-2, 9);
    expect(new Attraction().G).toBe(6.6743e-11);
  });

  it('[F40] keeps momentum to 1e-12 among many', () => {
    const world = new World();
    const random = new Random(3);
    const stars = Array.from({ length: 40 }, () =>
      world.addParticle({
        x: random.between(-5, 5),
        y: random.between(-5, 5),
        vx: random.between(-1, 1),
        mass: random.between(0.1, 5),
      }),
    );
    world.addForce(new Attraction({ G: 1, softening: 0.2 }));
    const before = momentum(stars);
    run(world, 5, 1 / 240);
    const after = momentum(stars);
    expect(Math.abs(after.x - before.x)).toBeLessThan(1e-12);
    expect(Math.abs(after.y - before.y)).toBeLessThan(1e-12);
  });

  /** A planet on an ellipse with half the long axis 1 around a fixed sun, G·M = 1: period 2π, energy -1/2. */
  function orbit(eccentricity: number): [World, Particle, () => number] {
    const world = new World();
    const vy = Math.sqrt((1 - eccentricity) / (1 + eccentricity));
    const planet = world.addParticle({ x: 1 + eccentricity, y: 0, vy, mass: 0.01 });
    world.addForce(new Attraction({ G: 0.5, to: [{ x: 0, y: 0, mass: 2 }] }), [planet]);
    const energy = () =>
      (planet.vx * planet.vx + planet.vy * planet.vy) / 2 - 1 / Math.sqrt(planet.x * planet.x + planet.y * planet.y);
    return [world, planet, energy];
  }

  it.each([0, 0.3, 0.6])(
    "[F41] a planet's orbit closes after Kepler's 2π √(a³ / GM): eccentricity %d",
    (eccentricity) => {
      const [world, planet] = orbit(eccentricity);
      expect(period(world, 1 / 240, 5, () => planet.y) / (2 * Math.PI)).toBeCloseTo(1, 3);
    },
  );

  it("[F41] a planet's energy stays within a bound over 50 orbits", () => {
    const [world, , energy] = orbit(0.3);
    const start = energy();
    let worst = 0;
    run(world, 100 * Math.PI, 1 / 240, () => {
      worst = Math.max(worst, Math.abs(energy() / start - 1));
    });
    expect(worst).toBeLessThan(0.01);
  });

  it('[F41] two stars circle their common centre with the sum of their masses in the period', () => {
    const world = new World();
    const a = world.addParticle({ x: -0.25, y: 0, vy: -0.5, mass: 3 });
    const b = world.addParticle({ x: 0.75, y: 0, vy: 1.5, mass: 1 });
    world.addForce(new Attraction({ G: 1 }), [a, b]); // relative speed 2 = √(G·4 / 1)
    expect(period(world, 1 / 960, 5, () => b.y) / Math.PI).toBeCloseTo(1, 3);
    expect(Math.abs(a.x * 3 + b.x)).toBeLessThan(1e-12);
  });

  it('[F42] the softened force is G·m₁·m₂·r / (r² + ε²)^(3/2)', () => {
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0, mass: 2 });
    const b = world.addParticle({ x: 3, y: 0, mass: 5 });
    world.addForce(new Attraction({ G: 7, softening: 4 }), [a, b]);
    expect(forceOn(world, a).x).toBeCloseTo((7 * 2 * 5 * 3) / 125, 9);
  });

  it.each([0, 0.1])('[F42] coincident particles feel no force: softening %d', (softening) => {
    const world = new World();
    const at = [0, 1e-150].map((x) => world.addParticle({ x, y: 0 }));
    world.addForce(new Attraction({ G: 1, softening, to: [{ x: 0, y: 0, mass: 1 }] }));
    world.addForce(new Attraction({ G: 1, softening }));
    run(world, 0.1, 1 / 60);
    expect(Math.abs(at[0].x) + Math.abs(at[1].x) + Math.abs(at[0].y)).toBeLessThan(1e-100);
  });

  it('[F43] an infinite mass neither attracts nor is attracted', () => {
    const world = new World();
    const pin = world.addParticle({ x: 0, y: 0, mass: Infinity });
    const a = world.addParticle({ x: 1, y: 0 });
    world.addForce(new Attraction({ G: 1 }));
    run(world, 1, 1 / 60);
    expect([pin.x, pin.vx, a.x, a.vx]).toEqual([0, 0, 1, 0]);
  });

  it('[F43] with fixed points particles do not attract one another, and the points are copies', () => {
    const world = new World();
    const sun = { x: 0, y: 0, mass: 4 };
    const a = world.addParticle({ x: 1, y: 0 });
    const b = world.addParticle({ x: 1, y: 0.5 });
    const pull = world.addForce(new Attraction({ G: 1, to: [sun, { x: 2, y: 0, mass: 4 }] }), [a, b]);
    sun.x = 99;
    expect(forceOn(world, a)).toEqual({ x: 0, y: 0 });
    expect(pull.to[0]).toEqual({ x: 0, y: 0, mass: 4 });
  });

  it('[F43] a particle that was removed attracts no more', () => {
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0 });
    const b = world.addParticle({ x: 1, y: 0 });
    world.addForce(new Attraction({ G: 1 }), [a, b]);
    b.remove();
    world.addParticle({ x: 1, y: 0 });
    world.step(1 / 60);
    expect(a.vx).toBe(0);
  });

  it.each([
    [{ G: NaN }, 'G must be a finite number'],
    [{ softening: -1 }, 'softening must be a finite number of metres, 0 or more'],
    [{ to: 3 }, 'to must be a list of fixed points'],
    [{ to: [{ x: 0, y: NaN, mass: 1 }] }, 'a point of to.y must be a finite number'],
    [{ to: [{ x: 0, y: 0, mass: 0 }] }, 'the mass of a point must be a positive, finite number of kilograms'],
    [{ to: [new World().addParticle({ x: 0, y: 0 })] }, 'to must be fixed points { x, y, mass }; got a particle'],
  ])('[F44] refuses %o', (options, message) => {
    expect(() => new Attraction(options as object)).toThrow(`Attraction: ${message}`);
  });

  it('[F45] a step leaves no garbage', () => {
    const world = new World();
    for (let i = 0; i < 40; i++) world.addParticle({ x: i % 7, y: i / 7 });
    world.addForce(new Attraction({ G: 1, softening: 0.5 }));
    world.addForce(new Attraction({ G: 1, softening: 0.5, to: [{ x: 0, y: 0, mass: 1 }] }));
    expect(garbagePerStep(world)).toBeLessThan(250);
  });
});
