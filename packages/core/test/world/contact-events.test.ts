import {
  Box,
  type ContactEvent,
  type ContactGenerator,
  contactKeeper,
  HalfPlane,
  impact,
  Random,
  Segment,
  severity,
  substep,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../helpers.ts';

const DT = 1 / 60;
const EARTH = { x: 0, y: -9.81 };

/** Notes what a world tells of contacts: '+' and '-' with the slots of the two, -1 for scenery. */
function heard(world: World): string[] {
  const notes: string[] = [];
  world.on('contactBegin', ({ a, b }) => notes.push(`+${a.slot},${b?.slot ?? -1}`));
  world.on('contactEnd', ({ a, b }) => notes.push(`-${a.slot},${b?.slot ?? -1}`));
  return notes;
}

describe('sensors', () => {
  it.each([severity, substep, impact])(
    '[C28] a shape that is one tells who comes and goes, and pushes nothing',
    (make) => {
      const world = new World({ gravity: EARTH, resolver: make() });
      const sensor = world.addShape(new Box({ centre: { x: 0, y: 0 }, width: 2, height: 1, sensor: true }));
      const free = new World({ gravity: EARTH, resolver: make() });
      free.addShape(new HalfPlane({ point: { x: 0, y: -1000 } }));
      const events: ContactEvent[] = [];
      world.on('contactBegin', (event) => events.push(event));
      const notes = heard(world);
      const disc = world.addParticle({ x: 0, y: 3, radius: 0.1 });
      const ghost = free.addParticle({ x: 0, y: 3, radius: 0.1 });
      for (let step = 0; step < 90; step++) {
        world.step(DT);
        free.step(DT);
        expect(disc.y).toBe(ghost.y);
        expect(world.contacts.count).toBe(0);
      }
      expect(notes).toEqual(['+0,-1', '-0,-1']);
      expect(events[0]).toMatchObject({ a: disc, b: undefined, source: sensor, normalX: 0, normalY: 1, impulse: 0 });
    },
  );

  it.each([severity, substep, impact])('[C28] a particle that is one falls through a floor and tells of it', (make) => {
    const world = new World({ gravity: EARTH, resolver: make() });
    world.addShape(new HalfPlane());
    const notes = heard(world);
    const disc = world.addParticle({ x: 0, y: 0.3, radius: 0.1, sensor: true });
    run(world, 60, DT);
    expect(disc.y).toBeLessThan(-3);
    expect(notes).toEqual(['+0,-1']);
    disc.sensor = false;
    world.step(DT);
    expect(world.contacts.count).toBe(1);
    expect(notes).toEqual(['+0,-1']);
  });

  it('[C28] a thin one is noticed by what passes it within a step, and not by what a wall stops before', () => {
    const world = new World({ resolver: substep() });
    world.addShape(new Segment({ a: { x: 1, y: -1 }, b: { x: 1, y: 1 }, sensor: true }));
    world.addShape(new Segment({ a: { x: 2, y: -1 }, b: { x: 2, y: 1 } }));
    world.addShape(new Segment({ a: { x: 3, y: -1 }, b: { x: 3, y: 1 }, sensor: true }));
    const notes = heard(world);
    const sources: unknown[] = [];
    world.on('contactBegin', ({ source }) => sources.push(source));
    world.addParticle({ x: 0, y: 0, vx: 400, radius: 0.1 });
    world.step(DT);
    expect(sources).toEqual([world.shapes[1], world.shapes[0]]);
    world.step(DT);
    expect(notes).toEqual(['+0,-1', '+0,-1', '-0,-1']);
  });

  it('[C28] a generator of the game tells of a sensor by addSensor', () => {
    const near: ContactGenerator = {
      keeper: contactKeeper,
      addContacts({ count, x }, contacts) {
        for (let i = 1; i < count; i++) if (Math.abs(x[i] - x[0]) < 1) contacts.addSensor(i, 0, 1, 0);
      },
    };
    const world = new World({ resolver: substep() });
    world.addContactGenerator(near);
    const notes = heard(world);
    world.addParticle({ x: 0, y: 0 });
    const passer = world.addParticle({ x: 1.99, y: 0, vx: -1 });
    run(world, 240, DT);
    expect(passer.vx).toBe(-1);
    expect(notes).toEqual(['+1,0', '-1,0']);
  });
});

describe('events', () => {
  it('[C29] what was only looked for ahead does not begin: a near miss is not told, a hit is, with its impulse', () => {
    const world = new World({ resolver: substep() });
    world.addShape(new Segment({ a: { x: 0, y: 0 }, b: { x: 0, y: 2 } }));
    const events: ContactEvent[] = [];
    world.on('contactBegin', (event) => events.push(event));
    world.addParticle({ x: -1, y: -0.11, vx: 200, radius: 0.1 });
    world.addParticle({ x: -1, y: 1, vx: 50, radius: 0.1 });
    world.step(DT);
    expect(events).toHaveLength(0);
    run(world, 2, DT);
    expect(events).toHaveLength(1);
    expect(events[0].impulse).toBeCloseTo(50, 0);
  });

  it('[C29] what sleeps goes on touching: no end while it sleeps, one when it is gone', () => {
    const world = new World({ gravity: EARTH, resolver: substep() });
    world.addShape(new HalfPlane());
    const notes = heard(world);
    const disc = world.addParticle({ x: 0, y: 0.1, radius: 0.1 });
    run(world, 600, DT);
    expect(disc.asleep).toBe(true);
    expect(notes).toEqual(['+0,-1']);
    disc.remove();
    world.step(DT);
    expect(notes).toEqual(['+0,-1', '-0,-1']);
  });

  it('[C12] in a crowd each is told as a plain comparison of lists has it, in order', () => {
    const random = new Random(6);
    let pairs: [number, number][] = [];
    const world = new World({ resolver: severity() });
    const crowd: ContactGenerator = {
      addContacts(_, contacts) {
        for (const [a, b] of pairs) contacts.add(a, b, 0, 1, 0, 0);
      },
    };
    world.addContactGenerator(crowd);
    const particles = Array.from({ length: 60 }, (_, i) => world.addParticle({ x: i, y: 0, mass: Infinity }));
    const notes = heard(world);
    let touching: [string, string][] = [];
    for (let step = 0; step < 200; step++) {
      const key = (a: number, b: number) =>
        `${Math.max(a, b)}:${world.generationAt(Math.max(a, b))} ${Math.min(a, b)}:${b < 0 ? 0 : world.generationAt(Math.min(a, b))}`;
      if (step % 7 === 3) {
        const slot = random.integer(0, 59);
        particles[slot].remove();
        particles[slot] = world.addParticle({ x: slot, y: 0, mass: Infinity });
      }
      pairs = Array.from({ length: random.integer(0, 300) }, (): [number, number] => {
        const a = random.integer(0, 59);
        const b = random.integer(-1, 59);
        return [a, b === a ? -1 : b];
      });
      const now = new Map(pairs.map(([a, b]) => [key(a, b), `${a},${b}`]));
      for (const [a, b] of pairs.toReversed()) now.set(key(a, b), `${a},${b}`); // the first of equal ones is told
      const known = new Map(touching);
      const began = [...now].filter(([pair]) => !known.has(pair));
      const ended = touching.filter(([pair]) => !now.has(pair));
      notes.length = 0;
      world.step(DT);
      expect(notes).toEqual([...began.map(([, text]) => `+${text}`), ...ended.map(([, text]) => `-${text}`)]);
      touching = [...touching.filter(([pair]) => now.has(pair)), ...began];
    }
  });
});
