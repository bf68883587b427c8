import { bungee, explicitEuler, type Particle, Random, type Spring, Springs, spring, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { forceOn, garbagePerStep, momentum, period, run } from './measure.ts';

function pair(distance: number, options: object = {}): [World, Particle, Particle] {
  const world = new World();
  return [world, world.addParticle({ x: 0, y: 0, ...options }), world.addParticle({ x: distance, y: 0 })];
}

describe('the law of a spring', () => {
  it('[F20] pulls its ends together when stretched, pushes them apart when compressed, and leaves them alone at rest', () => {
    for (const [distance, pull] of [
      [3, 20],
      [2, 0],
      [1.5, -10],
    ]) {
      const [world, a, b] = pair(distance);
      const coil = world.addForce(spring(a, b, { stiffness: 20, restLength: 2 }));
      expect(coil.force).toBe(pull);
      expect(forceOn(world, a).x).toBeCloseTo(pull, 9);
      const [again, , c] = pair(distance);
      again.addForce(spring({ x: 0, y: 0 }, c, { stiffness: 20, restLength: 2 }));
      expect(forceOn(again, c).x).toBeCloseTo(-pull, 9);
      expect([a.y, b.y, c.y]).toEqual([0, 0, 0]);
    }
  });

  it('[F20] damping acts along the spring alone, against growing longer and against growing shorter', () => {
    for (const [vx, force] of [
      [2, -6],
      [-2, 6],
    ]) {
      const world = new World();
      const bob = world.addParticle({ x: 1, y: 0, vx, vy: 5 });
      const coil = world.addForce(spring({ x: 0, y: 0 }, bob, { stiffness: 10, damping: 3 }));
      expect(coil.force).toBe(-force);
      const felt = forceOn(world, bob);
      expect(felt.x).toBeCloseTo(force, 8);
      expect(felt.y).toBeCloseTo(0, 8);
    }
  });

  it('[F20] acts in any direction as along an axis', () => {
    const world = new World();
    const bob = world.addParticle({ x: 1 + 3, y: 2 + 4, mass: 2 });
    world.addForce(spring(bob, { x: 1, y: 2 }, { stiffness: 10, restLength: 4 }));
    const force = forceOn(world, bob);
    expect(force.x).toBeCloseTo(-6, 9);
    expect(force.y).toBeCloseTo(-8, 9);
  });

  it('[F21] keeps the momentum of unequal masses to 1e-12, however many springs', () => {
    const world = new World();
    const random = new Random(5);
    const particles = Array.from({ length: 30 }, () =>
      world.addParticle({
        x: random.between(-2, 2),
        y: random.between(-2, 2),
        vx: random.between(-1, 1),
        vy: random.between(-1, 1),
        mass: random.between(0.1, 10),
      }),
    );
    const springs = world.addForce(new Springs());
    for (let i = 1; i < 30; i++) {
      springs.add(particles[i - 1], particles[i], { stiffness: 20, damping: 0.1 });
      springs.add(particles[i], particles[(i * 7) % 30 === i ? 0 : (i * 7) % 30], { stiffness: 5, restLength: 1 });
    }
    const before = momentum(particles);
    run(world, 10, 1 / 240);
    const after = momentum(particles);
    expect(Math.abs(after.x - before.x)).toBeLessThan(1e-12);
    expect(Math.abs(after.y - before.y)).toBeLessThan(1e-12);
  });

  it('[F21] leaves a pinned end and a fixed point where they are', () => {
    const [world, pin, bob] = pair(2, { mass: Infinity });
    const point = { x: 0, y: 0 };
    const springs = world.addForce(new Springs());
    springs.add(pin, bob, { stiffness: 30, restLength: 1 });
    springs.add(bob, point, { stiffness: 30, restLength: 1 });
    point.x = 50; // the spring keeps a copy
    run(world, 2, 1 / 240);
    expect([pin.x, pin.y, pin.vx, pin.vy]).toEqual([0, 0, 0, 0]);
    expect(Math.abs(bob.x)).toBeLessThan(2.01);
  });

  it('[F22] coincident ends feel no force, and nothing turns into NaN', () => {
    const [world, a, b] = pair(0);
    const coil = world.addForce(spring(a, b, { stiffness: 100, restLength: 1, damping: 2 }));
    world.addForce(spring(a, { x: 0, y: 0 }, { stiffness: 100, restLength: 1 }));
    run(world, 1, 1 / 60);
    expect([a.x, a.y, b.x, b.y]).toEqual([0, 0, 0, 0]);
    expect([coil.length, coil.force]).toEqual([0, 0]);
  });
});

describe('the motion on a spring', () => {
  const cases = [1, 5, 12, 25].flatMap((omega) => [
    { omega, dt: 1 / 240, share: 0.001 },
    { omega, dt: 1 / 60, share: 0.01 },
  ]);

  it.each(cases)(
    '[F23] one mass swings with period 2π √(m/k): ω = $omega rad/s, dt = $dt s',
    ({ omega, dt, share }) => {
      const world = new World();
      const mass = 0.7;
      const bob = world.addParticle({ x: 2.3, y: 0, mass });
      world.addForce(spring({ x: 0, y: 0 }, bob, { stiffness: mass * omega * omega, restLength: 2 }));
      const ideal = (2 * Math.PI) / omega;
      expect(Math.abs(period(world, dt, 10, () => bob.x, 2) / ideal - 1)).toBeLessThan(share);
    },
  );

  it.each(cases)(
    '[F23] two masses swing with period 2π √(μ/k): ω = $omega rad/s, dt = $dt s',
    ({ omega, dt, share }) => {
      const world = new World();
      const a = world.addParticle({ x: 0, y: 0, mass: 3 });
      const b = world.addParticle({ x: 1.3, y: 0, mass: 1.5 });
      world.addForce(spring(a, b, { stiffness: omega * omega, restLength: 1 })); // μ = 1 kg
      const ideal = (2 * Math.PI) / omega;
      expect(Math.abs(period(world, dt, 10, () => b.x - a.x, 1) / ideal - 1)).toBeLessThan(share);
    },
  );

  it('[F23] a damped swing shrinks as e^(-c·t / 2m)', () => {
    const world = new World();
    const bob = world.addParticle({ x: 1.5, y: 0, mass: 2 });
    world.addForce(spring({ x: 0, y: 0 }, bob, { stiffness: 200, restLength: 1, damping: 2 }));
    for (let swing = 0; swing < 10; swing++) {
      let greatest = 0;
      run(world, 0.63, 1 / 1000, () => {
        greatest = Math.max(greatest, Math.abs(bob.x - 1) * Math.exp(world.time / 2));
      });
      expect(greatest).toBeGreaterThan(0.495);
      expect(greatest).toBeLessThan(0.505);
    }
  });

  it('[F23] halving the step halves the error of the position', () => {
    const error = (dt: number) => {
      const world = new World();
      const bob = world.addParticle({ x: 1.5, y: 0 });
      world.addForce(spring({ x: 0, y: 0 }, bob, { stiffness: 25, restLength: 1 }));
      run(world, 1, dt);
      return Math.abs(bob.x - 1 - Math.cos(5) / 2);
    };
    expect(error(1 / 500) / error(1 / 1000)).toBeCloseTo(2, 1);
  });

  const energyAfter = (integrator?: typeof explicitEuler) => {
    const world = new World(integrator ? { integrator } : {});
    const bob = world.addParticle({ x: 1.01, y: 0 });
    const coil = world.addForce(spring({ x: 0, y: 0 }, bob, { stiffness: 100, restLength: 1 }));
    const start = coil.energy;
    let greatest = 0;
    run(world, 10, 1 / 240, () => {
      greatest = Math.max(greatest, (coil.energy + (bob.vx * bob.vx) / 2) / start);
    });
    return { greatest, last: (coil.energy + (bob.vx * bob.vx) / 2) / start };
  };

  it('[F24] energy stays within ω·dt / 2 = 2.1 % under the semi-implicit integrator', () => {
    expect(energyAfter().greatest).toBeLessThan(1.022);
    expect(energyAfter().last).toBeGreaterThan(0.978);
  });

  it('[F24] energy grows by 1 + ω²·dt² a step under the explicit one', () => {
    const growth = (1 + (10 / 240) ** 2) ** 2400;
    expect(energyAfter(explicitEuler).last / growth).toBeCloseTo(1, 1);
  });
});

describe('a bungee', () => {
  it('[F26] pulls when longer than at rest, and is slack otherwise', () => {
    for (const [distance, pull, energy] of [
      [3, 20, 10],
      [2, 0, 0],
      [1, 0, 0],
    ]) {
      const [world, a, b] = pair(distance);
      const cord = world.addForce(bungee(a, b, { stiffness: 20, restLength: 2 }));
      expect([cord.kind, cord.force, cord.energy]).toEqual(['bungee', pull, energy]);
      expect(forceOn(world, a).x).toBeCloseTo(pull, 9);
    }
  });

  it('[F26] does not push by its damping either', () => {
    const world = new World();
    const bob = world.addParticle({ x: 2.1, y: 0, vx: -50 });
    world.addForce(bungee({ x: 0, y: 0 }, bob, { stiffness: 20, restLength: 2, damping: 10 }));
    expect(forceOn(world, bob).x).toBe(0);
  });

  it('[F26] a jumper falls freely until the cord is taut, and is caught', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const jumper = world.addParticle({ x: 0, y: 0, mass: 70 });
    world.addForce(bungee({ x: 0, y: 0 }, jumper, { stiffness: 100, restLength: 10 }));
    run(world, 1.4, 1 / 240);
    expect(jumper.vy).toBeCloseTo(-14, 10);
    let lowest = 0;
    run(world, 6, 1 / 240, () => {
      lowest = Math.min(lowest, jumper.y);
    });
    const weight = 70 * 10; // m·g·(L + e) = k·e²/2
    const stretch = (weight + Math.sqrt(weight * weight + 2 * 100 * weight * 10)) / 100;
    expect(lowest / -(10 + stretch)).toBeCloseTo(1, 2);
  });
});

describe('the handle of a spring', () => {
  it('[F25] the rest length is the distance at the time unless given, and all numbers are there to read and to set', () => {
    const world = new World();
    const bob = world.addParticle({ x: 3, y: 4 });
    const springs = world.addForce(new Springs());
    const coil = springs.add({ x: 0, y: 0 }, bob, { stiffness: 10 });
    expect([coil.restLength, coil.stiffness, coil.damping, coil.kind]).toEqual([5, 10, 0, 'spring']);
    coil.restLength = 3;
    coil.stiffness = 20;
    coil.damping = 1;
    expect([coil.length, coil.extension, coil.force, coil.energy]).toEqual([5, 2, 40, 40]);
    expect([coil.restLength, coil.stiffness, coil.damping]).toEqual([3, 20, 1]);
    expect(coil.a).toEqual({ x: 0, y: 0 });
    expect(coil.b).toBe(bob);
    const force = forceOn(world, bob);
    expect(force.x).toBeCloseTo(-24, 8);
    expect(force.y).toBeCloseTo(-32, 8);
  });

  it('[F27] springs go with either particle, also when its slot is used again, and the others stay as they are', () => {
    const world = new World();
    const springs = world.addForce(new Springs());
    const bobs = Array.from({ length: 6 }, (_, i) => world.addParticle({ x: i + 1, y: 0 }));
    const coils = bobs.map((bob, i) => springs.add({ x: 0, y: 0 }, bob, { stiffness: 10 + i, restLength: 0 }));
    const links = bobs.slice(1).map((bob, i) => springs.add(bobs[i], bob, { stiffness: 0.1 }));
    world.step(1 / 60);
    bobs[2].remove();
    expect([coils[2].alive, links[1].alive, links[2].alive, springs.count]).toEqual([false, false, false, 8]);
    const next = world.addParticle({ x: 9, y: 9 });
    expect(next.slot).toBe(bobs[2].slot);
    world.step(1 / 60);
    expect([next.vx, next.vy]).toEqual([0, 0]);
    bobs[4].remove();
    expect(coils.map((coil) => coil.alive)).toEqual([true, true, false, true, false, true]);
    coils[0].remove();
    world.step(1 / 60);
    expect([...springs].map((coil) => coil.stiffness)).toEqual([11, 13, 15, 0.1]);
    expect(springs.count).toBe(4);
    coils[5].stiffness = 77;
    expect(coils[3].stiffness).toBe(13);
    const { vx } = bobs[0];
    world.step(1 / 60);
    expect(bobs[0].vx).toBeCloseTo(vx, 2); // only a weak link is left of its springs
  });

  it('[F27] using a spring that is gone is an error that says why', () => {
    const [world, a, b] = pair(1);
    const springs = world.addForce(new Springs());
    const removed = springs.add(a, b, { stiffness: 1 });
    removed.remove();
    expect(removed.alive).toBe(false);
    expect(() => removed.stiffness).toThrow('Spring.stiffness: the spring must still be there; it was removed.');
    expect(() => removed.remove()).toThrow('Spring.remove');
    const orphan = world.addForce(bungee(a, b, { stiffness: 1 }));
    b.remove();
    expect(() => orphan.length).toThrow(
      'Spring.length: the bungee must still be there; one of its particles was removed.',
    );
    world.step(1 / 60);
    expect([...orphan]).toEqual([]);
  });

  it('[F28] springs of a batch move things as the same springs one by one do, to the bit', () => {
    const trace = (batched: boolean) => {
      const world = new World();
      const bobs = Array.from({ length: 10 }, (_, i) => world.addParticle({ x: i * 1.1, y: (i * 7) % 3, mass: 1 + i }));
      const batch = new Springs();
      if (batched) world.addForce(batch);
      for (let i = 1; i < 10; i++) {
        const options = { stiffness: 10 * i, restLength: 1, damping: 0.1 };
        if (batched) batch.add(bobs[i - 1], bobs[i], options);
        else world.addForce(spring(bobs[i - 1], bobs[i], options));
      }
      run(world, 2, 1 / 240);
      return bobs.map(({ x, y }) => [x, y]);
    };
    expect(trace(true)).toEqual(trace(false));
  });

  it('[F28] what draws the springs of a batch draws a lone one too', () => {
    const [, a, b] = pair(1);
    const lone = spring(a, b, { stiffness: 1 });
    const drawn: Iterable<Spring> = lone;
    expect([...drawn]).toEqual([lone]);
  });

  it('[F27] names the error when an end lives in another world', () => {
    const [world, a, b] = pair(1);
    const other = new World();
    other.addForce(spring(a, b, { stiffness: 1 }));
    expect(() => other.step(1 / 60)).toThrow('one lives in another world');
    expect(() => world.step(1 / 60)).not.toThrow();
  });
});

it.each([
  ['no options', () => undefined, 'options must be an object such as'],
  ['no stiffness', () => ({}), 'stiffness must be a finite number of newtons per metre, 0 or more'],
  ['a negative stiffness', () => ({ stiffness: -1 }), 'stiffness must be a finite number'],
  ['a NaN for rest length', () => ({ stiffness: 1, restLength: NaN }), 'restLength must be a finite number of metres'],
  ['an infinite damping', () => ({ stiffness: 1, damping: Infinity }), 'damping must be a finite number'],
])('[F29] refuses %s', (_name, options, message) => {
  const [, a, b] = pair(1);
  const springs = new Springs();
  expect(() => springs.add(a, b, options() as never)).toThrow(`Springs.add: ${message}`);
  expect(() => spring(a, b, options() as never)).toThrow(`spring: ${message}`);
  expect(() => bungee(a, b, options() as never)).toThrow(`bungee: ${message}`);
  expect(springs.count).toBe(0);
});

it('[F29] refuses ends that are the same, both fixed, gone or nothing at all', () => {
  const [, a, b] = pair(1);
  const springs = new Springs();
  const add = (p: unknown, q: unknown) => () => springs.add(p as Particle, q as Particle, { stiffness: 1 });
  expect(add(a, a)).toThrow(TypeError);
  expect(add({ x: 0, y: 0 }, { x: 1, y: 0 })).toThrow('two different particles, or a particle and a fixed point');
  expect(add(a, undefined)).toThrow('b must be a particle or a fixed point { x, y }; got undefined');
  expect(add(a, { x: NaN, y: 0 })).toThrow('b.x must be a finite number of metres');
  b.remove();
  expect(add(a, b)).toThrow('b must be a particle that is in a world; it was removed');
  const coil = springs.add(a, { x: 0, y: 0 }, { stiffness: 1 });
  expect(() => {
    coil.stiffness = -1;
  }).toThrow('Spring.stiffness');
  expect(() => {
    coil.restLength = NaN;
  }).toThrow('Spring.restLength');
  expect(() => {
    coil.damping = -1;
  }).toThrow('Spring.damping');
});

it('[F30] a step with springs leaves no garbage', () => {
  const world = new World();
  const bobs = Array.from({ length: 200 }, (_, i) => world.addParticle({ x: i, y: 0 }));
  const springs = world.addForce(new Springs());
  for (let i = 1; i < 200; i++) springs.add(bobs[i - 1], bobs[i], { stiffness: 10, restLength: 0.9 });
  expect(garbagePerStep(world)).toBeLessThan(250);
});
