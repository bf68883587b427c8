import { box, cable, DiscContacts, EdgeContacts, HalfPlane, type Particle, Random, rod, World } from '@mass/core';
import { describe, expect, it } from 'vitest';

/** Motion alone. Unit: J. */
function energyOf({ particles: { count, mass, vx, vy } }: World): number {
  let energy = 0;
  for (let i = 0; i < count; i++) energy += (mass[i] * (vx[i] * vx[i] + vy[i] * vy[i])) / 2;
  return energy;
}

function room(restitution: number): World {
  const world = new World();
  for (const [x, y] of [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ]) {
    world.addShape(new HalfPlane({ point: { x: -2 * x, y: -2 * y }, normal: { x, y }, restitution }));
  }
  world.addContactGenerator(new DiscContacts());
  return world;
}

/** A chain whose particles weigh from 1 g to 10 kg, thrown at a wall. */
function chain(world: World, random: Random, x: number, kind: typeof rod | typeof cable): Particle[] {
  const ends = Array.from({ length: 6 }, (_, k) =>
    world.addParticle({
      x: x + 0.3 * k,
      y: random.between(-0.05, 0.05),
      vx: random.between(-20, 20),
      vy: random.between(-20, 20),
      radius: 0.1,
      mass: 10 ** random.between(-3, 1),
    }),
  );
  for (let k = 1; k < ends.length; k++) world.addLink(kind(ends[k - 1], ends[k]));
  return ends;
}

describe('energy of motion', () => {
  it.each([
    ['rods', rod, 0],
    ['rods', rod, 1],
    ['cables', cable, 0],
    ['cables', cable, 1],
  ])('[S25] of %s that are thrown about among walls is never more than at first: (%#)', (_, kind, restitution) => {
    const random = new Random(7);
    for (let n = 0; n < 10; n++) {
      const world = room(restitution);
      chain(world, random, -1.7, kind);
      chain(world, random, 0.1, kind);
      let most = energyOf(world);
      for (let step = 0; step < 200; step++) {
        world.step(1 / 60);
        const energy = energyOf(world);
        expect(energy).toBeLessThan(most * 1.05);
        most = Math.max(most, energy);
      }
      expect(most).toBeGreaterThan(0);
    }
  });

  it('[S25] of light boxes between heavy discs, all of which bounce, is never more than at first', () => {
    const world = room(1);
    world.addContactGenerator(new EdgeContacts(world));
    const random = new Random(3);
    for (let n = 0; n < 4; n++) {
      const at = { x: -1.5 + n, y: random.between(-1, 1), vx: random.between(-5, 5), vy: random.between(-5, 5) };
      world.addBody(box({ ...at, width: 0.3, height: 0.2, mass: 0.01, radius: 0.02, restitution: 1 }));
      world.addParticle({ ...at, y: at.y > 0 ? at.y - 0.8 : at.y + 0.8, radius: 0.3, mass: 50, restitution: 1 });
    }
    const first = energyOf(world);
    for (let step = 0; step < 600; step++) {
      world.step(1 / 60);
      expect(energyOf(world)).toBeLessThan(first * 1.05);
    }
    expect(energyOf(world)).toBeGreaterThan(first * 0.3);
  });

  it('[S25] comes from what drives: a bat of infinite mass, an anchor that is put elsewhere, a winch', () => {
    const bat = room(1);
    const ball = bat.addParticle({ x: 0, y: 0, radius: 0.1, restitution: 1 });
    bat.addParticle({ x: -1, y: 0, vx: 5, radius: 0.1, mass: Infinity });
    for (let step = 0; step < 14; step++) bat.step(1 / 60);
    expect(ball.vx).toBeCloseTo(10, 6);

    const crane = new World({ gravity: { x: 0, y: -9.81 } });
    crane.addShape(new HalfPlane({ point: { x: 0, y: -3 } }));
    const anchor = crane.addParticle({ x: 0, y: 0, mass: Infinity });
    const load = crane.addParticle({ x: 0, y: -2, mass: 5 });
    crane.addLink(rod(anchor, load));
    for (let step = 0; step < 60; step++) {
      anchor.x += 2 / 60; // as a game does that drags it along
      crane.step(1 / 60);
    }
    expect(load.vx).toBeGreaterThan(1);

    const winch = new World({ gravity: { x: 0, y: -9.81 } });
    winch.addShape(new HalfPlane({ point: { x: 0, y: -2 } }));
    const box = winch.addParticle({ x: 0, y: -2, mass: 5 });
    const rope = winch.addLink(cable({ x: 0, y: 0 }, box, { maxLength: 2 }));
    for (let step = 0; step < 60; step++) {
      rope.setLength(0, rope.maxLength - 1 / 60);
      winch.step(1 / 60);
    }
    expect(box.y).toBeGreaterThan(-1.01);
  });
});
