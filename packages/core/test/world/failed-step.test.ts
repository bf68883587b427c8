import {
  explicitEuler,
  type ForceGenerator,
  forEachParticle,
  Gravity,
  type Particle,
  semiImplicitEuler,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { failsUnchanged, Recorder, run, snapshot, thrownBy } from '../helpers.ts';

/** A world in the middle of something: a hole among the slots, lifetimes, forces that are waiting. */
function busyWorld(options: ConstructorParameters<typeof World>[0] = {}): { world: World; particles: Particle[] } {
  const world = new World({ gravity: { x: 0, y: -10 }, ...options });
  const particles = Array.from({ length: 6 }, (_, i) =>
    world.addParticle({
      x: i,
      y: 2 * i,
      vx: 1,
      ax: i,
      damping: 0.9 - i / 10,
      mass: i === 4 ? Infinity : 1 + i,
      lifetime: 9,
    }),
  );
  particles[2].remove();
  run(world, 7, 0.01);
  particles[3].applyForce(0.1, 0.2);
  return { world, particles };
}

/** What an honest run makes of the world after the step that failed: the failure must have left no trace. */
function sameAsIfNothingHadHappened(world: World, options: ConstructorParameters<typeof World>[0] = {}): void {
  world.step(0.01);
  const { world: reference } = busyWorld(options);
  reference.step(0.01);
  expect(snapshot(world)).toEqual(snapshot(reference));
}

class Broken implements ForceGenerator {
  value = NaN;

  apply({ fx }: { fx: Float64Array }, { slots }: { slots: Int32Array }): void {
    fx[slots[1]] += this.value;
  }
}

describe('a force that is not a number', () => {
  it.each([NaN, Infinity, -Infinity])(
    '[X4] of %d: the generator and the particle are named, the world is as before',
    (value) => {
      const { world } = busyWorld();
      const innocent = world.addForce(new Recorder(0));
      const broken = world.addForce(new Broken());
      broken.value = value;
      const error = failsUnchanged(world, () => world.step(0.01));
      expect(error).toBeInstanceOf(RangeError);
      expect(error.message).toBe(
        `World.step: a force must be a finite number of newtons; Broken, force 2 of the world, gave (${value}, 0) to ` +
          'particle 1. The step was undone: mend the generator, or take it out with world.removeForce.',
      );
      world.removeForce(broken);
      world.removeForce(innocent);
      sameAsIfNothingHadHappened(world);
    },
  );

  it('[X4] on a pinned particle, too', () => {
    const { world, particles } = busyWorld();
    world.addForce(new Gravity({ x: 0, y: -1 }));
    world.addForce(
      forEachParticle((p) => p.slot === 4 && world.particles.fx.fill(NaN, 4, 5)),
      [particles[4]],
    );
    expect(failsUnchanged(world, () => world.step(0.01)).message).toMatch(
      /^World\.step: .*; ForEachParticle, force 2 of the world, gave \(NaN, 0\) to particle 4\./,
    );
  });

  it('[X4] from a plain object without a class', () => {
    const { world } = busyWorld();
    const bare: ForceGenerator = Object.assign(Object.create(null), {
      apply: ({ fy }: { fy: Float64Array }) => void (fy[0] = NaN),
    });
    world.addForce(bare);
    expect(failsUnchanged(world, () => world.step(0.01)).message).toMatch(
      /an object, force 1 of the world, gave \(0, NaN\)/,
    );
  });

  it('[X4] forces that are finite each and too great together: the particle is named', () => {
    const { world } = busyWorld();
    world.addForce(new Recorder(1.7e308));
    world.addForce(new Recorder(1.7e308));
    const error = failsUnchanged(world, () => world.step(0.01));
    expect(error).toBeInstanceOf(RangeError);
    expect(error.message).toMatch(/^World\.step: positions and velocities must stay finite; particle 0 came to /);
  });

  it('[X4] the error comes every time, until the generator is mended', () => {
    const { world } = busyWorld();
    const broken = world.addForce(new Broken());
    for (let i = 0; i < 3; i++) failsUnchanged(world, () => world.step(0.01));
    broken.value = 0;
    sameAsIfNothingHadHappened(world);
  });
});

describe('a generator that throws', () => {
  it('[X4] its own error comes out, and the world is as before', () => {
    const { world, particles } = busyWorld();
    const own = new Error('my own mistake');
    world.addForce(new Recorder(5));
    const pushy = world.addForce({
      apply({ fx, vx, x }) {
        fx.fill(3);
        vx[0] = 99;
        x[1] = 99;
        particles[0].applyImpulse(1, 1);
        throw own;
      },
    });
    expect(failsUnchanged(world, () => world.step(0.01))).toBe(own);
    world.removeForce(pushy);
    const again = failsUnchanged(world, () => {
      world.addForce(pushy);
      world.step(0.01);
    });
    expect(again).toBe(own);
  });

  it('[X4] after its removal the next step works', () => {
    const { world } = busyWorld();
    const pushy = world.addForce({
      apply() {
        throw new Error('no');
      },
    });
    failsUnchanged(world, () => world.step(0.01));
    world.removeForce(pushy);
    sameAsIfNothingHadHappened(world);
  });
});

describe('within a step', () => {
  const forbidden: [string, RegExp, (world: World, particle: Particle) => void][] = [
    [
      'adds a particle',
      /^World\.addParticle: this must be called between steps; .* Note it down/,
      (w) => w.addParticle({ x: 0, y: 0 }),
    ],
    ['spawns a particle', /^World\.addParticle: this must be called between steps/, (w) => w.spawn(0, 0)],
    ['removes a particle', /^World\.removeParticle: this must be called between steps/, (w, p) => w.removeParticle(p)],
    ['removes by the handle', /^World\.removeParticle: this must be called between steps/, (_w, p) => p.remove()],
    ['adds a force', /^World\.addForce: this must be called between steps/, (w) => w.addForce(new Recorder())],
    ['removes a force', /^World\.removeForce: this must be called between steps/, (w) => w.removeForce(new Recorder())],
    ['adds an effect', /^World\.addEffect: this must be called between steps/, (w) => w.addEffect({ afterStep() {} })],
    [
      'removes an effect',
      /^World\.removeEffect: this must be called between steps/,
      (w) => w.removeEffect({ afterStep() {} }),
    ],
    ['takes a step', /^World\.step: this must be called between steps/, (w) => w.step(0.01)],
    ['takes a step of 0', /^World\.step: this must be called between steps/, (w) => w.step(0)],
  ];

  it.each(forbidden)('[X6] a force that %s fails, and the world is as before', (_what, message, act) => {
    const { world, particles } = busyWorld();
    const generator = world.addForce(
      forEachParticle((particle) => {
        particle.applyForce(1, 1);
        act(world, particles[1]);
      }),
    );
    const error = failsUnchanged(world, () => world.step(0.01));
    expect(error.message).toMatch(message);
    world.removeForce(generator);
    sameAsIfNothingHadHappened(world);
    expect(world.addParticle({ x: 0, y: 0 }).alive).toBe(true);
  });
});

describe('a number written as NaN straight to the arrays', () => {
  const names = ['x', 'y', 'vx', 'vy', 'fx', 'fy', 'ax', 'ay', 'inverseMass', 'damping'] as const;

  it.each([semiImplicitEuler, explicitEuler].flatMap((integrator) => names.map((name) => [name, integrator] as const)))(
    '[X4] %s (%o): the next step names the particle, and goes on once it is mended',
    (name, integrator) => {
      const { world } = busyWorld({ integrator });
      const kept = world.particles[name][3];
      world.particles[name][3] = NaN;
      const error = failsUnchanged(world, () => world.step(0.01));
      expect(error).toBeInstanceOf(RangeError);
      expect(error.message).toMatch(/^World\.step: positions and velocities must stay finite; particle 3 came to \(/);
      expect(error.message).toMatch(/The step was undone: look at what was written to its numbers/);
      world.particles[name][3] = kept;
      sameAsIfNothingHadHappened(world, { integrator });
    },
  );

  it('[X4] of the last particle, and of several', () => {
    const { world } = busyWorld();
    world.particles.damping[5] = NaN;
    world.particles.damping[1] = NaN;
    expect(failsUnchanged(world, () => world.step(0.01)).message).toMatch(/particle 1 came to/);
  });

  it('[X4] a mass of NaN is found by what multiplies with it', () => {
    const { world } = busyWorld();
    world.addForce(new Gravity({ x: 0, y: -1 }));
    world.particles.mass[1] = NaN;
    expect(failsUnchanged(world, () => world.step(0.01)).message).toMatch(
      /Gravity, force 1 of the world, gave \(NaN, NaN\) to particle 1/,
    );
  });
});

describe('a step that is too long', () => {
  it('[X4] for what happens in it names the particle', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const stone = world.addParticle({ x: 1, y: 2, vx: 3 });
    world.step(0.1);
    expect(failsUnchanged(world, () => world.step(1e300)).message).toMatch(
      /^World\.step: .*; particle 0 came to \(3e\+300, -Infinity\) m .* take shorter steps\.$/,
    );
    world.step(0.1);
    expect(stone.x).toBeCloseTo(1.6, 12);
  });

  it('[X4] an instable spring is stopped before it leaves the numbers', () => {
    const world = new World();
    const bob = world.addParticle({ x: 1, y: 0 });
    world.addForce({ apply: ({ x, fx }) => void (fx[0] -= 1e6 * x[0]) });
    const error = thrownBy(() => run(world, 10_000, 0.1));
    expect(error.message).toMatch(/^World\.step: /);
    expect([bob.x, bob.vx].every(Number.isFinite)).toBe(true);
  });
});

describe("a game's own integrator", () => {
  it('[X4] that throws, or says that something is not finite, leaves the world as before', () => {
    let fail = false;
    const own = new World({
      integrator(particles, gravity, dt) {
        const finite = semiImplicitEuler(particles, gravity, dt);
        return finite && !fail;
      },
    });
    own.addParticle({ x: 0, y: 0, vx: 1 });
    own.step(0.1);
    fail = true;
    expect(failsUnchanged(own, () => own.step(0.1)).message).toMatch(
      /^World\.step: positions and velocities must stay finite/,
    );
    fail = false;
    own.step(0.1);
    expect(own.particles.x[0]).toBe(0.2);
  });
});
