import {
  box,
  cable,
  chain,
  Disc,
  DiscContacts,
  EdgeContacts,
  explicitEuler,
  HalfPlane,
  type Particle,
  Polygon,
  Polyline,
  Random,
  type Resolver,
  rod,
  Segment,
  severity,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { hashOf, run } from '../../helpers.ts';
import { PlainSeverity } from './plain-severity.ts';

/** A crowd in a box of all kinds of shapes, with rods and cables between some, some pinned, by a seed. */
function crowd(seed: number, resolver: Resolver): World {
  const random = new Random(seed);
  const integrator = random.next() < 0.3 ? { integrator: explicitEuler } : {};
  const world = new World({ gravity: { x: random.between(-3, 3), y: -9.81 }, resolver, ...integrator });
  const restitution = random.next() < 0.5 ? 0 : random.next();
  const particles: Particle[] = [];
  for (let i = 0; i < random.integer(2, 60); i++) {
    const mass = random.next() < 0.1 ? Infinity : random.between(0.01, 100);
    const [x, y, radius] = [random.between(-1.5, 1.5), random.between(0, 3), random.between(0, 0.3)];
    const [vx, vy] = mass === Infinity ? [0, 0] : [random.between(-9, 9), random.between(-9, 9)];
    particles.push(world.addParticle({ x, y, vx, vy, mass, radius, restitution }));
  }
  for (let i = 0; i < random.integer(0, 20); i++) {
    const a = particles[random.integer(0, particles.length - 1)];
    const b = particles[random.integer(0, particles.length - 1)];
    if (a === b) continue;
    if (random.next() < 0.2) world.addLink(rod(a, { x: random.between(-1, 1), y: 2 }));
    else world.addLink(random.next() < 0.5 ? rod(a, b) : cable(a, b, { restitution }));
  }
  world.addContactGenerator(new DiscContacts());
  world.addShape(new HalfPlane({ restitution: random.next() }));
  world.addShape(new Segment({ a: { x: -1.5, y: 0 }, b: { x: -2, y: 3 }, thickness: 0.1 }));
  world.addShape(new Disc({ centre: { x: 0, y: 1 }, radius: 0.5, restitution }));
  world.addShape(new Polygon({ points: [{ x: 1, y: 0 }, { x: 2, y: 0 }, { x: 1.4, y: 0.5 }, { x: 2, y: 3 }, { x: 1, y: 3 }] })); // biome-ignore format: one line
  world.addShape(new Polyline({ points: [{ x: -2, y: 0.5 }, { x: -1, y: 0.2 }, { x: 0, y: 0.5 }] })); // biome-ignore format: one line
  return world;
}

/** Both take the same steps; returns what the plain one used of its limit in the last. */
function compare(build: (resolver: Resolver) => World, steps: number, iterations?: number): PlainSeverity {
  const plainResolver = new PlainSeverity(iterations);
  const plain = build(plainResolver);
  const real = build(severity(iterations === undefined ? {} : { iterations }));
  for (let s = 0; s < steps; s++) {
    run(plain, 1);
    run(real, 1);
    expect(hashOf(real)).toBe(hashOf(plain));
    const count = real.contacts.count;
    expect(count).toBe(plain.contacts.count);
    expect(real.contacts.impulse.subarray(0, count)).toEqual(plain.contacts.impulse.subarray(0, count));
  }
  return plainResolver;
}

describe('the same as a plain resolver that looks at all contacts in each iteration, bit for bit', () => {
  it('[R3] in random crowds with links, shapes, pinned particles and masses of 1 : 10 000', () => {
    let used = 0;
    let ended = 0;
    for (let seed = 0; seed < 60; seed++) {
      const plain = compare((resolver) => crowd(seed, resolver), 20);
      const limit = crowdContacts(seed) * 2;
      if (plain.velocityIterations >= limit && limit > 0) used++;
      else ended++;
    }
    // Both ways to end were met.
    expect(used).toBeGreaterThan(5);
    expect(ended).toBeGreaterThan(5);
  });

  it.each([0, 1, 7, 100])('[R3] with a limit of %i', (iterations) => {
    for (let seed = 100; seed < 115; seed++) compare((resolver) => crowd(seed, resolver), 10, iterations);
  });

  it.each([undefined, 20, 300])(
    '[R3] in crowds of boxes, ropes and discs, whose edges collide, with a limit of %s',
    (iterations) => {
      let edges = 0;
      for (let seed = 0; seed < 12; seed++) {
        const build = (resolver: Resolver) => {
          const random = new Random(seed);
          const world = new World({ gravity: { x: 0, y: -9.81 }, resolver });
          world.addContactGenerator(new EdgeContacts(world));
          world.addContactGenerator(new DiscContacts());
          world.addShape(new HalfPlane());
          for (let n = 0; n < 14; n++) {
            const [x, y, radius] = [random.between(-1, 1), random.between(0.2, 1.5), random.between(0.01, 0.1)];
            const motion = { vx: random.between(-5, 5), vy: random.between(-5, 5), radius, restitution: random.next() };
            const mass = random.between(0.01, 100);
            if (n % 3 === 0) world.addBody(box({ x, y, width: 0.5, height: 0.3, angle: x, mass, ...motion }));
            else if (n % 3 === 1) world.addParticle({ x, y, mass: n === 1 ? Infinity : mass, ...motion });
            else world.addBody(chain({ from: { x, y }, to: { x: x + 0.5, y }, free: 'to', links: 4, mass, ...motion }));
          }
          return world;
        };
        compare(
          (resolver) => {
            const world = build(resolver);
            if (resolver.name === 'plain')
              world.addForce({
                apply: () => {
                  edges += world.contacts.edgeEnd.subarray(0, world.contacts.count).filter((end) => end >= 0).length;
                },
              });
            return world;
          },
          15,
          iterations,
        );
      }
      expect(edges).toBeGreaterThan(500);
    },
  );

  it('[R3] where many contacts are equally severe: the one found first goes first', () => {
    compare((resolver) => {
      const world = new World({ gravity: { x: 0, y: -10 }, resolver });
      world.addContactGenerator(new DiscContacts());
      world.addShape(new HalfPlane());
      for (let i = 0; i < 100; i++) {
        world.addParticle({ x: (i % 10) * 0.2, y: 0.09 + Math.floor(i / 10) * 0.2, vx: 0, vy: -1, radius: 0.1 });
      }
      return world;
    }, 60);
  });

  it('[R3] from one contact to a thousand: every size of the tree', () => {
    for (const count of [1, 2, 3, 4, 5, 15, 16, 17, 63, 64, 65, 255, 256, 257, 1000]) {
      compare((resolver) => {
        const random = new Random(count);
        const world = new World({ resolver });
        world.addContactGenerator(new DiscContacts());
        for (let i = 0; i <= count; i++) {
          const vx = random.between(-1, 1);
          world.addParticle({ x: i * 0.16, y: 0, vx, vy: random.between(-1, 1), radius: 0.1, restitution: 0.2 });
        }
        return world;
      }, 2);
    }
  });
});

function crowdContacts(seed: number): number {
  const world = crowd(seed, severity());
  run(world, 20);
  return world.contacts.count;
}
