import { DiscContacts, HalfPlane, Random, substep, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../../helpers.ts';

const DT = 1 / 60;

/** Momentum, and the sum of the absolute values that it is made of. */
function momentumOf({ particles: { count, mass, vx, vy } }: World): { x: number; y: number; scale: number } {
  const momentum = { x: 0, y: 0, scale: 0 };
  for (let i = 0; i < count; i++) {
    momentum.x += mass[i] * vx[i];
    momentum.y += mass[i] * vy[i];
    momentum.scale += mass[i] * (Math.abs(vx[i]) + Math.abs(vy[i]));
  }
  return momentum;
}

describe('momentum', () => {
  it.each([
    ['smooth and elastic', 1, 0],
    ['rough and dead', 0, 1],
    ['in between', 0.5, 0.4],
  ])('[S1] 60 discs that fly into each other keep it to 1e-12: %s', (_, restitution, friction) => {
    const random = new Random(5);
    const world = new World();
    world.addContactGenerator(new DiscContacts());
    for (let k = 0; k < 60; k++) {
      const x = (k % 10) - 4.5;
      const y = Math.floor(k / 10) - 2.5;
      const [vx, vy] = [-x + random.between(-3, 3), -y + random.between(-3, 3)];
      world.addParticle({ x, y, vx, vy, mass: 10 ** random.between(-2, 2), radius: 0.3, restitution, friction });
    }
    const before = momentumOf(world);
    let touched = 0;
    for (let step = 0; step < 120; step++) {
      world.step(DT);
      touched += world.contacts.count;
      const now = momentumOf(world);
      expect(Math.abs(now.x - before.x)).toBeLessThan(1e-12 * before.scale);
      expect(Math.abs(now.y - before.y)).toBeLessThan(1e-12 * before.scale);
    }
    expect(touched).toBeGreaterThan(500);
  });

  it('[S1] the impulses of contacts are the change of momentum, along the normal and along the tangent', () => {
    const world = new World({ gravity: { x: 0, y: -9.81 } });
    world.addShape(new HalfPlane({ friction: 1 }));
    const thrown = world.addParticle({
      x: 0,
      y: 0.4,
      vx: 5,
      vy: -10,
      mass: 2,
      radius: 0.25,
      friction: 0.3,
      restitution: 0.5,
    });
    for (let step = 0; step < 120; step++) {
      const { vx, vy } = thrown;
      world.step(DT);
      const { count, normalX, normalY, impulse, tangentImpulse } = world.contacts;
      let jx = 0;
      let jy = -2 * 9.81 * DT;
      for (let c = 0; c < count; c++) {
        jx += impulse[c] * normalX[c] + tangentImpulse[c] * normalY[c];
        jy += impulse[c] * normalY[c] - tangentImpulse[c] * normalX[c];
      }
      expect(2 * (thrown.vx - vx)).toBeCloseTo(jx, 12);
      expect(2 * (thrown.vy - vy)).toBeCloseTo(jy, 12);
    }
  });

  it('[S1] what rests presses with m·g·dt a step', () => {
    const world = new World({ gravity: { x: 0, y: -9.81 } });
    world.addShape(new HalfPlane());
    world.addContactGenerator(new DiscContacts());
    world.addParticle({ x: 0, y: 0.25, mass: 3, radius: 0.25 });
    world.addParticle({ x: 0, y: 0.75, mass: 2, radius: 0.25 });
    run(world, 20);
    const { count, b, impulse } = world.contacts;
    expect(count).toBe(2);
    const [onFloor, onDisc] = b[0] < 0 ? [impulse[0], impulse[1]] : [impulse[1], impulse[0]];
    expect(onFloor / (5 * 9.81 * DT)).toBeCloseTo(1, 3);
    expect(onDisc / (2 * 9.81 * DT)).toBeCloseTo(1, 3);
  });
});

describe('two bodies', () => {
  const masses = [1, 3, 100, 10_000];
  const restitutions = [0, 0.3, 0.5, 1];
  const cases = masses.flatMap((mass) => restitutions.map((restitution) => [mass, restitution] as const));

  it.each(cases)('[S2] head-on, masses of 1 : %s, restitution %s: as in the textbook', (mass, restitution) => {
    for (const swapped of [false, true]) {
      for (const speed of [0.5, 5, 50]) {
        const world = new World({ resolver: substep({ sleepTime: Infinity }) });
        world.addContactGenerator(new DiscContacts());
        const [m1, m2] = swapped ? [mass, 1] : [1, mass];
        const a = world.addParticle({ x: -1, y: 0, vx: speed, mass: m1, radius: 0.5, restitution });
        const b = world.addParticle({ x: 0.3, y: 0, mass: m2, radius: 0.5, restitution });
        run(world, 90);
        const together = (m1 * speed) / (m1 + m2);
        expect(a.vx).toBeCloseTo(together - (restitution * m2 * speed) / (m1 + m2), 10);
        expect(b.vx).toBeCloseTo(together + (restitution * m1 * speed) / (m1 + m2), 10);
        expect([a.vy, b.vy]).toEqual([0, 0]);
      }
    }
  });

  it('[S2] at an angle: along the line of the centres where they touch; across it nothing changes without friction', () => {
    for (const speed of [60, 200, 500]) {
      for (let k = 0; k < 39; k++) {
        const offset = -0.95 + k * 0.05; // of the way past the centre, in radii of both
        const world = new World();
        world.addContactGenerator(new DiscContacts());
        const a = world.addParticle({ x: -3 - k * 0.01, y: offset, vx: speed, mass: 2, radius: 0.5, restitution: 0.8 });
        const b = world.addParticle({ x: 0, y: 0, mass: 3, radius: 0.5, restitution: 0.2 });
        run(world, Math.ceil(4 / (speed * DT)) + 1);
        const nx = -Math.sqrt(1 - offset * offset);
        const ny = offset;
        const J = (1.8 * speed * nx * 6) / 5; // (1 + e) · closing speed · reduced mass
        expect(a.vx).toBeCloseTo(speed - (J * nx) / 2, 6);
        expect(a.vy).toBeCloseTo(-(J * ny) / 2, 6);
        expect(b.vx).toBeCloseTo((J * nx) / 3, 6);
        expect(b.vy).toBeCloseTo((J * ny) / 3, 6);
      }
    }
  });

  it('[S2] a slow hit at an angle is off by no more than 5 % of the speed, whatever the angle', () => {
    for (const speed of [1, 5, 14]) {
      for (let k = 0; k < 39; k++) {
        const offset = -0.95 + k * 0.05;
        const world = new World({ resolver: substep({ sleepTime: Infinity }) });
        world.addContactGenerator(new DiscContacts());
        const a = world.addParticle({ x: -2 - k * 0.01, y: offset, vx: speed, radius: 0.5, restitution: 1 });
        world.addParticle({ x: 0, y: 0, radius: 0.5 });
        run(world, Math.ceil(3 / (speed * DT)) + 1);
        const nx = -Math.sqrt(1 - offset * offset);
        expect(Math.hypot(a.vx - speed * offset * offset, a.vy - speed * nx * -offset) / speed).toBeLessThan(0.05);
      }
    }
  });

  it('[S2] a dead hit with friction takes friction times the normal speed off the tangent, and no more than there is', () => {
    for (const [vx, after] of [
      [8, 8 - 0.3 * 5],
      [-8, -8 + 0.3 * 5],
      [1, 0],
    ]) {
      const world = new World();
      world.addShape(new HalfPlane({ friction: 0.9 }));
      const disc = world.addParticle({ x: 0, y: 0.3, vx, vy: -5, radius: 0.25, friction: 0.1 });
      run(world, 5);
      expect(disc.vx).toBeCloseTo(after, 2);
      expect(disc.vy).toBeCloseTo(0, 2);
    }
  });

  it('[S3] what closes no faster than gravity makes it in a step rests; what is faster gives back its share', () => {
    for (const [vy, leaves] of [
      [-0.1, false],
      [-0.5, true],
    ] as const) {
      const world = new World({ gravity: { x: 0, y: -9.81 } });
      world.addShape(new HalfPlane({ restitution: 0.9 }));
      const disc = world.addParticle({ x: 0, y: 0.1, vy, radius: 0.1 });
      world.step(DT);
      if (leaves)
        expect(Math.abs(disc.vy - 0.45)).toBeLessThan((0.9 * 9.81 * DT) / 4 + 1e-9); // gravity acts first
      else expect(Math.abs(disc.vy)).toBeLessThan(0.01);
    }
  });
});
