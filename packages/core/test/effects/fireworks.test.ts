import {
  type FireworkRule,
  Fireworks,
  type FireworksOptions,
  type ParticleSpawner,
  type SlotList,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { failsUnchanged, hashOf, run, snapshot, thrownBy } from '../helpers.ts';

const still = { minVelocity: { x: 0, y: 0 }, maxVelocity: { x: 0, y: 0 }, damping: 1 };
/** Ends after half a second and bursts into five shells, each of which bursts into seven sparks. */
const rocket: FireworkRule = { type: 1, minAge: 0.5, maxAge: 0.5, ...still, payloads: [{ type: 2, count: 5 }] };
const shell: FireworkRule = { type: 2, minAge: 0.3, maxAge: 0.3, ...still, payloads: [{ type: 3, count: 7 }] };
const spark: FireworkRule = { type: 3, minAge: 0.2, maxAge: 0.2, ...still };

function show(options: Partial<FireworksOptions> = {}): { world: World; fireworks: Fireworks } {
  const world = new World();
  const fireworks = world.addEffect(new Fireworks({ rules: [rocket, shell, spark], ...options }));
  return { world, fireworks };
}

/** The slots of all that lives. */
function living(world: World): number[] {
  return Array.from(world.particles.alive.keys()).filter((slot) => world.particles.alive[slot] === 1);
}

describe('bursts', () => {
  it('[E1] a rocket bursts, its payloads burst again, and the sparks go out', () => {
    const { world, fireworks } = show();
    fireworks.launch(1, { x: 0, y: 5 });
    const counts: number[] = [];
    for (let i = 0; i < 11; i++) {
      world.step(0.1);
      counts.push(world.particleCount);
    }
    expect(counts).toEqual([1, 1, 1, 1, 5, 5, 5, 35, 35, 0, 0]);
    expect(fireworks.bursts).toBe(6);
  });

  it('[E1] several kinds of payload at once', () => {
    const double = {
      ...rocket,
      payloads: [
        { type: 2, count: 2 },
        { type: 3, count: 3 },
      ],
    };
    const { world, fireworks } = show({ rules: [double, shell, spark] });
    fireworks.launch(1);
    run(world, 5, 0.1);
    expect(
      living(world)
        .map((slot) => world.particles.group[slot])
        .sort(),
    ).toEqual([2, 2, 3, 3, 3]);
  });

  it('[E2] payloads start where their parent is, with its velocity and one of the range on top, a component each', () => {
    const range = { minVelocity: { x: -3, y: 2 }, maxVelocity: { x: 5, y: 4 } };
    const { world, fireworks } = show({
      rules: [
        { ...rocket, payloads: [{ type: 2, count: 2000 }] },
        { ...shell, ...range, payloads: [] },
      ],
    });
    fireworks.launch(1, { x: 1, y: 2, vx: 10, vy: -20 });
    run(world, 4, 0.125);
    const { x, y, vx, vy, previousX } = world.particles;
    const slots = living(world);
    expect(slots.length).toBe(2000);
    for (const i of slots) {
      expect([x[i], previousX[i], y[i]]).toEqual([6, 6, -8]);
      expect(vx[i] >= 7 && vx[i] <= 15).toBe(true);
      expect(vy[i] >= -18 && vy[i] <= -16).toBe(true);
    }
    // Both ends of the range are nearly reached, and the components do not depend on each other.
    expect(Math.min(...slots.map((i) => vx[i]))).toBeLessThan(7.05);
    expect(Math.max(...slots.map((i) => vx[i]))).toBeGreaterThan(14.95);
    const correlation = slots.reduce((sum, i) => sum + ((vx[i] - 11) / 8) * ((vy[i] + 17) / 2), 0);
    expect(Math.abs(correlation)).toBeLessThan((4 * Math.sqrt(2000)) / 12);
  });

  it('[E2] have the mass, radius, damping, acceleration and group of their rule', () => {
    const made = { mass: 0.5, radius: 0.25, damping: 0.75 };
    const { world, fireworks } = show({
      rules: [rocket, { ...shell, ...made, acceleration: { x: 1, y: -2 }, payloads: [] }],
    });
    fireworks.launch(1);
    const launched = world.particleAt(0);
    expect(launched).toMatchObject({ mass: 1, radius: 0, damping: 1, ax: 0, ay: 0, group: 1 });
    run(world, 5, 0.1);
    for (const slot of living(world)) {
      expect(world.particleAt(slot)).toMatchObject({ ...made, ax: 1, ay: -2, group: 2 });
      expect(world.particleAt(slot).inverseMass).toBe(2);
    }
  });

  it('[E3] ages lie in the range of the rule, and end with the step nearest to them', () => {
    const dt = 1 / 60;
    const { world, fireworks } = show({ rules: [{ ...spark, minAge: 0.5, maxAge: 1.5 }] });
    for (let i = 0; i < 1000; i++) fireworks.launch(3);
    const ages = Array.from(world.particles.lifetime.subarray(0, 1000));
    for (const age of ages) expect(age >= 0.5 && age <= 1.5).toBe(true);
    expect(Math.min(...ages)).toBeLessThan(0.51);
    expect(Math.max(...ages)).toBeGreaterThan(1.49);
    for (let step = 1; step <= 91; step++) {
      world.step(dt);
      const left = ages.filter((age) => age / dt > step + 0.5).length;
      expect(world.particleCount).toBe(left);
    }
  });

  it('[E4] with no place given they start at rest along the ground line', () => {
    const { world, fireworks } = show({ ground: { minX: 2, maxX: 6, y: -1 } });
    for (let i = 0; i < 500; i++) fireworks.launch(1);
    const { x, y, vx, vy } = world.particles;
    for (let i = 0; i < 500; i++) {
      expect(x[i] >= 2 && x[i] <= 6).toBe(true);
      expect([y[i], vx[i], vy[i]]).toEqual([-1, 0, 0]);
    }
    const xs = Array.from(x.subarray(0, 500));
    expect(Math.min(...xs)).toBeLessThan(2.1);
    expect(Math.max(...xs)).toBeGreaterThan(5.9);
  });

  it('[E4] the ground line is from -10 to 10 at height 0 unless given', () => {
    const { world, fireworks } = show();
    for (let i = 0; i < 200; i++) fireworks.launch(1);
    const xs = Array.from(world.particles.x.subarray(0, 200));
    expect(Math.min(...xs)).toBeLessThan(-9);
    expect(Math.max(...xs)).toBeGreaterThan(9);
    expect(xs.every((x) => x >= -10 && x <= 10)).toBe(true);
    expect(world.particles.y[100]).toBe(0);
  });

  it('[E5] the same seed gives the same show, another seed another', () => {
    const hashes = [5, 5, 6].map((seed) => {
      const wild = { minVelocity: { x: -9, y: -9 }, maxVelocity: { x: 9, y: 9 }, minAge: 0.1, maxAge: 0.9 };
      const { world, fireworks } = show({
        seed,
        rules: [
          { ...rocket, ...wild },
          { ...shell, ...wild },
          { ...spark, ...wild },
        ],
      });
      for (let i = 0; i < 60; i++) {
        if (i % 9 === 0) fireworks.launch(1);
        world.step(1 / 60);
      }
      return hashOf(world);
    });
    expect(hashes[0]).toBe(hashes[1]);
    expect(hashes[0]).not.toBe(hashes[2]);
  });

  it('[E6] a thousand that end with one step all burst', () => {
    const { world, fireworks } = show();
    for (let i = 0; i < 1000; i++) fireworks.launch(2);
    run(world, 3, 0.1);
    expect(fireworks.bursts).toBe(1000);
    expect(world.particleCount).toBe(7000);
    run(world, 2, 0.1);
    expect(world.particleCount).toBe(0);
  });

  it('[E6] ten thousand sparks at once, from one rocket', () => {
    const { world, fireworks } = show({ rules: [{ ...rocket, payloads: [{ type: 3, count: 10_000 }] }, spark] });
    fireworks.launch(1, { x: 0, y: 100, vx: 3 });
    run(world, 5, 0.1);
    expect([world.particleCount, fireworks.bursts]).toEqual([10_000, 1]);
    expect(world.particles.vx[9_999]).toBe(3);
    run(world, 2, 0.1);
    expect(world.particleCount).toBe(0);
  });
});

describe('what is not one of them', () => {
  it('[E7] a particle that was removed from outside does not burst, nor does what lives in its slot later', () => {
    const { world, fireworks } = show();
    fireworks.launch(1);
    world.particleAt(0).remove();
    run(world, 10, 0.1);
    expect([fireworks.bursts, world.particleCount]).toEqual([0, 0]);
    fireworks.launch(1);
    world.particleAt(0).remove();
    const other = world.addParticle({ x: 0, y: 0, lifetime: 0.5, group: 1 });
    expect(other.slot).toBe(0);
    run(world, 10, 0.1);
    expect([fireworks.bursts, world.particleCount, other.alive]).toEqual([0, 0, false]);
  });

  it('[E7] an ordinary particle with the group of a rule and a lifetime does not burst', () => {
    const { world, fireworks } = show();
    world.addParticle({ x: 0, y: 0, lifetime: 0.1, group: 1 });
    run(world, 3, 0.1);
    expect([fireworks.bursts, world.particleCount]).toEqual([0, 0]);
  });

  it('[E7] two sets of fireworks in one world do not burst each other', () => {
    const { world, fireworks } = show();
    const others = world.addEffect(new Fireworks({ rules: [{ ...rocket, payloads: [{ type: 3, count: 1 }] }, spark] }));
    fireworks.launch(1);
    others.launch(1);
    run(world, 5, 0.1);
    expect([fireworks.bursts, others.bursts, world.particleCount]).toEqual([1, 1, 6]);
  });

  it('[E7] taken to another world, they do not burst its particles', () => {
    const { world, fireworks } = show();
    fireworks.launch(1);
    world.removeEffect(fireworks);
    const second = new World();
    second.addEffect(fireworks);
    second.addParticle({ x: 0, y: 0, lifetime: 0.1, group: 1 }); // the slot and the generation of the rocket
    run(second, 3, 0.1);
    expect([fireworks.bursts, second.particleCount]).toEqual([0, 0]);
  });

  it('[E8] taken out they stop: what flies goes on, and ends without a burst', () => {
    const { world, fireworks } = show();
    fireworks.launch(1);
    world.removeEffect(fireworks);
    expect(world.particleCount).toBe(1);
    expect(() => fireworks.launch(1)).toThrow(
      /^Fireworks\.launch: the fireworks must be in a world\. Call world\.addEffect/,
    );
    run(world, 5, 0.1);
    expect([fireworks.bursts, world.particleCount]).toEqual([0, 0]);
  });
});

describe('rules', () => {
  const refuses = (rules: unknown): Error => thrownBy(() => new Fireworks({ rules: rules as FireworkRule[] }));

  it('[E9] that go round for ever are refused, and the round is shown', () => {
    expect(refuses([{ ...spark, payloads: [{ type: 3, count: 1 }] }]).message).toBe(
      'Fireworks: bursts must end; the types 3 > 3 go round for ever.',
    );
    const round = refuses([rocket, shell, { ...spark, payloads: [{ type: 1, count: 1 }] }]);
    expect(round).toBeInstanceOf(RangeError);
    expect(round.message).toBe('Fireworks: bursts must end; the types 1 > 2 > 3 > 1 go round for ever.');
  });

  it('[E9] may meet again in one type: that is no round', () => {
    const both = {
      ...rocket,
      payloads: [
        { type: 2, count: 1 },
        { type: 3, count: 1 },
      ],
    };
    expect(() => new Fireworks({ rules: [both, shell, spark] })).not.toThrow();
  });

  it('[E9] name payloads that have a rule, one rule a type', () => {
    expect(refuses([rocket]).message).toBe(
      "Fireworks: each payload's type must have a rule; type 1 bursts into 2, without one.",
    );
    expect(refuses([spark, spark]).message).toBe('Fireworks: each type has one rule; type 3 has two.');
  });

  it('[E9] are copied: changing one later changes nothing', () => {
    const minVelocity = { x: 1, y: 1 };
    const payloads = [{ type: 3, count: 2 }];
    const rule = { ...rocket, minVelocity, maxVelocity: { x: 1, y: 1 }, payloads };
    const rules = [rule, spark];
    const { world, fireworks } = show({ rules });
    minVelocity.x = 99;
    payloads[0].count = 99;
    rule.minAge = 99;
    rules.length = 0;
    fireworks.launch(1);
    expect(world.particles.vx[0]).toBe(1);
    run(world, 5, 0.1);
    expect(world.particleCount).toBe(2);
  });

  it('[E10] a launch of an unknown type names those that are known, and changes nothing', () => {
    const { world, fireworks } = show();
    const error = failsUnchanged(world, () => fireworks.launch(9));
    expect(error).toBeInstanceOf(RangeError);
    expect(error.message).toBe('Fireworks.launch: type must have a rule; got 9. Known are 1, 2, 3.');
  });

  it('[E10] a launch that fails uses up no random number', () => {
    const runs = [false, true].map((fail) => {
      const { world, fireworks } = show({ seed: 3 });
      if (fail) {
        thrownBy(() => fireworks.launch(9));
        thrownBy(() => fireworks.launch(1, { x: NaN, y: 0 }));
        thrownBy(() => fireworks.launch(1, { x: 0, y: 0, vx: Infinity }));
      }
      fireworks.launch(1);
      return snapshot(world);
    });
    expect(runs[0]).toEqual(runs[1]);
  });

  it('[E8] are in one world at a time', () => {
    const { fireworks } = show();
    const second = new World();
    expect(() => second.addEffect(fireworks)).toThrow(/^World\.addEffect: these fireworks are in a world already\./);
  });
});

describe("a game's own effect", () => {
  it('[E11] is told of its world, makes particles after each step, and can be taken out', () => {
    class Tap {
      readonly calls: string[] = [];

      attach(world: ParticleSpawner): void {
        this.calls.push(`attach ${world.particles.count}`);
      }

      detach(): void {
        this.calls.push('detach');
      }

      afterStep(world: ParticleSpawner, expired: SlotList, dt: number): void {
        const slot = world.spawn(0, 10, 0.3);
        world.particles.vy[slot] = -1;
        this.calls.push(`${dt}: ${expired.count} ended`);
      }
    }
    const world = new World();
    const tap = world.addEffect(new Tap());
    run(world, 5, 0.1);
    expect(world.particleCount).toBe(3);
    world.removeEffect(tap);
    run(world, 3, 0.1);
    expect(world.particleCount).toBe(0);
    expect(tap.calls).toEqual([
      'attach 0',
      '0.1: 0 ended',
      '0.1: 0 ended',
      '0.1: 0 ended',
      '0.1: 1 ended',
      '0.1: 1 ended',
      'detach',
    ]);
  });

  it('[E11] sees all that end with the step, in order, while they can still be read', () => {
    const world = new World();
    for (let i = 0; i < 5; i++) world.addParticle({ x: i, y: 0, lifetime: i % 2 ? 0.1 : 0.2 });
    const ended: number[][] = [];
    world.addEffect({
      afterStep({ particles }, { slots, count }) {
        ended.push(Array.from(slots.subarray(0, count), (slot) => particles.x[slot]));
      },
    });
    run(world, 3, 0.1);
    expect(ended).toEqual([[1, 3], [0, 2, 4], []]);
  });

  it('[E11] may remove what ends: it is not removed twice, and what takes its slot stays', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, lifetime: 0.1 });
    world.addParticle({ x: 0, y: 0 });
    world.addEffect({
      afterStep(spawner, { count }) {
        if (count === 0) return;
        particle.remove();
        expect(spawner.spawn(7, 7)).toBe(0);
      },
    });
    run(world, 2, 0.1);
    expect(world.particleCount).toBe(2);
    expect(world.particleAt(0).x).toBe(7);
  });

  it('[E11] that refuses its world is not in it', () => {
    const world = new World();
    let calls = 0;
    const shy = {
      attach() {
        throw new Error('not here');
      },
      afterStep: () => void calls++,
    };
    expect(() => world.addEffect(shy)).toThrow('not here');
    world.step(0.1);
    expect(calls).toBe(0);
  });
});
