import {
  cable,
  DiscContacts,
  type End,
  type Link,
  type Particle,
  type ParticleArrays,
  Random,
  rod,
  severity,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { failsUnchanged, hashOf, run, thrownBy } from '../helpers.ts';

const DT = 1 / 60;
const GRAVITY = { x: 0, y: -9.81 };

function distance(a: { x: number; y: number }, b: { x: number; y: number }): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

describe('a cable', () => {
  it('[L1] that is slack does nothing, bit for bit', () => {
    const worlds = [true, false].map((linked) => {
      const world = new World({ resolver: severity(), gravity: GRAVITY });
      const a = world.addParticle({ x: 0, y: 0, vx: 1 });
      const b = world.addParticle({ x: 1, y: 0, vx: -1, vy: 1 });
      if (linked) world.addLink(cable(a, b, { maxLength: 5 }));
      run(world, 60);
      return world;
    });
    expect(hashOf(worlds[0])).toBe(hashOf(worlds[1]));
    expect(worlds[0].contacts.count).toBe(0);
  });

  it.each([0, 0.3, 1])('[L1] that snaps taut at restitution %d gives back that share of the speed', (restitution) => {
    for (const [ma, mb] of [
      [1, 1],
      [1, 9],
      [1e4, 1],
      [2, Infinity],
    ]) {
      // biome-ignore format: one line
      const world = new World({ resolver: severity() });
      const a = world.addParticle({ x: 0, y: 0, mass: ma, vx: -4, vy: 3 });
      const b = world.addParticle({ x: 2, y: 0, mass: mb, vy: 3 });
      world.addLink(cable(a, b, { maxLength: 2, restitution }));
      world.step(DT);
      expect(b.vx - a.vx).toBeCloseTo(-4 * restitution, 11);
      expect([a.vy, b.vy]).toEqual([3, 3]);
      if (mb < Infinity) expect(Math.abs(ma * a.vx + mb * b.vx + 4 * ma)).toBeLessThan(1e-12 * 4 * (ma + mb));
      else expect(b.vx).toBe(0);
      expect(distance(a, b)).toBeLessThanOrEqual(2 + 1e-12);
    }
  });

  it('[L1] from a fixed point never gets longer than it is, and hangs straight down in the end', () => {
    const world = new World({ resolver: severity(), gravity: GRAVITY });
    const bob = world.addParticle({ x: 0.5, y: 4, damping: 0.5 });
    const link = world.addLink(cable({ x: 0, y: 4 }, bob, { maxLength: 1 }));
    for (let i = 0; i < 1200; i++) {
      world.step(DT);
      expect(link.length).toBeLessThan(1 + 1e-6);
    }
    expect(bob.x).toBeCloseTo(0, 3);
    expect(bob.y).toBeCloseTo(3, 3);
  });
});

describe('a rod', () => {
  it.each([-3, 3])('[L2] holds its length from both sides: pulled or pushed at %d m/s', (speed) => {
    for (const [ma, mb] of [
      [1, 1],
      [0.01, 100],
      [3, Infinity],
    ]) {
      // biome-ignore format: one line
      const world = new World({ resolver: severity() });
      const a = world.addParticle({ x: 0, y: 0, mass: ma });
      const b = world.addParticle({ x: 0.6, y: 0.8, mass: mb });
      world.addLink(rod(a, b));
      a.vx = speed;
      world.step(DT);
      expect(distance(a, b)).toBeCloseTo(1, 9);
      const [nx, ny] = [(b.x - a.x) / distance(a, b), (b.y - a.y) / distance(a, b)];
      expect((b.vx - a.vx) * nx + (b.vy - a.vy) * ny).toBeCloseTo(0, 9);
      if (mb < Infinity) {
        expect(Math.abs(ma * a.vx + mb * b.vx - ma * speed)).toBeLessThan(1e-12 * 3 * (ma + mb));
        expect(Math.abs(ma * a.vy + mb * b.vy)).toBeLessThan(1e-12 * 3 * (ma + mb));
      }
    }
  });

  it('[L2] offers both of its contacts each time, so that it does not vibrate: one at rest stays, bit for bit', () => {
    const world = new World({ resolver: severity() });
    const a = world.addParticle({ x: 0, y: 0 });
    world.addLink(rod(a, world.addParticle({ x: 0.3, y: 0.7 })));
    const before = hashOf(world);
    run(world, 100);
    expect(world.contacts.count).toBe(2);
    expect(hashOf(world)).toBe(before);
  });

  it('[L2] of a fixed point works whichever end the point is', () => {
    const ends: ((point: End, bob: Particle) => [End, End])[] = [
      (point, bob) => [point, bob],
      (point, bob) => [bob, point],
    ];
    const hashes = ends.map((order) => {
      const world = new World({ resolver: severity(), gravity: GRAVITY });
      const bob = world.addParticle({ x: 1, y: 0 });
      world.addLink(rod(...order({ x: 0, y: 0 }, bob)));
      run(world, 100);
      expect(Math.hypot(bob.x, bob.y)).toBeCloseTo(1, 8);
      return hashOf(world);
    });
    expect(hashes[0]).toBe(hashes[1]);
  });

  it('[L3] of length 0 is an error: ends on one place define no direction to hold', () => {
    const world = new World({ resolver: severity() });
    const a = world.addParticle({ x: 1, y: 1 });
    const b = world.addParticle({ x: 1, y: 1 });
    expect(() => rod(a, b)).toThrow(
      'rod: length must be a positive, finite number of metres; got 0. Ends on one place',
    );
    expect(() => rod(a, b, { length: 0 })).toThrow(RangeError);
  });

  it('[L3] whose ends came to one place pushes them apart again', () => {
    const world = new World({ resolver: severity() });
    const a = world.addParticle({ x: 0, y: 0 });
    const b = world.addParticle({ x: 1, y: 0 });
    world.addLink(rod(a, b));
    b.x = 0;
    world.step(DT);
    expect(distance(a, b)).toBeCloseTo(1, 9);
  });

  it('[L2] can be wound in', () => {
    const world = new World({ resolver: severity(), gravity: GRAVITY });
    const bob = world.addParticle({ x: 0, y: -2 });
    const link = world.addLink(rod({ x: 0, y: 0 }, bob));
    for (let length = 2; length > 0.5; length -= 0.01) {
      link.setLength(length, length);
      world.step(DT);
      expect(bob.y).toBeCloseTo(-length, 9);
    }
  });
});

describe('a link that breaks', () => {
  /** A weight on a rod of some strength, for a second. */
  function hang(mass: number, breaking: { breakForce?: number; breakStrain?: number }, iterations?: number) {
    const world = new World({ gravity: GRAVITY, resolver: severity(iterations === undefined ? {} : { iterations }) });
    const bob = world.addParticle({ x: 0, y: 3, mass });
    const link = world.addLink(rod({ x: 0, y: 4 }, bob, breaking));
    const broken: { link: Link; force: number; step: number }[] = [];
    world.on('linkBroke', (event) => broken.push({ ...event, step: world.stepCount }));
    run(world, 60);
    return { world, bob, link, broken };
  }

  it('[L4] by force: it holds what it can, and gives way to more, told once, with the force', () => {
    const holds = hang(2, { breakForce: 20 });
    expect(holds.broken).toEqual([]);
    expect(holds.bob.y).toBeCloseTo(3, 9);
    const breaks = hang(2.1, { breakForce: 20 });
    expect(breaks.broken).toHaveLength(1);
    expect(breaks.broken[0].link).toBe(breaks.link);
    expect(breaks.broken[0].force).toBeCloseTo(2.1 * 9.81, 9);
    expect(breaks.broken[0].step).toBe(1);
    expect(breaks.world.links).toEqual([]);
    expect(breaks.bob.vy).toBeCloseTo(-9.81 * (59 / 60), 9); // it fell from then on
  });

  it('[L4] by strain: when a step ends with it off its length by more than the share', () => {
    expect(hang(1, { breakStrain: 0.01 }).broken).toEqual([]);
    const breaks = hang(1, { breakStrain: 0.5 }, 0); // a resolver that does nothing lets it stretch
    expect(breaks.broken).toHaveLength(1);
    // It falls 0.5 m in n steps: n (n + 1) / 2 · g·dt² > 0.5.
    expect(breaks.broken[0].step).toBe(19);
    expect(breaks.world.links).toEqual([]);
  });

  it('[L4] of several the links break in their order, and the world can be changed on hearing of it', () => {
    const world = new World({ resolver: severity(), gravity: GRAVITY });
    const bobs = [0, 1, 2].map((x) => world.addParticle({ x, y: 0, mass: 10 }));
    const links = bobs.map((bob) => world.addLink(rod(bob, { x: bob.x, y: 1 }, { breakForce: 1 })));
    const told: Link[] = [];
    world.on('linkBroke', ({ link }) => {
      told.push(link);
      world.addLink(cable(link.a, link.b));
    });
    run(world, 3);
    expect(told).toEqual(links);
    expect(world.links).toHaveLength(3);
  });
});

describe('what hangs on a particle', () => {
  it('[L5] leaves with it, also when its slot is used again', () => {
    const world = new World({ resolver: severity() });
    world.addContactGenerator(new DiscContacts());
    const [a, b, c] = [0, 1, 2].map((x) => world.addParticle({ x, y: 0, radius: 0.6 }));
    const links = [rod(a, b), rod(b, c), rod(a, c)].map((link) => world.addLink(link));
    run(world, 2);
    expect(world.contacts.count).toBe(6);
    b.remove();
    const next = world.addParticle({ x: 1, y: 0, radius: 0.3 });
    expect(next.slot).toBe(b.slot);
    expect(world.links).toEqual([links[2]]);
    world.step(DT);
    // The newcomer touches nothing of what the old one was linked to: it is a disc among discs.
    expect(world.contacts.count).toBe(2);
    next.radius = 0.6;
    world.step(DT);
    expect(world.contacts.count).toBe(4);
    expect(() => world.removeLink(links[0])).toThrow('must be in the world');
  });

  it('[L5] and takes no other link with it', () => {
    const random = new Random(11);
    const world = new World({ resolver: severity() });
    const particles = Array.from({ length: 30 }, (_, i) => world.addParticle({ x: i, y: 0 }));
    let links: Link[] = [];
    for (let i = 0; i < 100; i++) {
      const a = particles[random.integer(0, 29)];
      const b = particles[random.integer(0, 29)];
      if (a !== b) links.push(world.addLink(cable(a, b)));
    }
    for (let i = 0; i < 20; i++) {
      const gone = particles.splice(random.integer(0, particles.length - 1), 1)[0];
      gone.remove();
      if (i % 3 === 0) particles.push(world.addParticle({ x: i, y: 5 }));
      links = links.filter(({ a, b }) => a !== gone && b !== gone);
      expect(world.links).toEqual(links);
      world.step(DT);
    }
  });
});

describe("a game's own link", () => {
  it('[L6] takes part in the step in a dozen lines', () => {
    class Rail implements Link {
      readonly a: Particle;
      readonly b: { x: number; y: number } = { x: 0, y: 2 };
      constructor(bead: Particle) {
        this.a = bead;
      }
      addContacts({ y }: ParticleArrays, contacts: Parameters<Link['addContacts']>[1]): void {
        contacts.add(this.a.slot, -1, 0, 1, this.b.y - y[this.a.slot], 0);
        contacts.add(this.a.slot, -1, 0, -1, y[this.a.slot] - this.b.y, 0);
      }
    }
    const world = new World({ resolver: severity(), gravity: GRAVITY });
    const bead = world.addParticle({ x: 0, y: 2, vx: 3 });
    world.addLink(new Rail(bead));
    run(world, 60);
    expect(bead.x).toBeCloseTo(3, 12);
    expect(bead.y).toBe(2);
    bead.remove();
    expect(world.links).toEqual([]);
  });

  it('[L6] that asks to break, breaks', () => {
    const world = new World({ resolver: severity() });
    const a = world.addParticle({ x: 0, y: 0 });
    let asked = 0;
    const b = { x: 0, y: 0 };
    world.addLink({
      a,
      b,
      addContacts: (_, contacts) => contacts.add(0, -1, 1, 0, 0, 0),
      breaksAt: () => ++asked === 3,
    });
    run(world, 5);
    expect(asked).toBe(3);
    expect(world.links).toEqual([]);
  });

  it('[L6] that fails leaves the world as it was', () => {
    const world = new World({ resolver: severity(), gravity: GRAVITY });
    const a = world.addParticle({ x: 0, y: 0, vx: 1 });
    const addContacts = () => {
      throw new Error('a mistake in the game');
    };
    world.addLink({ a, b: { x: 0, y: 0 }, addContacts });
    expect(failsUnchanged(world, () => world.step(DT)).message).toBe('a mistake in the game');
  });
});

describe('what makes no sense', () => {
  it('[L7] says what it is', () => {
    const world = new World({ resolver: severity() });
    const a = world.addParticle({ x: 0, y: 0 });
    const b = world.addParticle({ x: 1, y: 0 });
    const gone = world.addParticle({ x: 2, y: 0 });
    gone.remove();
    const cases: [() => unknown, string][] = [
      [() => rod(a, a), 'two different particles'],
      [() => rod({ x: 0, y: 0 }, { x: 1, y: 0 }), 'two different particles'],
      [() => rod(a, gone), 'removed'],
      [() => rod(a, b, { length: -1 }), 'rod: length'],
      [() => rod(a, b, { length: NaN }), 'rod: length'],
      [() => rod(a, null as never), 'rod: b must be a particle or a fixed point'],
      [() => cable(a, b, { maxLength: 0 }), 'cable: maxLength'],
      [() => cable(a, b, { restitution: 2 }), 'cable: restitution'],
      [() => cable(a, b, { breakForce: 0 }), 'cable: breakForce'],
      [() => rod(a, b).setLength(2, 1), 'DistanceLink.setLength'],
      [() => world.addLink({ addContacts: () => undefined } as unknown as Link), "World.addLink: the link's a"],
      [() => world.addLink(undefined as never), 'World.addLink'],
      [
        () => world.addLink(rod(new World({ resolver: severity() }).addParticle({ x: 0, y: 0 }), { x: 1, y: 1 })),
        'World.addLink',
      ],
    ];
    for (const [act, part] of cases) expect(thrownBy(act).message).toContain(part);
    const link = world.addLink(rod(a, b));
    expect(() => world.addLink(link)).toThrow('once');
  });
});
