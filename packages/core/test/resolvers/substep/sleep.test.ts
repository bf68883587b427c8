import {
  cable,
  DiscContacts,
  type ForceGenerator,
  Gravity,
  HalfPlane,
  type Particle,
  PointerSpring,
  Random,
  rod,
  Segment,
  Springs,
  substep,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { hashOf, run } from '../../helpers.ts';

const DT = 1 / 60;
const G = { x: 0, y: -9.81 };

/** A world with a floor in which discs collide. */
function floorWorld(): World {
  const world = new World({ gravity: G });
  world.addShape(new HalfPlane({ friction: 0.5 }));
  world.addContactGenerator(new DiscContacts());
  return world;
}

/** Steps until all sleep. */
function settle(world: World, seconds = 10): void {
  for (let step = 0; step < seconds / DT && world.sleepingCount < world.particleCount; step++) world.step(DT);
  expect(world.sleepingCount).toBe(world.particleCount);
}

/** A column of three discs that sleep, the lowest first. */
function sleepers(world: World = floorWorld()): { world: World; column: Particle[] } {
  const column = [0.25, 0.75, 1.25].map((y) => world.addParticle({ x: 0, y, radius: 0.25, friction: 0.5 }));
  settle(world);
  return { world, column };
}

describe('falling asleep', () => {
  it('[S14] a pile of 100 discs dropped into a box is asleep within 10 s', () => {
    const random = new Random(2);
    const world = floorWorld();
    world.addShape(new HalfPlane({ normal: { x: 1, y: 0 } }));
    world.addShape(new HalfPlane({ normal: { x: -1, y: 0 }, point: { x: 6, y: 0 } }));
    for (let k = 0; k < 100; k++) {
      const x = 0.3 + (k % 10) * 0.6 + random.between(-0.02, 0.02);
      const y = 0.3 + Math.floor(k / 10) * 0.7;
      world.addParticle({ x, y, radius: random.between(0.2, 0.28), friction: 0.5, restitution: 0.2 });
    }
    settle(world);
  });

  it('[S14] what hangs on a cable, and what hangs together by rods, falls asleep too', () => {
    const world = floorWorld();
    const bob = world.addParticle({ x: 0, y: 3, radius: 0.1 });
    world.addLink(cable({ x: 0, y: 4 }, bob));
    const [a, b] = [2, 3].map((x) => world.addParticle({ x, y: 0.25, radius: 0.25, friction: 0.5 }));
    world.addLink(rod(a, b));
    settle(world);
  });

  it('[S14] asleep nothing moves by a bit, for 1000 steps; only time goes on', () => {
    const { world } = sleepers();
    world.step(DT);
    const before = hashOf(world);
    const { time, stepCount } = world;
    run(world, 1000);
    expect(hashOf(world)).toBe(before);
    expect(world.stepCount).toBe(stepCount + 1000);
    expect(world.time).toBeCloseTo(time + 1000 * DT, 9);
  });

  it('[S14] with a sleep time of infinity nothing falls asleep', () => {
    const world = new World({ gravity: G, resolver: substep({ sleepTime: Infinity }) });
    world.addShape(new HalfPlane());
    world.addParticle({ x: 0, y: 0.25, radius: 0.25 });
    run(world, 600);
    expect(world.sleepingCount).toBe(0);
  });

  it('[S14] sleep begins after the sleep time, no sooner', () => {
    for (const sleepTime of [0.2, 2]) {
      const world = new World({ gravity: G, resolver: substep({ sleepTime }) });
      world.addShape(new HalfPlane());
      const disc = world.addParticle({ x: 0, y: 0.25, radius: 0.25 });
      run(world, Math.floor(sleepTime / DT) - 2);
      expect(disc.asleep).toBe(false);
      run(world, 12);
      expect(disc.asleep).toBe(true);
    }
  });

  it('[S15] not while one of those that touch or hang together moves', () => {
    const world = floorWorld();
    const [a, b] = [0, 0.5].map((x) => world.addParticle({ x, y: 0.25, radius: 0.25 }));
    const pendulum = world.addParticle({ x: 0.5, y: 1.25, radius: 0.1 });
    const bob = world.addParticle({ x: 1.2, y: 1.25, radius: 0.1 });
    world.addLink(rod(b, pendulum));
    world.addLink(rod(pendulum, bob));
    for (let step = 0; step < 60; step++) {
      world.step(DT);
      expect(a.asleep && !b.asleep).toBe(false);
    }
  });

  it('[S15] not under a force that is not steady, as every force of a game is; a steady one may', () => {
    const still: ForceGenerator = { apply: () => undefined };
    for (const [force, sleeps] of [
      [still, false],
      [{ ...still, steady: true }, true],
      [new Gravity({ x: 0, y: -1 }), true],
    ] as const) {
      const world = floorWorld();
      const disc = world.addParticle({ x: 0, y: 0.25, radius: 0.25 });
      world.addForce(force);
      run(world, 300);
      expect(disc.asleep).toBe(sleeps);
    }
  });

  it('[S15] only those that it acts on stay awake', () => {
    const world = floorWorld();
    const [a, b] = [0, 2].map((x) => world.addParticle({ x, y: 0.25, radius: 0.25 }));
    world.addForce({ apply: () => undefined }, [a]);
    run(world, 300);
    expect([a.asleep, b.asleep]).toEqual([false, true]);
  });
});

describe('waking', () => {
  it('[S16] when a moving disc touches: the whole island, and no other', () => {
    const { world, column } = sleepers();
    const apart = world.addParticle({ x: 9, y: 0.25, radius: 0.25 });
    settle(world);
    world.addParticle({ x: 2, y: 0.25, vx: -5, radius: 0.25 });
    expect(column.map((disc) => disc.asleep)).toEqual([true, true, true]);
    run(world, 22);
    expect(column.map((disc) => disc.asleep)).toEqual([false, false, false]);
    expect(apart.asleep).toBe(true);
    expect(column[0].vx).toBeLessThan(0);
  });

  it('[S16] momentum is kept in the touch that wakes', () => {
    const world = new World();
    world.addContactGenerator(new DiscContacts());
    const rests = world.addParticle({ x: 0, y: 0, radius: 0.25, mass: 2 });
    settle(world);
    const comes = world.addParticle({ x: -1, y: 0, vx: 3, radius: 0.25, restitution: 1 });
    run(world, 30);
    expect(2 * rests.vx + comes.vx).toBeCloseTo(3, 12);
    expect(rests.vx).toBeCloseTo(2, 9);
  });

  it.each<[string, (world: World, column: Particle[]) => void]>([
    ['what it stands on is removed', (world, [lowest]) => world.removeParticle(lowest)],
    ['the shape that it stands on is removed', (world) => world.removeShape(world.shapes[0])],
    [
      'gravity changes',
      (world) => {
        world.gravity = { x: 8, y: -9.81 };
      },
    ],
    [
      'a position is written',
      (_, column) => {
        column[2].x += 1;
      },
    ],
    [
      'a velocity is written',
      (_, column) => {
        column[1].vx = 2;
      },
    ],
    ['an impulse is given', (_, column) => column[1].applyImpulse(2, 0)],
    ['a force is applied', (_, column) => column[1].applyForce(200, 0)],
    ['a force is added', (world) => void world.addForce(new Gravity({ x: 5, y: 0 }))],
    [
      'a shape is added',
      (world) => void world.addShape(new HalfPlane({ normal: { x: -1, y: 0 }, point: { x: 0, y: 0 } })),
    ],
  ])('[S17] when %s', (_, change) => {
    const { world, column } = sleepers();
    const start = column.map((disc) => [disc.x, disc.y]);
    const survivors = column.slice();
    change(world, column);
    world.step(DT);
    for (const disc of survivors) if (disc.alive) expect(disc.asleep).toBe(false);
    run(world, 60);
    const moved = survivors.some(
      (disc, k) => disc.alive && Math.hypot(disc.x - start[k][0], disc.y - start[k][1]) > 0.01,
    );
    expect(moved).toBe(true);
  });

  it('[S17] when the link is removed, or goes with its other end', () => {
    for (const removeEnd of [false, true]) {
      const world = floorWorld();
      const bob = world.addParticle({ x: 0, y: 3, radius: 0.1 });
      const pin = world.addParticle({ x: 0, y: 4, mass: Infinity });
      const hook = world.addLink(cable(pin, bob));
      run(world, 300);
      expect(bob.asleep).toBe(true);
      if (removeEnd) world.removeParticle(pin);
      else world.removeLink(hook);
      run(world, 60);
      expect(bob.y).toBeLessThan(2);
    }
  });

  it('[S17] when a cable that it hangs on is wound in', () => {
    const world = floorWorld();
    const bob = world.addParticle({ x: 0, y: 3, radius: 0.1 });
    const hook = world.addLink(cable({ x: 0, y: 4 }, bob));
    run(world, 300);
    expect(bob.asleep).toBe(true);
    hook.setLength(0, 0.5);
    run(world, 60);
    expect(bob.y).toBeCloseTo(3.5, 2);
  });

  it('[S17] when a pointer drags it', () => {
    const world = floorWorld();
    const hand = world.addForce(new PointerSpring(), []);
    const disc = world.addParticle({ x: 0, y: 0.25, radius: 0.25 });
    world.addForce(hand, [disc]);
    run(world, 300);
    hand.grab(disc);
    hand.moveTo(0, 3);
    run(world, 120);
    expect(disc.y).toBeGreaterThan(2.5);
  });

  it('[S17] when a spring that hangs on it is added', () => {
    const { world, column } = sleepers();
    const springs = new Springs();
    springs.add(column[2], { x: 0, y: 4 }, { stiffness: 50, restLength: 1 });
    world.addForce(springs);
    run(world, 60);
    expect(column[2].y).toBeGreaterThan(1.5);
  });

  it('[S18] what stands on, or is touched by, a moving platform of infinite mass is carried and pushed', () => {
    const world = new World({ gravity: G });
    world.addContactGenerator(new DiscContacts());
    const platform = world.addParticle({ x: 0, y: -5, radius: 5, mass: Infinity, friction: 1 });
    const rider = world.addParticle({ x: 0, y: 0.25, radius: 0.25, friction: 1 });
    run(world, 300);
    expect(rider.asleep).toBe(true);
    platform.vy = 1;
    run(world, 120);
    expect(rider.asleep).toBe(false);
    expect(rider.y).toBeCloseTo(2.25, 1);
  });

  it('[S18] a platform that comes along wakes what lies in its way', () => {
    const { world, column } = sleepers();
    world.addParticle({ x: -2, y: 0.25, vx: 1, radius: 0.25, mass: Infinity });
    run(world, 150);
    expect(column[0].x).toBeGreaterThan(0.5);
  });
});

describe('what touches asleep', () => {
  it('[S19] goes on touching: no event ends or begins', () => {
    const world = floorWorld();
    let begun = 0;
    let ended = 0;
    world.on('contactBegin', () => begun++);
    world.on('contactEnd', () => ended++);
    sleepers(world);
    expect([begun, ended]).toEqual([3, 0]);
    run(world, 300);
    expect([begun, ended]).toEqual([3, 0]);
  });

  it('[S19] ends when it wakes and parts', () => {
    const world = floorWorld();
    let ended = 0;
    world.on('contactEnd', () => ended++);
    const { column } = sleepers(world);
    run(world, 100);
    column[2].vy = 5;
    run(world, 10);
    expect(ended).toBe(1);
  });

  it('[S19] a sleeper is not passed by what is fast', () => {
    const world = new World();
    world.addContactGenerator(new DiscContacts());
    world.addShape(new Segment({ a: { x: 5, y: -5 }, b: { x: 5, y: 5 } }));
    const rests = world.addParticle({ x: 0, y: 0, radius: 0.05, mass: 100 });
    settle(world);
    const bullet = world.addParticle({ x: -6, y: 0, vx: 500, radius: 0.01, mass: 0.1 });
    run(world, 4);
    expect(rests.vx).toBeGreaterThan(0.4);
    expect(bullet.x).toBeLessThan(rests.x);
  });
});
