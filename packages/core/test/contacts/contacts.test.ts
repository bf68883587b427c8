import {
  type ContactEvent,
  type ContactGenerator,
  type Contacts,
  contactKeeper,
  Disc,
  DiscContacts,
  HalfPlane,
  type Particle,
  rod,
  type Shape,
  severity,
  shapeFinder,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { failsUnchanged, run } from '../helpers.ts';

const DT = 1 / 60;

/** Contacts of a moment, each as [a, b]. */
function pairsOf({ contacts }: World): number[][] {
  return Array.from({ length: contacts.count }, (_, c) => [contacts.a[c], contacts.b[c]]);
}

describe("a game's own contacts", () => {
  it('[C8] hooked arcs: a contact with the normal opposite to hat(a - b) keeps the two from separating', () => {
    class Hook implements ContactGenerator {
      constructor(a: Particle, b: Particle, length: number) {
        this.addContacts = ({ x, y }, contacts) => {
          const dx = x[b.slot] - x[a.slot];
          const dy = y[b.slot] - y[a.slot];
          const distance = Math.sqrt(dx * dx + dy * dy);
          if (distance > length) contacts.add(a.slot, b.slot, dx / distance, dy / distance, distance - length, 0.5);
        };
      }
      addContacts: ContactGenerator['addContacts'];
    }
    const world = new World({ resolver: severity() });
    const a = world.addParticle({ x: 0, y: 0, vx: -2, mass: 1 });
    const b = world.addParticle({ x: 1, y: 0, vx: 1, mass: 3 });
    world.addContactGenerator(new Hook(a, b, 1));
    world.step(DT);
    expect(b.vx - a.vx).toBeCloseTo(-1.5, 12); // they parted at 3 m/s and come back at half of that
    expect(a.vx + 3 * b.vx).toBeCloseTo(1, 12);
    expect(b.x - a.x).toBeCloseTo(1, 12);
  });

  it("[C8] where a game's own alone finds contacts it names what keeps them, under substep", () => {
    const floor = (named: Pick<ContactGenerator, 'keeper'>): ContactGenerator => ({
      ...named,
      addContacts({ count, y, radius }, contacts) {
        for (let i = 0; i < count; i++) if (y[i] < radius[i]) contacts.add(i, -1, 0, 1, radius[i] - y[i], 0);
      },
    });
    const world = new World({ gravity: { x: 0, y: -9.81 } });
    const disc = world.addParticle({ x: 0, y: 0.1, radius: 0.1 });
    const first = world.addContactGenerator(floor({}));
    expect(failsUnchanged(world, () => world.step(DT)).message).toBe(
      'World.step: what finds contacts must name what keeps them; nothing does. Give it { keeper: contactKeeper }.',
    );
    world.removeContactGenerator(first);
    world.addContactGenerator(floor({ keeper: contactKeeper }));
    run(world, 60, DT);
    expect(disc.y).toBeCloseTo(0.1, 2);
  });

  it('[C8] a generator and a shape in a dozen lines take part in the step', () => {
    const ceiling: ContactGenerator = {
      addContacts({ count, y, radius }, contacts) {
        for (let i = 0; i < count; i++) {
          if (y[i] + radius[i] > 2) contacts.add(i, -1, 0, -1, y[i] + radius[i] - 2, 1);
        }
      },
    };
    const slope: Shape = {
      finder: shapeFinder,
      restitution: 0,
      minX: -Infinity,
      minY: -Infinity,
      maxX: Infinity,
      maxY: Infinity,
      findSurface: (x, y, reach, surface) => {
        const distance = (x + y) * Math.SQRT1_2;
        if (distance < reach) surface.add(distance, Math.SQRT1_2, Math.SQRT1_2);
      },
    };
    const world = new World({ resolver: severity() });
    world.addContactGenerator(ceiling);
    world.addShape(slope);
    const up = world.addParticle({ x: 5, y: 1.9, vy: 3, radius: 0.1 });
    const down = world.addParticle({ x: 0.1, y: 0, vx: -1, radius: 0.1 });
    world.step(DT);
    expect(up.vy).toBe(-3);
    expect(up.y).toBeCloseTo(1.9, 12);
    expect(down.vx).toBeCloseTo(-0.5, 12);
    expect(down.vy).toBeCloseTo(0.5, 12);
  });

  it.each<[string, (contacts: Contacts) => void, string]>([
    ['a penetration that is NaN', (contacts) => contacts.add(0, 1, 1, 0, NaN, 0), 'penetration'],
    ['a normal that is NaN', (contacts) => contacts.add(0, 1, NaN, 0, 0, 0), 'normal'],
    ['a normal that is no unit vector', (contacts) => contacts.add(0, 1, 1, 1, 0, 0), 'normal'],
    ['a restitution above 1', (contacts) => contacts.add(0, 1, 1, 0, 0, 1.5), 'restitution'],
    ['a slot that no particle has', (contacts) => contacts.add(0, 7, 1, 0, 0, 0), 'slot'],
    ['a particle with itself', (contacts) => contacts.add(1, 1, 1, 0, 0, 0), 'slot'],
  ])('[C9] %s is an error that leaves the world as it was', (_, add, part) => {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -9.81 } });
    world.addParticle({ x: 0, y: 0, vx: 1 }).applyForce(1, 2);
    world.addParticle({ x: 1, y: 0 });
    const wrong = world.addContactGenerator({ addContacts: (_particles, contacts) => add(contacts) });
    expect(failsUnchanged(world, () => world.step(DT)).message).toMatch(new RegExp(`Contacts.add.*${part}`));
    world.removeContactGenerator(wrong);
    world.step(DT);
  });

  it.each([
    [NaN, 0, 1, 'distance'],
    [0, NaN, 1, 'normal'],
    [0, 1, 1, 'normal'],
  ])('[C9] a shape that reports (%d, %d, %d) is an error that leaves the world as it was', (distance, nx, ny, part) => {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -9.81 } });
    world.addParticle({ x: 0, y: 0, radius: 0.1 });
    const bounds = { minX: -1, minY: -1, maxX: 1, maxY: 1, finder: shapeFinder };
    world.addShape({ ...bounds, restitution: 0, findSurface: (_x, _y, _reach, to) => to.add(distance, nx, ny) });
    expect(failsUnchanged(world, () => world.step(DT)).message).toMatch(part);
  });

  it('[C9] where a position is not finite the error names the particle, not the contact', () => {
    const world = new World({ resolver: severity() });
    world.addContactGenerator(new DiscContacts());
    world.addParticle({ x: 0, y: 0, radius: 1 });
    const lost = world.addParticle({ x: 0.5, y: 0, radius: 1 });
    world.particles.vx[lost.slot] = NaN;
    expect(failsUnchanged(world, () => world.step(DT)).message).toMatch('particle 1 came to (NaN');
  });
});

describe('which contacts there are', () => {
  it('[C10] links come first, then shapes, then generators, each in the order of addition, discs by the lower slot', () => {
    const world = new World({ resolver: severity() });
    world.addContactGenerator({ addContacts: (_, contacts) => contacts.add(3, -1, 0, 1, -1, 0) });
    world.addContactGenerator(new DiscContacts());
    const discs = [0, 1, 2, 3].map((i) => world.addParticle({ x: i * 0.19, y: 0.1, radius: 0.1 }));
    world.addShape(new Disc({ centre: { x: 0, y: -1 }, radius: 1 }));
    world.addShape(new HalfPlane());
    world.addLink(rod(discs[3], discs[0]));
    world.step(DT);
    expect(pairsOf(world)).toEqual([[3, 0], [3, 0], [0, -1], [0, -1], [1, -1], [2, -1], [3, -1], [3, -1], [0, 1], [1, 2], [2, 3]]); // biome-ignore format: one line
  });

  it('[C10] particles that a link joins do not collide, until the link goes', () => {
    const world = new World({ resolver: severity() });
    world.addContactGenerator(new DiscContacts());
    const a = world.addParticle({ x: 0, y: 0, radius: 1 });
    const b = world.addParticle({ x: 1, y: 0, radius: 1 });
    const link = world.addLink(rod(a, b));
    run(world, 3);
    expect(b.x - a.x).toBe(1);
    world.removeLink(link);
    run(world, 3);
    expect(b.x - a.x).toBeCloseTo(2, 9);
  });

  it('[C10] a pair is found once, whatever its cell of the grid, also far from the middle of the world', () => {
    for (const [cx, cy] of [
      [0, 0],
      [-100, 100],
      [12345.6, -98765.4],
    ]) {
      // biome-ignore format: one line
      const world = new World({ resolver: severity() });
      world.addContactGenerator(new DiscContacts());
      const discs: { x: number; y: number; radius: number }[] = [];
      for (let i = 0; i < 200; i++) {
        const at = { x: cx + ((i * 37) % 100) * 0.05, y: cy + ((i * 61) % 90) * 0.05, radius: 0.05 + (i % 7) * 0.02 };
        discs.push(at);
        world.addParticle({ ...at, mass: 1 });
      }
      const expected: number[][] = [];
      for (let i = 0; i < 200; i++) {
        for (let j = i + 1; j < 200; j++) {
          const reach = (discs[i].radius + discs[j].radius) * 1.01;
          if (Math.hypot(discs[i].x - discs[j].x, discs[i].y - discs[j].y) < reach) expected.push([i, j]);
        }
      }
      world.step(1e-9);
      expect(pairsOf(world).toSorted((p, q) => p[0] - q[0] || p[1] - q[1])).toEqual(expected);
    }
  });

  it('[C10] a few discs much larger than the others are found with all that they touch, in the same order', () => {
    const world = new World({ resolver: severity() });
    world.addContactGenerator(new DiscContacts());
    const discs = Array.from({ length: 300 }, (_, i) => ({
      x: ((i * 37) % 100) * 0.1,
      y: ((i * 61) % 90) * 0.1,
      radius: i % 100 === 50 ? 3 : i % 9 === 0 ? 0 : 0.1,
    }));
    for (const disc of discs) world.addParticle({ ...disc });
    const expected: number[][] = [];
    for (let i = 0; i < 300; i++) {
      for (let j = i + 1; j < 300; j++) {
        const [a, b] = [discs[i], discs[j]];
        if (a.radius > 0 && b.radius > 0 && Math.hypot(a.x - b.x, a.y - b.y) < (a.radius + b.radius) * 1.01) {
          expected.push([i, j]);
        }
      }
    }
    world.step(1e-9);
    const found = pairsOf(world);
    expect(found.toSorted((p, q) => p[0] - q[0] || p[1] - q[1])).toEqual(expected);
    expect(found.map(([i]) => i)).toEqual(found.map(([i]) => i).toSorted((p, q) => p - q));
  });

  it('[C11] at the limit the rest is left out, and counted', () => {
    const world = new World({ resolver: severity(), contactLimit: 2 });
    world.addContactGenerator(new DiscContacts());
    for (let i = 0; i < 5; i++) world.addParticle({ x: i * 0.15, y: 0, radius: 0.1 });
    world.step(DT);
    expect([world.contacts.count, world.contacts.leftOut]).toEqual([2, 2]);
    for (const particle of [0, 1, 2]) world.particleAt(particle).x += 10 * particle;
    world.step(DT);
    expect([world.contacts.count, world.contacts.leftOut]).toEqual([1, 0]);
  });
});

describe('events', () => {
  /** What a world tells, as text. */
  function record(world: World): string[] {
    const told: string[] = [];
    const name = ({ a, b }: ContactEvent) => `${a.slot}-${b?.slot ?? 'scenery'}`;
    world.on('contactBegin', (event) => told.push(`begin ${name(event)}`));
    world.on('contactEnd', (event) => told.push(`end ${name(event)}`));
    return told;
  }

  it('[C12] a bounce is one begin, with how hard it was, and one end', () => {
    const world = new World({ resolver: severity() });
    const floor = world.addShape(new HalfPlane({ restitution: 0.5 }));
    const ball = world.addParticle({ x: 0, y: 0.15, vy: -3, radius: 0.1, mass: 2 });
    const began: ContactEvent[] = [];
    world.on('contactBegin', (event) => began.push(event));
    const told = record(world);
    run(world, 20);
    expect(told).toEqual(['begin 0-scenery', 'end 0-scenery']);
    const { a, b, source, normalX, normalY, impulse } = began[0];
    expect([a, b, source, normalX, normalY]).toEqual([ball, undefined, floor, 0, 1]);
    expect(impulse).toBeCloseTo(9, 12); // 2 kg from -3 to 1.5 m/s
  });

  it('[C12] what rests begins once and does not end', () => {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -9.81 } });
    world.addShape(new HalfPlane({ restitution: 0.5 }));
    world.addContactGenerator(new DiscContacts());
    world.addParticle({ x: 0, y: 0.1, radius: 0.1 });
    world.addParticle({ x: 0, y: 0.3, radius: 0.1 });
    const told = record(world);
    run(world, 600);
    expect(told).toEqual(['begin 0-scenery', 'begin 0-1']);
  });

  it('[C12] all that began comes before all that ended, each in the order in which it was found', () => {
    const world = new World({ resolver: severity() });
    world.addContactGenerator(new DiscContacts());
    world.addParticle({ x: 0, y: 0, radius: 0.1 });
    const left = world.addParticle({ x: 0.2, y: 0, radius: 0.1 });
    world.addParticle({ x: 5, y: 0, radius: 0.1 });
    const right = world.addParticle({ x: 5.2, y: 0, radius: 0.1 });
    const told = record(world);
    world.step(DT);
    [left.x, right.x] = [5.2, 0.2];
    world.step(DT);
    expect(told).toEqual(['begin 0-1', 'begin 2-3', 'begin 0-3', 'begin 1-2', 'end 0-1', 'end 2-3']);
  });

  it('[C12] particles can be removed in a listener: the contact ends in the next step, once', () => {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -9.81 } });
    world.addShape(new HalfPlane());
    world.addContactGenerator(new DiscContacts());
    for (let i = 0; i < 4; i++) world.addParticle({ x: i * 0.19, y: 0.1, radius: 0.1 });
    const told = record(world);
    world.on('contactBegin', ({ a, b }) => {
      for (const particle of [a, b]) if (particle?.alive && particle.slot % 2 === 0) particle.remove();
    });
    world.step(DT);
    const begun = told.splice(0).map((line) => line.replace('begin', 'end'));
    expect(begun).toHaveLength(7);
    world.step(DT);
    const stays = (line: string) => line === 'end 1-scenery' || line === 'end 3-scenery';
    expect(told.splice(0).sort()).toEqual(begun.filter((line) => !stays(line)).sort());
    run(world, 5);
    expect(told).toEqual([]);
  });

  it('[C12] a new particle in the slot of a removed one begins anew, and the old one ends', () => {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -9.81 } });
    world.addShape(new HalfPlane());
    const old = world.addParticle({ x: 0, y: 0.1, radius: 0.1 });
    const told: string[] = [];
    world.on('contactBegin', ({ a }) => told.push(`begin ${a === old ? 'old' : 'new'}`));
    world.on('contactEnd', ({ a }) => told.push(`end ${a === old ? 'old' : 'new'}`));
    world.step(DT);
    old.remove();
    expect(world.addParticle({ x: 1, y: 0.1, radius: 0.1 }).slot).toBe(old.slot);
    run(world, 3);
    expect(told).toEqual(['begin old', 'begin new', 'end old']);
  });

  it('[C12] links are not contacts in this sense', () => {
    const world = new World({ resolver: severity() });
    const a = world.addParticle({ x: 0, y: 0 });
    world.addLink(rod(a, { x: 1, y: 0 }));
    const told = record(world);
    run(world, 5);
    expect(world.contacts.count).toBe(2);
    expect(told).toEqual([]);
  });
});
