import { describe, expect, it } from 'vitest';
import { World } from '../../src/index.ts';
import { Palette, type Style, Trails, trailLevels } from '../../src/view/index.ts';

const style: Style = { particle: { trail: { seconds: 1, points: 10 } } };

function points(trails: Trails, slot: number): number[] {
  return Array.from({ length: trails.length[slot] }, (_, k) => {
    const at = (trails.head - k + trails.capacity) % trails.capacity;
    return Math.round(trails.x[slot * trails.capacity + at] * 1e4) / 1e4;
  });
}

function segments(trails: Trails, c = 0): number {
  return trails.ranges[c * (trailLevels + 1) + trailLevels];
}

describe('Trails', () => {
  it('samples by the time of the world, however often it is drawn', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0, vx: 1 });
    const rare = new Trails(new Palette(style));
    const often = new Trails(new Palette(style));
    for (let i = 0; i < 60; i++) {
      world.step(1 / 60);
      rare.update(world);
      for (let n = 0; n < 5; n++) often.update(world);
    }
    expect(points(often, 0)).toEqual(points(rare, 0));
    expect(points(rare, 0).slice(0, 3)).toEqual([0.9, 0.8, 0.7]);
  });

  it('never runs ahead of what is drawn', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0, vx: 1 });
    const trails = new Trails(new Palette(style));
    for (let i = 0; i < 30; i++) {
      world.step(1 / 60);
      trails.update(world);
      expect(points(trails, 0)[0]).toBeLessThanOrEqual(world.particles.previousX[0] + 1e-4);
    }
  });

  it('is as long as its time, and its segments fade with age', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0, vx: 1 });
    const trails = new Trails(new Palette(style));
    for (let i = 0; i < 600; i++) {
      world.step(1 / 60);
      trails.update(world);
    }
    expect(segments(trails)).toBeGreaterThanOrEqual(10);
    expect(segments(trails)).toBeLessThanOrEqual(11);
    const ranges = [...trails.ranges];
    expect(ranges).toEqual([...ranges].sort((a, b) => a - b));
    expect(ranges[0]).toBe(0);
  });

  it('starts anew in a slot that passed to another particle', () => {
    const world = new World();
    const first = world.addParticle({ x: 0, y: 0, vx: 1 });
    world.addParticle({ x: 0, y: 1, vx: 1 });
    const trails = new Trails(new Palette(style));
    for (let i = 0; i < 60; i++) {
      world.step(1 / 60);
      trails.update(world);
    }
    first.remove();
    const second = world.addParticle({ x: 50, y: 0 });
    expect(second.slot).toBe(first.slot);
    trails.update(world);
    expect(points(trails, second.slot)).toEqual([]);
    expect(points(trails, 1).length).toBeGreaterThan(5);
    for (let i = 0; i < 12; i++) {
      world.step(1 / 60);
      trails.update(world);
    }
    expect(new Set(points(trails, second.slot))).toEqual(new Set([50]));
  });

  it('forgets a removed particle even when its slot stays free', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    const trails = new Trails(new Palette(style));
    world.step(1 / 60);
    trails.update(world);
    expect(trails.length[0]).toBe(1);
    particle.remove();
    trails.update(world);
    expect(trails.length[0]).toBe(0);
  });

  it('starts anew with another world, whose time is an earlier one or not', () => {
    const trails = new Trails(new Palette(style));
    const run = (steps: number): World => {
      const world = new World();
      world.addParticle({ x: 0, y: 0, vx: 1 });
      for (let i = 0; i < steps; i++) {
        world.step(1 / 60);
        trails.update(world);
      }
      return world;
    };
    run(60);
    run(6);
    expect(points(trails, 0).length).toBe(1);
  });

  it('keeps none for groups without', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0 });
    world.addParticle({ x: 0, y: 0, group: 1 });
    const trails = new Trails(new Palette({ groups: { 1: { trail: { seconds: 1 } } } }));
    world.step(1 / 60);
    trails.update(world);
    expect([...trails.length.subarray(0, 2)]).toEqual([0, 1]);
  });

  it('keeps positions when only colours change', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0, vx: 1 });
    const trails = new Trails(new Palette(style));
    for (let i = 0; i < 60; i++) {
      world.step(1 / 60);
      trails.update(world);
    }
    const dark = new Palette({ particle: { ...style.particle, fill: '#ffffff' } });
    expect(points(trails.withPalette(dark), 0)).toEqual(points(trails, 0));
    const longer = new Palette({ particle: { trail: { seconds: 5 } } });
    expect(trails.withPalette(longer).length.length).toBe(0);
  });

  it('grows with the world', () => {
    const world = new World();
    const trails = new Trails(new Palette(style));
    for (let n = 0; n < 5; n++) {
      for (let i = 0; i < 100; i++) world.addParticle({ x: n, y: 0 });
      world.step(0.1);
      trails.update(world);
    }
    expect(points(trails, 0)).toEqual([0, 0, 0, 0, 0]);
    expect(points(trails, 499)).toEqual([4]);
  });
});
