import { FixedTimestep, Random, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { thrownBy } from '../helpers.ts';

const nothing = () => {};

describe('FixedTimestep', () => {
  it('[T1] takes steps of 1/60 s, 5 a call at most, unless told otherwise', () => {
    const clock = new FixedTimestep();
    expect([clock.step, clock.maxSteps, clock.alpha, clock.dropped]).toEqual([1 / 60, 5, 0, 0]);
    const durations: number[] = [];
    new FixedTimestep({ step: 0.25, maxSteps: 9 }).advance(0.8, (dt) => void durations.push(dt));
    expect(durations).toEqual([0.25, 0.25, 0.25]);
  });

  it('[T2] takes as many whole steps as the time asks for, and keeps the rest for the next call', () => {
    const clock = new FixedTimestep({ step: 0.25 });
    const taken = [0.125, 0.25, 0.375, 0.5, 0, 0.25].map((elapsed) => clock.advance(elapsed, nothing));
    expect(taken).toEqual([0, 1, 2, 2, 0, 1]);
    expect(clock.alpha).toBe(0);
  });

  it('[T3] alpha is the share of a step that is left over', () => {
    const clock = new FixedTimestep({ step: 0.25 });
    clock.advance(0.0625, nothing);
    expect(clock.alpha).toBe(0.25);
    clock.advance(0.3125, nothing);
    expect(clock.alpha).toBe(0.5);
  });

  it('[T3] alpha stays from 0 to below 1, whatever the frames', () => {
    const random = new Random(12);
    for (const maxSteps of [1, 2, 5]) {
      const clock = new FixedTimestep({ maxSteps });
      for (let i = 0; i < 20_000; i++) {
        clock.advance(random.next() < 0.01 ? random.between(0, 2) : random.between(0, 0.05), nothing);
        expect(clock.alpha >= 0 && clock.alpha < 1).toBe(true);
      }
    }
  });

  it('[T4] a slow frame takes no more than maxSteps; what is beyond is dropped, in whole steps, and counted', () => {
    const clock = new FixedTimestep({ step: 0.25, maxSteps: 3 });
    expect(clock.advance(2.125, nothing)).toBe(3);
    expect([clock.dropped, clock.alpha]).toEqual([1.25, 0.5]);
    expect(clock.advance(0.125, nothing)).toBe(1);
    expect(clock.advance(1e6, nothing)).toBe(3);
    expect(clock.dropped).toBe(1.25 + 1e6 - 0.75);
  });

  it('[T4] all time is stepped over, dropped or left over', () => {
    const random = new Random(77);
    const clock = new FixedTimestep({ maxSteps: 3 });
    let total = 0;
    let steps = 0;
    for (let i = 0; i < 10_000; i++) {
      const elapsed = random.between(0, 0.1);
      total += elapsed;
      steps += clock.advance(elapsed, nothing);
      expect(Math.abs(steps * clock.step + clock.dropped + clock.alpha * clock.step - total)).toBeLessThan(1e-7);
    }
    expect(clock.dropped).toBeGreaterThan(1);
  });

  it('[T5] a step that throws does not count, and is taken again', () => {
    const clock = new FixedTimestep({ step: 0.25 });
    let taken = 0;
    const failing = () => {
      if (taken === 2) throw new Error('no');
      taken++;
    };
    expect(thrownBy(() => clock.advance(1, failing)).message).toBe('no');
    expect(taken).toBe(2);
    expect(clock.alpha).toBe(1);
    taken = 10;
    expect(clock.advance(0, failing)).toBe(2);
    expect([taken, clock.alpha]).toEqual([12, 0]);
  });

  it('[T5] while steps throw alpha does not run away', () => {
    const clock = new FixedTimestep();
    for (let i = 0; i < 100; i++) {
      thrownBy(() =>
        clock.advance(0.05, () => {
          throw new Error('no');
        }),
      );
      expect(clock.alpha).toBe(1);
    }
    expect(clock.advance(0, nothing)).toBe(5);
    expect(clock.alpha < 1).toBe(true);
    expect(clock.dropped).toBeCloseTo(5 - 5 / 60, 1);
  });

  it('[T6] a frame that misses a step by rounding alone gets it', () => {
    for (const parts of [3, 7, 49, 144, 999]) {
      const clock = new FixedTimestep();
      let steps = 0;
      for (let i = 0; i < parts; i++) steps += clock.advance(clock.step / parts, nothing);
      expect(steps).toBe(1);
    }
  });

  it.each([1 / 60, 1 / 60 - 1e-9, 1 / 60 + 1e-9, 1 / 144, 1 / 50, 0.0166, 1 / 30, 1 / 59.94])(
    '[T6] a million frames of %d s make the steps that the time asks for',
    (elapsed) => {
      const clock = new FixedTimestep();
      let steps = 0;
      let greatest = 0;
      let alphaOutside = 0;
      for (let i = 0; i < 1_000_000; i++) {
        const taken = clock.advance(elapsed, nothing);
        steps += taken;
        greatest = Math.max(greatest, taken);
        if (!(clock.alpha >= 0 && clock.alpha < 1)) alphaOutside++;
      }
      const exact = (1_000_000 * elapsed) / clock.step;
      expect(Math.abs(steps + clock.alpha - exact)).toBeLessThan(1e-5);
      expect(greatest).toBeLessThanOrEqual(Math.ceil(elapsed / clock.step));
      expect([alphaOutside, clock.dropped]).toEqual([0, 0]);
    },
  );

  it('[T7] reset forgets the rest', () => {
    const clock = new FixedTimestep({ step: 0.25 });
    clock.advance(0.2, nothing);
    clock.reset();
    expect(clock.alpha).toBe(0);
    expect(clock.advance(0.2, nothing)).toBe(0);
  });

  it('[T2] frames of any length give the same bits as equal steps', () => {
    const make = () => {
      const world = new World({ gravity: { x: 0, y: -9.81 } });
      world.addParticle({ x: 0, y: 0, vx: 3, vy: 8, damping: 0.8 });
      return world;
    };
    const random = new Random(5);
    const clock = new FixedTimestep({ maxSteps: 1000 });
    const world = make();
    while (world.stepCount < 500) clock.advance(random.between(0, 0.2), (dt) => world.step(dt));
    const reference = make();
    while (reference.stepCount < world.stepCount) reference.step(1 / 60);
    expect(Array.from(world.particles.x)).toEqual(Array.from(reference.particles.x));
    expect(Array.from(world.particles.y)).toEqual(Array.from(reference.particles.y));
  });
});
