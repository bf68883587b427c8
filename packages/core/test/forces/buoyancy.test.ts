import { Buoyancy, type Particle, travellingWave, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { sineOfTurns } from '../../src/math/sine.ts';
import { forceOn, garbagePerStep, period, run } from './measure.ts';

/** A box 0.1 m high of a litre: 0.01 m² wide and deep. */
const litre = { volume: 0.001, maxDepth: 0.05 };

function afloat(options: object, at: object, hull = litre): [World, Particle, Buoyancy] {
  const world = new World();
  const box = world.addParticle({ x: 0, y: 0, ...at });
  const water = world.addForce(new Buoyancy(options));
  water.setHull(box, hull);
  return [world, box, water];
}

describe('the law of buoyancy', () => {
  it('[F31] a litre under water is lifted by 10 N, and by 5 N half under (the worked example of the thesis, g = 10)', () => {
    const [deep, block, water] = afloat({ g: 10 }, { y: -1, mass: 0.5 });
    expect([water.submergedShare(block), water.force(block)]).toEqual([1, 10]);
    expect(forceOn(deep, block).y).toBeCloseTo(10, 9);

    const [surface, float, sea] = afloat({ g: 10 }, { y: 0, mass: 0.5 });
    expect([sea.submergedShare(float), sea.force(float)]).toEqual([0.5, 5]);
    expect(forceOn(surface, float).y).toBeCloseTo(5, 9);
    expect(forceOn(surface, float).x).toBe(0);
  });

  it.each([
    [0.051, 0],
    [0.05, 0],
    [0.025, 0.25],
    [0, 0.5],
    [-0.025, 0.75],
    [-0.05, 1],
    [-7, 1],
  ])('[F31] with its middle at %d m above the surface the share %d is under', (above, share) => {
    const [world, box, water] = afloat({ level: 3, density: 800, g: 10 }, { y: 3 + above });
    expect(water.submergedShare(box)).toBeCloseTo(share, 12);
    expect(water.force(box)).toBeCloseTo(share * 8, 12);
    expect(forceOn(world, box).y).toBeCloseTo(share * 8, 8);
  });

  it('[F32] at rest a float draws m / (ρ·A), and is stable on both sides', () => {
    for (const start of [0.3, -0.3]) {
      const world = new World({ gravity: { x: 0, y: -9.81 } });
      const box = world.addParticle({ x: 0, y: start, mass: 0.3 });
      const water = world.addForce(new Buoyancy({ k1: 3 }));
      water.setHull(box, litre);
      run(world, 20, 1 / 60);
      expect(0.05 - box.y).toBeCloseTo(0.3 / (1000 * 0.01), 9); // how deep its underside is
      expect(water.submergedShare(box)).toBeCloseTo(0.3, 8);
    }
  });

  it.each([
    [1 / 240, 0.001],
    [1 / 60, 0.01],
  ])('[F32] it bobs with period 2π √(m / (ρ·A·g)): dt = %d s', (dt, share) => {
    const world = new World({ gravity: { x: 0, y: -9.81 } });
    const box = world.addParticle({ x: 0, y: 0.02, mass: 0.5 });
    world.addForce(new Buoyancy()).setHull(box, litre);
    const ideal = 2 * Math.PI * Math.sqrt(0.5 / (1000 * 0.01 * 9.81));
    expect(Math.abs(period(world, dt, 10, () => box.y) / ideal - 1)).toBeLessThan(share);
  });

  it('[F32] what is heavier than the liquid sinks, at last with its weight under water', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const stone = world.addParticle({ x: 0, y: -1, mass: 2 });
    world.addForce(new Buoyancy({ g: 10 })).setHull(stone, litre);
    run(world, 1, 1 / 60);
    expect(stone.vy).toBeCloseTo(-5, 10); // (20 N - 10 N) / 2 kg for 1 s
  });

  it('[F33] a particle is a disc of its radius, 1 m thick, unless it has a hull of its own; a point feels nothing', () => {
    const world = new World();
    const disc = world.addParticle({ x: 0, y: -5, radius: 0.2 });
    const point = world.addParticle({ x: 1, y: -5 });
    const water = world.addForce(new Buoyancy({ density: 500, g: 10 }));
    const lift = Math.PI * 0.04 * 500 * 10;
    expect(water.force(disc)).toBeCloseTo(lift, 10);
    expect([water.submergedShare(point), water.force(point)]).toEqual([1, 0]);
    expect(forceOn(world, disc).y).toBeCloseTo(lift, 8);
    expect([point.vx, point.vy]).toEqual([0, 0]);
    disc.y = 0.1;
    expect(water.submergedShare(disc)).toBeCloseTo(0.25, 12);
    expect(water.hullOf(disc)).toEqual({ volume: Math.PI * 0.2 * 0.2, maxDepth: 0.2 });
  });

  it('[F33] a hull is forgotten with its particle, and not taken over with the slot', () => {
    const world = new World();
    const water = world.addForce(new Buoyancy({ g: 10 }));
    const [a, b] = [0, 1].map((x) => world.addParticle({ x, y: -5 }));
    water.setHull(a, litre);
    water.setHull(b, litre);
    world.step(1 / 60);
    a.remove();
    const next = world.addParticle({ x: 0, y: -5 });
    expect(next.slot).toBe(a.slot);
    expect(forceOn(world, next).y).toBe(0);
    expect(forceOn(world, b).y).toBeCloseTo(10, 9);
    expect(() => water.setHull(a, litre)).toThrow(
      'Buoyancy.setHull: the particle must be in its world; it was removed.',
    );
    expect(() => water.force(a)).toThrow('removed');
  });

  it('[F33] hulls stay with their particles as the arrays grow', () => {
    const [world, box, water] = afloat({ g: 10 }, { y: -1 });
    for (let i = 0; i < 200; i++) world.addParticle({ x: i, y: -1 });
    expect(forceOn(world, box).y).toBeCloseTo(10, 9);
    expect(water.hullOf(box)).toEqual(litre);
  });
});

describe('drag in a liquid', () => {
  it('[F34] is in proportion to the share that is under, and of both kinds', () => {
    for (const [y, share] of [
      [0.06, 0],
      [0, 0.5],
      [-1, 1],
    ]) {
      const [world, box] = afloat({ k1: 2, k2: 3, g: 0 }, { y, vx: 3, vy: 4 });
      const force = forceOn(world, box);
      expect(force.x).toBeCloseTo(-share * (2 + 3 * 5) * 3, 6);
      expect(force.y).toBeCloseTo(-share * (2 + 3 * 5) * 4, 6);
    }
  });

  it('[F34] a liquid that flows takes along what floats in it', () => {
    const [world, box] = afloat({ k1: 5, g: 0, flow: { x: 2, y: 0 } }, { y: -1 });
    run(world, 10, 1 / 60);
    expect(box.vx).toBeCloseTo(2, 9);
    expect(box.vy).toBe(0);
  });

  it('[F34] never throws back, however light the particle', () => {
    const [world, box] = afloat({ k1: 1000, k2: 1000, g: 0 }, { y: -1, mass: 0.001, vx: 100 });
    world.step(1 / 60);
    expect(box.vx).toBeCloseTo(0, 12);
  });

  it('[F34] what sinks ends at the speed at which drag and lift carry its weight', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const stone = world.addParticle({ x: 0, y: -1, mass: 2 });
    world.addForce(new Buoyancy({ g: 10, k1: 5 })).setHull(stone, litre);
    run(world, 20, 1 / 60);
    expect(stone.vy).toBeCloseTo(-(20 - 10) / 5, 9);
  });
});

describe('a level that moves', () => {
  it('[F35] may be set', () => {
    const [world, box, water] = afloat({ g: 10 }, { y: 1 });
    expect(forceOn(world, box).y).toBe(0);
    water.level = 1;
    water.density = 500;
    expect([water.level, water.density, water.force(box)]).toEqual([1, 500, 2.5]);
    expect(forceOn(world, box).y).toBeCloseTo(2.5, 9);
  });

  it('[F35] may be a function of place and time, which also says where to draw it', () => {
    const calls: [number, number][] = [];
    const world = new World();
    const water = world.addForce(
      new Buoyancy({
        g: 10,
        level: (x, time) => {
          calls.push([x, time]);
          return x + time;
        },
      }),
    );
    const box = world.addParticle({ x: 0.5, y: 0.5 });
    water.setHull(box, litre);
    world.step(1 / 64);
    expect(calls).toEqual([[0.5, 0]]);
    expect(box.vy).toBeCloseTo(5 / 64, 12);
    world.step(1 / 64);
    expect(calls[1]).toEqual([0.5, 1 / 64]);
    expect(water.levelAt(2)).toBe(2 + 2 / 64);
  });

  it('[F35] after a step that failed the time is that of the world, as before it', () => {
    const times: number[] = [];
    const [world, box] = afloat({ level: (_x: number, time: number) => times.push(time) && 0 }, { y: 0 });
    world.step(1 / 64);
    world.particles.vx[box.slot] = Number.NaN;
    expect(() => world.step(1 / 64)).toThrow('finite');
    box.vx = 0;
    times.length = 0;
    world.step(1 / 64);
    expect(times).toEqual([1 / 64]);
  });

  it('[F35] a level that is no number is named with its generator', () => {
    const [world] = afloat({ level: () => Number.NaN }, { y: 0 });
    expect(() => world.step(1 / 60)).toThrow('Buoyancy');
  });

  it('[F36] a travelling wave moves to the right at its speed, by default that of deep water', () => {
    const wave = travellingWave({ level: 2, amplitude: 0.5, length: 4, speed: 3 });
    expect(wave(0, 0)).toBe(2);
    expect(wave(1, 0)).toBe(2.5);
    expect(wave(3, 0)).toBe(1.5);
    for (const x of [-3, 0.3, 10]) expect(wave(x + 3 * 0.7, 0.7)).toBeCloseTo(wave(x, 0), 13);
    const speed = Math.sqrt((9.81 * 4) / (2 * Math.PI));
    const deep = travellingWave({ amplitude: 0.5, length: 4 });
    expect(deep(1 + speed * 2, 2)).toBeCloseTo(0.5, 13);
  });

  it('[F36] the sine of a travelling wave is true to the last bit or two, at any angle', () => {
    let worst = 0;
    for (let turns = -3; turns < 3; turns += 0.00137) {
      worst = Math.max(worst, Math.abs(sineOfTurns(turns) - Math.sin(2 * Math.PI * (turns - Math.round(turns)))));
    }
    expect(worst).toBeLessThan(4.5e-16);
    expect([0, 0.25, 0.5, 0.75, 1, 1e15].map(sineOfTurns)).toEqual([0, 1, 0, -1, 0, 0]);
  });
});

it.each([
  [{ level: NaN }, 'level must be a finite number of metres'],
  [{ level: 'high' }, 'level must be a finite number of metres'],
  [{ density: -1 }, 'density must be a finite number of kilograms per cubic metre, 0 or more'],
  [{ g: Infinity }, 'g must be'],
  [{ k1: -1 }, 'k1 must be'],
  [{ k2: NaN }, 'k2 must be'],
  [{ flow: 3 }, 'flow must be { x, y }'],
])('[F37] refuses a liquid of %o', (options, message) => {
  expect(() => new Buoyancy(options as object)).toThrow(`Buoyancy: ${message}`);
});

it('[F37] refuses hulls, levels, densities and waves that make no sense', () => {
  const [, box, water] = afloat({}, {});
  const hull = (value: unknown) => () => water.setHull(box, value as never);
  expect(hull(undefined)).toThrow('hull must be an object such as');
  expect(hull({ volume: 0, maxDepth: 1 })).toThrow('volume must be a positive, finite number of cubic metres');
  expect(hull({ volume: 1, maxDepth: -1 })).toThrow('maxDepth must be a positive, finite number of metres');
  expect(() => water.setHull({} as Particle, litre)).toThrow(TypeError);
  expect(() => {
    water.level = NaN;
  }).toThrow('Buoyancy.level');
  expect(() => {
    water.density = -1;
  }).toThrow('Buoyancy.density');
  expect(() => travellingWave({ amplitude: -1, length: 1 })).toThrow('travellingWave: amplitude');
  expect(() => travellingWave({ amplitude: 1, length: 0 })).toThrow('travellingWave: length');
  expect(() => travellingWave({ amplitude: 1, length: 1, speed: NaN })).toThrow('travellingWave: speed');
});

it('[F38] a step in a liquid leaves no garbage', () => {
  const world = new World({ gravity: { x: 0, y: -9.81 } });
  const water = world.addForce(new Buoyancy({ k1: 1, k2: 1 }));
  for (let i = 0; i < 200; i++) {
    const box = world.addParticle({ x: i, y: 0, mass: 0.5, radius: 0.1 });
    if (i % 2) water.setHull(box, litre);
  }
  expect(garbagePerStep(world)).toBeLessThan(250);
});
