import { Drag, explicitEuler, forEachParticle, type Particle, Random, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { OwnSpring, randomWorld, run } from '../helpers.ts';

function momentum(particles: Particle[]): { x: number; y: number } {
  return {
    x: particles.reduce((sum, p) => sum + p.mass * p.vx, 0),
    y: particles.reduce((sum, p) => sum + p.mass * p.vy, 0),
  };
}

describe('momentum', () => {
  it('[I6] of masses that pull at each other stays, whatever the masses', () => {
    const world = new World();
    const random = new Random(4);
    const particles = Array.from({ length: 12 }, (_, i) =>
      world.addParticle({
        x: random.between(-5, 5),
        y: random.between(-5, 5),
        vx: random.between(-3, 3),
        mass: 10 ** (i % 5),
      }),
    );
    for (let i = 1; i < particles.length; i++)
      world.addForce(new OwnSpring(particles[i - 1], particles[i], random.between(1, 50), 1));
    const before = momentum(particles);
    const size = particles.reduce((sum, p) => sum + p.mass * Math.hypot(p.vx, p.vy), 0);
    run(world, 5000);
    const after = momentum(particles);
    expect(Math.abs(after.x - before.x)).toBeLessThan(1e-10 * size);
    expect(Math.abs(after.y - before.y)).toBeLessThan(1e-10 * size);
  });

  it('[I6] the lighter of two is moved more, in inverse proportion to mass; the centre of mass stays', () => {
    const world = new World();
    const light = world.addParticle({ x: 0, y: 0, mass: 1 });
    const heavy = world.addParticle({ x: 4, y: 0, mass: 3 });
    world.addForce(new OwnSpring(light, heavy, 10, 1));
    for (let i = 0; i < 1000; i++) {
      world.step(1 / 120);
      expect((light.x + 3 * heavy.x) / 4).toBeCloseTo(3, 10);
      expect(light.vx).toBeCloseTo(-3 * heavy.vx, 10);
    }
  });

  it('[I6] an impulse and its reverse leave the sum as it was', () => {
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0, mass: 3 });
    const b = world.addParticle({ x: 1, y: 0, mass: 0.5 });
    a.applyImpulse(1.25, -2);
    b.applyImpulse(-1.25, 2);
    expect(momentum([a, b])).toEqual({ x: 0, y: 0 });
  });

  it('[I6] two masses on a spring swing with the period 2π·√(μ/k)', () => {
    const [m1, m2, k] = [2, 5, 40];
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0, mass: m1 });
    const b = world.addParticle({ x: 3, y: 0, mass: m2 });
    world.addForce(new OwnSpring(a, b, k, 2));
    const dt = 1e-3;
    const crossings: number[] = [];
    let previous = 1;
    while (crossings.length < 21) {
      world.step(dt);
      const stretch = b.x - a.x - 2;
      if (previous > 0 !== stretch > 0) crossings.push(world.time - (dt * stretch) / (stretch - previous));
      previous = stretch;
    }
    const period = (crossings[20] - crossings[0]) / 10;
    expect(period).toBeCloseTo(2 * Math.PI * Math.sqrt((m1 * m2) / (m1 + m2) / k), 4);
  });
});

describe('energy of a spring', () => {
  const stiffness = 25;

  function swing(world: World): Particle {
    const bob = world.addParticle({ x: 1, y: 0 });
    world.addForce(new OwnSpring(bob, { x: 0, y: 0 }, stiffness));
    return bob;
  }

  const energy = ({ vx, x }: Particle) => (vx * vx + stiffness * x * x) / 2;

  it.each([0.01, 1 / 60, 0.1, 0.3, 0.39])('[I7] semi-implicit: bounded for ever (dt %d, ω·dt < 2)', (dt) => {
    const world = new World();
    const bob = swing(world);
    // v'² + ω²x'² - ω²·dt·x'·v' is the same after each step: the energy keeps within a factor of (1 + s)/(1 - s), s = ω·dt/2.
    const modified = () => energy(bob) - (stiffness * dt * bob.x * bob.vx) / 2;
    const start = modified();
    const s = (Math.sqrt(stiffness) * dt) / 2;
    for (let i = 0; i < 50_000; i++) {
      world.step(dt);
      if (i % 97 > 0) continue;
      expect(Math.abs(modified() / start - 1)).toBeLessThan(1e-9);
      expect(energy(bob)).toBeLessThan((start / (1 - s)) * (1 + 1e-9));
      expect(energy(bob)).toBeGreaterThan((start / (1 + s)) * (1 - 1e-9));
    }
  });

  it('[I7] explicit: grows by exactly 1 + ω²·dt² a step', () => {
    for (const dt of [0.001, 1 / 60, 0.1]) {
      const world = new World({ integrator: explicitEuler });
      const bob = swing(world);
      for (let i = 0; i < 200; i++) {
        const before = energy(bob);
        world.step(dt);
        expect(energy(bob) / before).toBeCloseTo(1 + stiffness * dt * dt, 12);
      }
    }
  });

  it('[I7] after 10 s at 60 steps a second: 1.00 times the energy, or 65 times', () => {
    const [semi, explicit] = [new World(), new World({ integrator: explicitEuler })].map((world) => {
      const bob = swing(world);
      run(world, 600);
      return energy(bob) / 12.5;
    });
    expect(semi).toBeGreaterThan(0.95);
    expect(semi).toBeLessThan(1.05);
    expect(explicit).toBeCloseTo((1 + 25 / 3600) ** 600, 6);
  });

  it('[I7] a spring of no length gives no NaN', () => {
    const world = new World();
    const bob = world.addParticle({ x: 0, y: 0 });
    world.addForce(new OwnSpring(bob, { x: 0, y: 0 }, stiffness, 1));
    run(world, 10);
    expect([bob.x, bob.y]).toEqual([0, 0]);
  });
});

describe('symmetry', () => {
  /** A busy world, as it is or seen in a mirror; minus zero counts as zero. */
  function final(sx: 1 | -1, sy: 1 | -1, swap: boolean): number[][] {
    const g = swap ? { x: -9.81, y: 0.5 } : { x: 0.5, y: -9.81 };
    const world = new World({ gravity: { x: sx * g.x, y: sy * g.y } });
    const random = new Random(31);
    const place = (x: number, y: number) => (swap ? [sx * y, sy * x] : [sx * x, sy * y]);
    const particles = Array.from({ length: 40 }, () => {
      const [x, y] = place(random.between(-9, 9), random.between(-9, 9));
      const [vx, vy] = place(random.between(-9, 9), random.between(-9, 9));
      const [ax, ay] = place(random.between(-1, 1), random.between(-1, 1));
      const damping = random.between(0.2, 1);
      return world.addParticle({ x, y, vx, vy, ax, ay, damping, mass: random.between(0.1, 5) });
    });
    world.addForce(new Drag({ k1: 0.1, k2: 0.02 }));
    for (let i = 1; i < 20; i++) world.addForce(new OwnSpring(particles[i - 1], particles[i], 20, 1));
    for (let i = 0; i < 400; i++) {
      const [ix, iy] = place(random.between(-1, 1), random.between(-1, 1));
      particles[i % 40].applyImpulse(ix, iy);
      world.step(1 / 60);
    }
    return particles.map((p) => [...place(p.x, p.y), ...place(p.vx, p.vy)].map((value) => value + 0));
  }

  it('[D2] the mirror image of a world stays its mirror image, bit for bit', () => {
    const plain = final(1, 1, false);
    expect(final(-1, 1, false)).toEqual(plain);
    expect(final(1, -1, false)).toEqual(plain);
    expect(final(-1, -1, false)).toEqual(plain);
  });

  it('[D2] x and y are treated alike, bit for bit', () => {
    expect(final(1, 1, true)).toEqual(final(1, 1, false));
  });

  it('[D2] the order in which particles were added does not matter, bit for bit', () => {
    const make = (order: number[]) => {
      const world = new World({ gravity: { x: 0, y: -9.81 } });
      const particles: Particle[] = [];
      for (const i of order) {
        particles[i] = world.addParticle({ x: i / 7, y: i / 3, vx: i, mass: 1 + i, damping: i % 2 ? 0.9 : 0.8 });
      }
      world.addForce(new Drag({ k1: 0.1, k2: 0.02 }));
      run(world, 200);
      return particles.map(({ x, y, vx, vy }) => [x, y, vx, vy]);
    };
    const order = Array.from({ length: 50 }, (_, i) => i);
    expect(make(order.toReversed())).toEqual(make(order));
  });

  it('[D2] scaling a world by a power of two scales its motion, bit for bit', () => {
    const finals = [1, 1024].map((scale) => {
      const world = new World({ gravity: { x: 0, y: -9.81 * scale } });
      const particle = world.addParticle({ x: 0.3 * scale, y: 0, vx: 1.7 * scale, vy: 3.1 * scale, damping: 0.9 });
      world.addForce(new Drag({ k1: 0.3 }));
      run(world, 300);
      return [particle.x, particle.y, particle.vx, particle.vy].map((value) => value / scale);
    });
    expect(finals[1]).toEqual(finals[0]);
  });

  it('[I6] particles without a force between them do not know of each other', () => {
    const crowd = randomWorld(300, 6, { x: 0, y: -9.81 });
    const alone = new World({ gravity: { x: 0, y: -9.81 } });
    const { x, y, vx, vy, mass } = crowd.particles;
    const twin = alone.addParticle({ x: x[123], y: y[123], vx: vx[123], vy: vy[123], mass: mass[123] });
    const drag = () => forEachParticle((p) => p.applyForce(-p.vx, -p.vy));
    crowd.addForce(drag());
    alone.addForce(drag());
    run(crowd, 200);
    run(alone, 200);
    expect(crowd.particleAt(123)).toMatchObject({ x: twin.x, y: twin.y, vx: twin.vx, vy: twin.vy });
  });
});
