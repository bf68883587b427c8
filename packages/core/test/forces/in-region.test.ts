import {
  type ForceGenerator,
  forEachParticle,
  inRegion,
  insideBox,
  insideDisc,
  insideHalfPlane,
  Wind,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { garbagePerStep, run } from './measure.ts';

/** A newton to the right. */
const push: ForceGenerator = {
  apply({ fx }, { slots, count }) {
    for (let t = 0; t < count; t++) fx[slots[t]] += 1;
  },
};

/** Which of some points a region takes in. */
function pushed(region: Parameters<typeof inRegion>[1], points: [number, number][]): boolean[] {
  const world = new World();
  const particles = points.map(([x, y]) => world.addParticle({ x, y }));
  world.addForce(inRegion(push, region));
  world.step(1);
  return particles.map(({ vx }) => vx === 1);
}

describe('a force in a region', () => {
  it('[F60] a box takes in its edges, and is infinite where an edge is left out', () => {
    const points: [number, number][] = [[0, 0], [2, 1], [1, 0.5], [-0.01, 0.5], [1, 1.01], [2.01, 0], [1, -9]]; // biome-ignore format: a table
    const box = insideBox({ minX: 0, minY: 0, maxX: 2, maxY: 1 });
    expect(pushed(box, points)).toEqual([true, true, true, false, false, false, false]);
    expect(pushed(insideBox({ minX: 0 }), points)).toEqual([true, true, true, false, true, true, true]);
  });

  it('[F60] a disc takes in its edge', () => {
    const disc = insideDisc({ x: 1, y: 1, radius: 5 });
    expect(pushed(disc, [[1, 1], [4, 5], [4.01, 5], [-4, 1], [1, 6.01]])).toEqual([true, true, false, true, false]); // biome-ignore format: a table
  });

  it('[F60] a half-plane lies where its normal points, its line included', () => {
    const below = insideHalfPlane({ x: 5, y: 1 }, { x: 0, y: -3 });
    expect(pushed(below, [[0, 0], [9, 1], [9, 1.01]])).toEqual([true, true, false]); // biome-ignore format: a table
  });

  it('[F60] a function of one slot may choose by anything', () => {
    const world = new World();
    const heavy = world.addParticle({ x: 0, y: 0, mass: 5 });
    const light = world.addParticle({ x: 0, y: 0 });
    world.addForce(inRegion(push, ({ mass }, slot) => mass[slot] > 2));
    world.step(1);
    expect([heavy.vx, light.vx]).toEqual([0.2, 0]);
  });

  it('[F61] acts while a particle is inside, and on the targets alone', () => {
    const world = new World();
    const runner = world.addParticle({ x: -1, y: 0, vx: 1 });
    const other = world.addParticle({ x: 0.5, y: 0 });
    const lift = new Wind({ velocity: { x: 1, y: 1 }, k1: 1 });
    world.addForce(inRegion(lift, insideBox({ minX: 0, maxX: 1 })), [runner]);
    run(world, 0.9, 1 / 100);
    expect(runner.vy).toBe(0);
    run(world, 1, 1 / 100);
    expect(runner.vy).toBeGreaterThan(0.5);
    run(world, 0.5, 1 / 100);
    const { vy } = runner;
    run(world, 1, 1 / 100);
    expect(runner.vy).toBe(vy);
    expect(other.vy).toBe(0);
  });

  it('[F61] regions nest, and a force on one particle at a time finds its particles', () => {
    const world = new World();
    const particles = [-1, 0.5, 2, 0.7].map((x) => world.addParticle({ x, y: x }));
    const seen: number[] = [];
    const each = forEachParticle((particle) => seen.push(particles.indexOf(particle)));
    world.addForce(inRegion(inRegion(each, insideBox({ maxX: 1 })), insideHalfPlane({ x: 0, y: 0 }, { x: 1, y: 0 })));
    world.step(1 / 60);
    expect(seen).toEqual([1, 3]);
    particles[1].remove();
    for (let i = 0; i < 200; i++) particles.push(world.addParticle({ x: 0.1, y: 0 }));
    seen.length = 0;
    world.step(1 / 60);
    expect(seen).toHaveLength(201);
  });

  it('[F62] refuses what is no generator and no region', () => {
    expect(() => inRegion({} as never, insideBox({}))).toThrow('inRegion: a force generator must have a method apply');
    expect(() => inRegion(push, {} as never)).toThrow('inRegion: region must be such as insideBox makes');
    expect(() => insideBox({ minX: 1, maxX: 0 })).toThrow('insideBox: the greatest x must be at least the smallest');
    expect(() => insideBox({ minX: NaN })).toThrow(RangeError);
    expect(() => insideBox(undefined as never)).toThrow(TypeError);
    expect(() => insideDisc({ x: 0, y: 0, radius: 0 })).toThrow('insideDisc: radius');
    expect(() => insideDisc({ x: NaN, y: 0, radius: 1 })).toThrow('insideDisc: disc.x');
    expect(() => insideHalfPlane({ x: 0, y: 0 }, { x: 0, y: 0 })).toThrow('insideHalfPlane: normal must point');
  });

  it('[F63] a step leaves no garbage', () => {
    const world = new World();
    for (let i = 0; i < 200; i++) world.addParticle({ x: i, y: 0 });
    world.addForce(inRegion(push, insideBox({ maxX: 100 })));
    world.addForce(inRegion(push, insideDisc({ x: 0, y: 0, radius: 100 })));
    expect(garbagePerStep(world)).toBeLessThan(250);
  });
});
