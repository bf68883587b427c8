import { type ContactEvent, DiscContacts, HalfPlane, impact, rod, severity, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { failsUnchanged } from '../../helpers.ts';
import { gas, impactWorld, pile } from './scenes.ts';

describe('contacts and events', () => {
  it('[I26] an impact is a contact of the step, with its normal and impulse, and begins and ends once', () => {
    const world = impactWorld();
    const wall = world.addShape(new HalfPlane({ normal: { x: -1, y: 0 }, point: { x: 1, y: 0 }, restitution: 1 }));
    const a = world.addParticle({ x: 0, y: 0, vx: 6, mass: 2, radius: 0.1, restitution: 1 });
    const b = world.addParticle({ x: 0.5, y: 0, mass: 2, radius: 0.1, restitution: 1 });
    const told: string[] = [];
    const events: ContactEvent[] = [];
    world.on('contactBegin', (event) => {
      told.push(event.b === undefined ? 'wall' : 'discs');
      events.push(event);
    });
    world.on('contactEnd', (event) => told.push(event.b === undefined ? 'wall ends' : 'discs end'));
    world.step(0.1); // a hits b after 0.05 s
    expect(told).toEqual(['discs']);
    expect([events[0].a, events[0].b]).toEqual([a, b]);
    expect([events[0].normalX, events[0].normalY]).toEqual([-1, 0]);
    expect(events[0].impulse).toBeCloseTo(12, 12);
    world.step(0.05); // b hits the wall after 0.0667 s of its way
    expect(told).toEqual(['discs', 'wall', 'discs end']);
    expect(events[1].source).toBe(wall);
    expect(events[1].a).toBe(b);
    expect(events[1].impulse).toBeCloseTo(24, 12);
  });

  it('[I26] a contact that lasts begins once; several impacts of one pair in a step are one contact', () => {
    const world = new World({ resolver: impact(), gravity: { x: 0, y: -9.81 } });
    world.addShape(new HalfPlane({ restitution: 0.5 }));
    world.addParticle({ x: 0, y: 0.12, radius: 0.1 });
    let begun = 0;
    let ended = 0;
    world.on('contactBegin', () => begun++);
    world.on('contactEnd', () => ended++);
    world.step(1); // falls, bounces and comes to rest
    expect([begun, world.contacts.count]).toEqual([1, 1]);
    for (let step = 0; step < 60; step++) world.step(1 / 60);
    expect([begun, ended]).toEqual([1, 0]);
  });

  it('[I26] the limit of a world on contacts is one on what is reported, not on what is resolved', () => {
    const world = new World({ resolver: impact(), contactLimit: 1 });
    world.addContactGenerator(new DiscContacts());
    for (let i = 0; i < 4; i++) {
      world.addParticle({ x: i, y: 0, vx: i % 2 === 0 ? 10 : -10, radius: 0.1, restitution: 1 });
    }
    world.step(0.06);
    expect([world.contacts.count, world.contacts.leftOut]).toEqual([1, 1]);
    expect(Array.from(world.particles.vx.subarray(0, 4), Math.round)).toEqual([-10, 10, -10, 10]);
  });

  it('[I20] a link breaks by the force that it has to hold', () => {
    const world = new World({ resolver: impact(), gravity: { x: 0, y: -9.81 } });
    const bob = world.addParticle({ x: 0, y: -1, mass: 2 });
    const link = world.addLink(rod(bob, { x: 0, y: 0 }, { breakForce: 25 }));
    let broke = 0;
    world.on('linkBroke', () => broke++);
    for (let step = 0; step < 60; step++) world.step(1 / 60);
    expect(world.links).toEqual([link]); // 19.6 N
    world.addForce({ apply: ({ fy }) => void (fy[bob.slot] -= 10) });
    world.step(1 / 60);
    expect([broke, world.links.length]).toEqual([1, 0]);
  });

  it("[I20] a game's own contact generator takes part", () => {
    const world = new World({ resolver: impact(), gravity: { x: 0, y: -9.81 } });
    const ball = world.addParticle({ x: 0, y: 1 });
    world.addContactGenerator({
      addContacts: ({ y }, contacts) => {
        if (y[ball.slot] < 0.5) contacts.add(ball.slot, -1, 0, 1, 0.5 - y[ball.slot], 0); // a floor at 0.5 m
      },
    });
    for (let step = 0; step < 60; step++) world.step(1 / 60);
    expect(ball.y).toBeGreaterThan(0.4999);
    expect(ball.y).toBeLessThan(0.51);
  });
});

it('[I27] a scene changes its resolver by one word', () => {
  for (const resolver of [severity(), impact()]) {
    const world = new World({ resolver, gravity: { x: 0, y: -9.81 } });
    world.addContactGenerator(new DiscContacts());
    world.addShape(new HalfPlane());
    const a = world.addParticle({ x: 0, y: 0.5, radius: 0.1 });
    const b = world.addParticle({ x: 1, y: 0.5, radius: 0.1 });
    world.addLink(rod(a, b));
    for (let step = 0; step < 120; step++) world.step(1 / 60);
    expect(a.y).toBeCloseTo(0.1, 3);
    expect(b.x - a.x).toBeCloseTo(1, 6);
  }
});

describe('a step that fails', () => {
  it('[I28] by a force that is not finite leaves the world as it was, and says so', () => {
    const world = gas(10, 1);
    for (let step = 0; step < 10; step++) world.step(1 / 60);
    const force = world.addForce({ apply: ({ fx }) => void (fx[3] = Number.NaN) });
    const error = failsUnchanged(world, () => world.step(1 / 60));
    expect(error.message).toMatch(/force must be a finite number of newtons/);
    world.removeForce(force);
    world.step(1 / 60);
  });

  it("[I28] by an error in a game's own shape or generator, or by a position that is not finite, too", () => {
    const world = pile(5, 0.5, 1);
    for (let step = 0; step < 30; step++) world.step(1 / 60);
    const generator = world.addContactGenerator({
      addContacts() {
        throw new Error('mine');
      },
    });
    expect(failsUnchanged(world, () => world.step(1 / 60)).message).toBe('mine');
    world.removeContactGenerator(generator);
    world.particles.vx[2] = Infinity;
    expect(failsUnchanged(world, () => world.step(1 / 60)).message).toMatch(/particle 2/);
    world.particles.vx[2] = 1e300;
    expect(() => world.step(1 / 60)).not.toThrow(); // finite, however far
  });
});
