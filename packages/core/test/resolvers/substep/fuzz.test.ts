import { describe, expect, it } from 'vitest';
import { judge } from '../../../fuzz/judge.ts';
import type { LoosePlan, WorldPlan } from '../../../fuzz/plan.ts';
import { randomPlan } from '../../../fuzz/random-plan.ts';
import { shrink } from '../../../fuzz/shrink.ts';

const lone: LoosePlan = { particles: [{ x: 0, y: 0, vx: 3, radius: 0.1 }], links: [], springs: [], collides: false };

/** Discs in a room of 2 m. */
function roomOf(parts: readonly LoosePlan[]): WorldPlan {
  const corners = [
    { x: -1, y: -1 },
    { x: 1, y: -1 },
    { x: 1, y: 1 },
    { x: -1, y: 1 },
  ];
  const walls = { kind: 'segments', corners, thickness: 0, restitution: 1, friction: 0, surfaceSpeed: 0 } as const;
  return {
    seed: 0,
    gravity: { x: 0, y: -9.81 },
    drag: 0,
    walls,
    obstacles: [],
    parts,
    overlaps: false,
    removal: undefined,
  };
}

describe('the fuzzer', () => {
  it('makes the same world of the same seed, and another of another', () => {
    expect(randomPlan(7)).toEqual(randomPlan(7));
    expect(randomPlan(8)).not.toEqual(randomPlan(7));
  });

  it('finds nothing wrong with a disc that hops in a room', () => {
    expect(judge(roomOf([lone]))).toBeUndefined();
  });

  it('finds what is outside, and leaves out of the world what has no part in it', () => {
    const outside: LoosePlan = { ...lone, particles: [{ x: 5, y: 0, vx: 1, radius: 0.1, friction: 0.5 }] };
    const plan = roomOf([lone, outside, lone]);
    const violation = judge(plan);
    expect(violation).toMatchObject({ kind: 'escape', step: 1 });
    if (violation === undefined) return;
    const least = shrink(plan, violation);
    expect(judge(least)?.kind).toBe('escape');
    expect(least.parts).toEqual([
      { ...outside, particles: [{ x: 5, y: 0, vx: 0, vy: 0, radius: 0.1, friction: 0, restitution: 0, damping: 1 }] },
    ]);
    expect(least.gravity).toEqual({ x: 0, y: 0 });
  });

  it('finds energy that comes from nothing', () => {
    const plan = roomOf([lone]);
    const stretched = { ...lone, particles: [lone.particles[0], { x: 0.5, y: 0, radius: 0.1 }] };
    const spring = { a: 0, b: 1, stiffness: 1e5, restLength: 0.1 }; // far stiffer than a step can follow
    expect(judge({ ...plan, parts: [{ ...stretched, springs: [spring] }] })?.kind).toBe('energy');
  });
});

describe('random worlds', () => {
  it.each([0, 100, 200, 300])(
    '[S24] stay finite and inside, and gain no more than a twentieth in energy: 100 from world %s',
    (from) => {
      for (let seed = from; seed < from + 100; seed++)
        expect([seed, judge(randomPlan(seed))]).toEqual([seed, undefined]);
    },
  );
});
