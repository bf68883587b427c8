import {
  type ContactGenerator,
  cable,
  Disc,
  DiscContacts,
  HalfPlane,
  type Particle,
  Random,
  rod,
  severity,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../helpers.ts';

const DT = 1 / 60;
const MASSES = [0.01, 0.1, 1, 3, 100];
const RESTITUTIONS = [0, 0.2, 0.5, 0.9, 1];

/** Two discs that touch and close, alone in a world without gravity. */
function pair(options: {
  ma: number;
  mb: number;
  e: number;
  va: [number, number];
  vb: [number, number];
  turn: number;
}) {
  const { ma, mb, e, va, vb, turn } = options;
  const world = new World({ resolver: severity() });
  world.addContactGenerator(new DiscContacts());
  const far = { x: 0.3 * Math.cos(turn), y: 0.3 * Math.sin(turn) };
  const a = world.addParticle({ x: 0, y: 0, vx: va[0], vy: va[1], mass: ma, radius: 0.1, restitution: e });
  const b = world.addParticle({ ...far, vx: vb[0], vy: vb[1], mass: mb, radius: 0.2 });
  return { world, a, b };
}

describe('two bodies that hit', () => {
  it('[C5] head on, they part as the textbook says, for masses of 1 : 10 000 and any restitution', () => {
    for (const ma of MASSES) {
      for (const mb of MASSES) {
        for (const e of RESTITUTIONS) {
          const { world, a, b } = pair({ ma, mb, e, va: [4, 0], vb: [-2, 0], turn: 0 });
          world.step(DT);
          const mean = (4 * ma - 2 * mb) / (ma + mb);
          expect(Math.abs(a.vx - (mean - (e * 6 * mb) / (ma + mb)))).toBeLessThan(6e-12);
          expect(Math.abs(b.vx - (mean + (e * 6 * ma) / (ma + mb)))).toBeLessThan(6e-12);
          expect([a.vy, b.vy]).toEqual([0, 0]);
        }
      }
    }
  });

  it('[C5] equal masses at restitution 1 exchange their velocities; at 0 they go on together', () => {
    const exchange = pair({ ma: 2, mb: 2, e: 1, va: [3, 0], vb: [0, 0], turn: 0 });
    exchange.world.step(DT);
    expect([exchange.a.vx, exchange.b.vx]).toEqual([0, 3]);
    const together = pair({ ma: 2, mb: 2, e: 0, va: [3, 0], vb: [0, 0], turn: 0 });
    together.world.step(DT);
    expect([together.a.vx, together.b.vx]).toEqual([1.5, 1.5]);
  });

  it('[C5] obliquely, the velocity along the normal comes back times -c, and that along the surface stays', () => {
    const random = new Random(9);
    for (let i = 0; i < 500; i++) {
      const [ma, mb] = [MASSES[random.integer(0, 4)], MASSES[random.integer(0, 4)]];
      const [e, turn] = [random.next(), random.between(0, 7)];
      const speed = () => random.between(-5, 5);
      const [va, vb]: [number, number][] = [[speed(), speed()], [speed(), speed()]]; // biome-ignore format: one line
      const { world, a, b } = pair({ ma, mb, e, va, vb, turn });
      // The normal is that of the moment of detection: when both have moved.
      const dx = a.x + va[0] * DT - (b.x + vb[0] * DT);
      const dy = a.y + va[1] * DT - (b.y + vb[1] * DT);
      const [nx, ny] = [dx / Math.hypot(dx, dy), dy / Math.hypot(dx, dy)];
      world.step(DT);
      const along = (u: number[], v: number[]) => (u[0] - v[0]) * nx + (u[1] - v[1]) * ny;
      const across = (u: number[]) => u[1] * nx - u[0] * ny;
      const before = along(va, vb);
      const [wa, wb] = [[a.vx, a.vy], [b.vx, b.vy]]; // biome-ignore format: one line
      const expected = before < 0 && Math.hypot(dx, dy) < 0.3 * 1.01 ? -e * before : before;
      expect(Math.abs(along(wa, wb) - expected)).toBeLessThan(1e-11);
      expect(Math.abs(across(wa) - across(va))).toBeLessThan(1e-11);
      expect(Math.abs(across(wb) - across(vb))).toBeLessThan(1e-11);
      expect(Math.abs(ma * (wa[0] - va[0]) + mb * (wb[0] - vb[0]))).toBeLessThan(1e-12 * (ma + mb) * 14);
    }
  });

  it('[C5] of two restitutions the greater counts, between discs and with scenery', () => {
    for (const [one, other] of [
      [0.2, 0.7],
      [0.7, 0.2],
    ]) {
      // biome-ignore format: one line
      const world = new World({ resolver: severity() });
      world.addContactGenerator(new DiscContacts());
      const a = world.addParticle({ x: 0, y: 5, vx: 1, radius: 0.1, restitution: one });
      const b = world.addParticle({ x: 0.2, y: 5, radius: 0.1, restitution: other });
      const ball = world.addParticle({ x: 9, y: 0.1, vy: -1, radius: 0.1, restitution: one });
      world.addShape(new HalfPlane({ restitution: other }));
      world.step(DT);
      expect(b.vx - a.vx).toBeCloseTo(0.7, 12);
      expect(ball.vy).toBeCloseTo(0.7, 12);
    }
  });

  it('[C5] two that part already are left alone', () => {
    const { world, a, b } = pair({ ma: 1, mb: 2, e: 1, va: [-1, 0], vb: [1, 0], turn: 0 });
    world.step(DT);
    expect([a.vx, b.vx]).toEqual([-1, 1]);
  });
});

describe('momentum', () => {
  it('[C6] is kept to 1e-12 in every contact and every link, and the centre of mass moves on evenly', () => {
    const towards: ContactGenerator = {
      addContacts: (_, contacts) => contacts.add(0, 1, 0.6, 0.8, 0.01, 0.5),
    };
    for (let seed = 0; seed < 40; seed++) {
      const random = new Random(seed);
      const world = new World({ resolver: severity() });
      world.addContactGenerator(new DiscContacts());
      world.addContactGenerator(towards);
      const crowd: Particle[] = [];
      for (let i = 0; i < 25; i++) {
        const [x, y, vx, vy] = [0, 0, 0, 0].map(() => random.between(-1, 1));
        const mass = MASSES[random.integer(0, 4)];
        crowd.push(world.addParticle({ x, y, vx: vx * 5, vy: vy * 5, mass, radius: 0.25, restitution: random.next() }));
      }
      for (let i = 0; i + 3 < crowd.length; i += 3) {
        world.addLink(rod(crowd[i], crowd[i + 1]));
        world.addLink(cable(crowd[i + 1], crowd[i + 3], { restitution: 0.5 }));
      }
      const total = (weigh: (p: Particle) => number) => crowd.reduce((sum, p) => sum + p.mass * weigh(p), 0);
      const size = total((p) => Math.hypot(p.vx, p.vy));
      const [px, py, cx, cy] = [total((p) => p.vx), total((p) => p.vy), total((p) => p.x), total((p) => p.y)];
      run(world, 30);
      expect(Math.abs(total((p) => p.vx) - px)).toBeLessThan(1e-12 * size);
      expect(Math.abs(total((p) => p.vy) - py)).toBeLessThan(1e-12 * size);
      expect(Math.abs(total((p) => p.x) - cx - px * world.time)).toBeLessThan(1e-11 * size);
      expect(Math.abs(total((p) => p.y) - cy - py * world.time)).toBeLessThan(1e-11 * size);
    }
  });
});

describe('two that are in each other', () => {
  it('[C7] move apart along the normal, both ways, in inverse proportion to mass, until they touch', () => {
    for (const ma of MASSES) {
      for (const mb of MASSES) {
        const world = new World({ resolver: severity() });
        world.addContactGenerator(new DiscContacts());
        const a = world.addParticle({ x: 1, y: 1, mass: ma, radius: 0.1 });
        const b = world.addParticle({ x: 1.03, y: 1.04, mass: mb, radius: 0.1 });
        world.step(DT);
        // They were 0.05 apart along (3, 4) / 5, and are 0.15 too near.
        expect(a.x).toBeCloseTo(1 - (0.15 * 0.6 * mb) / (ma + mb), 12);
        expect(a.y).toBeCloseTo(1 - (0.15 * 0.8 * mb) / (ma + mb), 12);
        expect(b.x).toBeCloseTo(1.03 + (0.15 * 0.6 * ma) / (ma + mb), 12);
        expect(b.y).toBeCloseTo(1.04 + (0.15 * 0.8 * ma) / (ma + mb), 12);
        expect([a.vx, a.vy, b.vx, b.vy]).toEqual([0, 0, 0, 0]);
      }
    }
  });

  it('[C7] a small box sunk into a planet: only the box moves, whether the planet is pinned or scenery', () => {
    for (const scenery of [true, false]) {
      const world = new World({ resolver: severity() });
      world.addContactGenerator(new DiscContacts());
      const planet = scenery ? undefined : world.addParticle({ x: 0, y: 0, radius: 5, mass: Infinity });
      if (scenery) world.addShape(new Disc({ centre: { x: 0, y: 0 }, radius: 5 }));
      const box = world.addParticle({ x: 3, y: 3.9, radius: 0.1, mass: 0.01 });
      world.step(DT);
      expect(Math.hypot(box.x, box.y)).toBeCloseTo(5.1, 12);
      expect(box.y / box.x).toBeCloseTo(1.3, 12);
      if (planet) expect([planet.x, planet.y, planet.vx, planet.vy]).toEqual([0, 0, 0, 0]);
    }
  });

  it('[C7] two of one centre are parted too', () => {
    const world = new World({ resolver: severity() });
    world.addContactGenerator(new DiscContacts());
    const a = world.addParticle({ x: 0.3, y: 0.3, radius: 0.1 });
    const b = world.addParticle({ x: 0.3, y: 0.3, radius: 0.1 });
    world.step(DT);
    expect(Math.hypot(a.x - b.x, a.y - b.y)).toBeCloseTo(0.2, 12);
  });

  it('[C7] two pinned ones, or points, do not touch; a pinned one that moves pushes', () => {
    const world = new World({ resolver: severity() });
    world.addContactGenerator(new DiscContacts());
    world.addParticle({ x: 0, y: 0, radius: 1, mass: Infinity });
    world.addParticle({ x: 0.5, y: 0, radius: 1, mass: Infinity });
    world.addParticle({ x: 9, y: 0 });
    world.addParticle({ x: 9, y: 0 });
    world.step(DT);
    expect(world.contacts.count).toBe(0);
    world.addParticle({ x: 20, y: 0, vx: 2, radius: 0.1, mass: Infinity });
    const pushed = world.addParticle({ x: 20.2, y: 0, radius: 0.1, mass: 5 });
    world.step(DT);
    expect(pushed.vx).toBeCloseTo(2, 12);
  });
});
