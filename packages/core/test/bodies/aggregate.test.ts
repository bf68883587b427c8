import { aggregate, type BodyPlan, DistanceLink, rod, World } from '@mass/core';
import { expect, it } from 'vitest';

/** A builder as a game would write it: two balls on a rod, hung on a point by an elastic of the game's own. */
function dumbBell(x: number, y: number, length: number): BodyPlan {
  return aggregate({
    kind: 'dumb-bell',
    closed: false,
    particles: [
      { x: x - length / 2, y, mass: 2, radius: 0.2 },
      { x: x + length / 2, y, mass: 1, radius: 0.1, vy: 3 },
    ],
    links: [
      { a: 0, b: 1, join: rod },
      {
        a: 0,
        b: { x, y: y + 3 },
        join: (a, b) => new DistanceLink('strap', a, b, { kind: 'strap', minLength: 0, maxLength: 5 }),
      },
    ],
  });
}

it('[B1] a game builds bodies of its own, with unequal masses and links of any kind', () => {
  const world = new World();
  const body = world.addBody(dumbBell(0, 0, 3));
  expect(world.bodies).toEqual([body]);
  expect([body.kind, body.closed, body.mass, body.x, body.y]).toEqual(['dumb-bell', false, 3, -0.5, 0]);
  expect([body.vx, body.vy, body.inertia]).toEqual([0, 1, 2 + 4]);
  expect(body.angularVelocity).toBeCloseTo((1 * 2 * 2 + 2 * 1 * 1) / 6, 14);
  expect(world.links.map((link) => (link as DistanceLink).kind)).toEqual(['rod', 'strap']);
  world.step(1 / 60);
  expect(body.angle).toBeGreaterThan(0);
});

it('[B1] one plan is added many times, each a body of its own', () => {
  const world = new World();
  const plan = dumbBell(0, 0, 3);
  const [first, second] = [world.addBody(plan), world.addBody(plan)];
  first.remove();
  expect([world.bodies, world.particleCount, world.links.length]).toEqual([[second], 2, 2]);
});

it('[B2] a single particle has no inertia, and an impulse beside it moves it all the same', () => {
  const body = new World().addBody(aggregate({ kind: 'dot', particles: [{ x: 1, y: 2, mass: 2 }], links: [] }));
  body.applyImpulse(4, 0, 1, 7);
  expect([body.vx, body.inertia, body.angularVelocity, body.angle]).toEqual([2, 0, 0, 0]);
});
