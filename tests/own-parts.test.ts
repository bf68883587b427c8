// What a game adds of its own takes part in a step as ours does: a force, a contact generator, a link, a dozen lines each.
import { type ContactGenerator, type ForceGenerator, impact, type Link, severity, World } from '@mass/core';
import { expect, it } from 'vitest';

const resolvers = [severity, impact];

it.each(resolvers)('a force of the game: a magnet that pulls towards a point, under %o', (resolver) => {
  const magnet: ForceGenerator = {
    apply({ x, y, fx, fy }, { slots, count }) {
      for (let t = 0; t < count; t++) {
        const i = slots[t];
        fx[i] -= 4 * x[i];
        fy[i] -= 4 * y[i];
      }
    },
  };
  const world = new World({ resolver: resolver() });
  const ball = world.addParticle({ x: 1, y: 0, mass: 4 });
  world.addForce(magnet, [ball]);
  for (let step = 0; step < 314; step++) world.step(0.01); // half a period of 2π
  expect(Math.abs(ball.x + 1)).toBeLessThan(0.01); // a force is found once a step: an error of the order of the step
});

it.each(resolvers)('a contact generator of the game: a round room, under %o', (resolver) => {
  const room: ContactGenerator = {
    addContacts({ count, alive, x, y, radius }, contacts) {
      for (let i = 0; i < count; i++) {
        const distance = Math.sqrt(x[i] * x[i] + y[i] * y[i]);
        const penetration = distance + radius[i] - 2;
        if (alive[i] === 1 && penetration > 0) {
          contacts.add(i, -1, -x[i] / distance, -y[i] / distance, penetration, 1);
        }
      }
    },
  };
  const world = new World({ resolver: resolver() });
  const ball = world.addParticle({ x: 0, y: 0, vx: 3, vy: 1, radius: 0.5 });
  world.addContactGenerator(room);
  let hits = 0;
  world.on('contactBegin', () => hits++);
  for (let step = 0; step < 600; step++) {
    world.step(1 / 60);
    expect(Math.hypot(ball.x, ball.y)).toBeLessThan(1.5 + 1e-6);
  }
  expect(hits).toBeGreaterThan(3);
  expect(Math.hypot(ball.vx, ball.vy)).toBeCloseTo(Math.sqrt(10), 9);
});

it.each(resolvers)('a link of the game: a leash that runs along a rail, under %o', (resolver) => {
  const world = new World({ gravity: { x: 0, y: -9.81 }, resolver: resolver() });
  const car = world.addParticle({ x: 0, y: 1, vx: 2 });
  const rail: Link = {
    a: car,
    b: { x: 0, y: 1 },
    addContacts({ y }, contacts) {
      contacts.add(car.slot, -1, 0, 1, 1 - y[car.slot], 0);
      contacts.add(car.slot, -1, 0, -1, y[car.slot] - 1, 0);
    },
  };
  world.addLink(rail);
  for (let step = 0; step < 60; step++) world.step(1 / 60);
  expect(car.x).toBeCloseTo(2, 9);
  expect(car.y).toBeCloseTo(1, 6);
  car.remove();
  expect(world.links).toEqual([]);
});
