import {
  aggregate,
  box,
  cable,
  Disc,
  type End,
  Fireworks,
  HalfPlane,
  type LinkPlan,
  rod,
  Springs,
  severity,
  Wind,
  World,
} from '@mass/core';
import { expect, it } from 'vitest';

// What the thesis names as the reach of particles and links, each built from what the core offers.

const gravity = { x: 0, y: -9.81 };

function run(world: World, seconds: number): void {
  for (let step = Math.round(seconds * 60); step > 0; step--) world.step(1 / 60);
}

it('a flag: cables in a grid, one edge of it on a pole, fly with the wind and keep their lengths', () => {
  const world = new World({ gravity, resolver: severity({ iterations: 2000 }) });
  const columns = 5;
  const rows = 4;
  const links: LinkPlan[] = [];
  for (let place = 0; place < columns * rows; place++) {
    const join = (a: End, b: End) => cable(a, b);
    if (place % columns > 0) links.push({ a: place - 1, b: place, join });
    if (place >= columns) links.push({ a: place - columns, b: place, join });
  }
  const particles = Array.from({ length: columns * rows }, (_, place) => ({
    x: (place % columns) * 0.2,
    y: Math.floor(place / columns) * 0.2,
    mass: place % columns === 0 ? Infinity : 0.01,
  }));
  const flag = world.addBody(aggregate({ kind: 'flag', closed: false, particles, links }));
  world.addForce(new Wind({ velocity: { x: -9, y: 0 }, k1: 0.05 }));
  run(world, 6);
  for (const [place, { x }] of flag.particles.entries()) if (place % columns > 0) expect(x).toBeLessThan(0);
  for (const link of world.links as ReturnType<typeof cable>[]) expect(link.strain).toBeLessThan(0.05);
});

it('cloth: springs in a grid, hung by two corners, sag and come to rest', () => {
  const world = new World({ gravity });
  const springs = world.addForce(new Springs());
  const side = 6;
  const corners = [0, side - 1];
  const knots = Array.from({ length: side * side }, (_, n) =>
    world.addParticle({
      x: (n % side) * 0.25,
      y: 3 - Math.floor(n / side) * 0.25,
      mass: corners.includes(n) ? Infinity : 0.05,
      damping: 0.3,
    }),
  );
  for (const [n, knot] of knots.entries()) {
    if (n % side > 0) springs.add(knots[n - 1], knot, { stiffness: 60, damping: 0.2 });
    if (n >= side) springs.add(knots[n - side], knot, { stiffness: 60, damping: 0.2 });
  }
  run(world, 20);
  expect(knots[3].y).toBeLessThan(2.95);
  expect(knots[side * side - 3].y).toBeLessThan(1.75);
  for (const { vx, vy } of knots) expect(Math.hypot(vx, vy)).toBeLessThan(0.02);
});

it('a soft blob: a ring of springs with spokes gives way when it lands, and is round again', () => {
  const world = new World({ gravity });
  world.addShape(new HalfPlane());
  const springs = world.addForce(new Springs());
  const middle = world.addParticle({ x: 0, y: 3, mass: 0.2, damping: 0.6 });
  const rim = Array.from({ length: 12 }, (_, n) =>
    world.addParticle({
      ...{ mass: 0.1, radius: 0.05, damping: 0.6 },
      x: Math.cos((n / 6) * Math.PI),
      y: 3 + Math.sin((n / 6) * Math.PI),
    }),
  );
  for (const [n, knot] of rim.entries()) {
    springs.add(middle, knot, { stiffness: 40, damping: 0.6 });
    for (const skip of [1, 2, 3]) springs.add(knot, rim[(n + skip) % 12], { stiffness: 40, damping: 0.6 });
  }
  const height = (): number => Math.max(...rim.map(({ y }) => y)) - Math.min(...rim.map(({ y }) => y));
  let flattest = 2;
  for (let step = 0; step < 900; step++) {
    world.step(1 / 60);
    flattest = Math.min(flattest, height());
  }
  expect(flattest).toBeLessThan(1.7);
  expect(height()).toBeGreaterThan(flattest + 0.1);
});

it('smoke and splashes: fireworks whose rules rise, spread and fade, or fall back', () => {
  const world = new World({ gravity });
  const spread = { minVelocity: { x: -0.5, y: 0 }, maxVelocity: { x: 0.5, y: 1 } };
  const smoke = { type: 1, minAge: 2, maxAge: 3, damping: 0.4, acceleration: { x: 0, y: 11 }, ...spread };
  const drop = { type: 2, minAge: 2, maxAge: 3, damping: 0.9, ...spread };
  const effect = world.addEffect(new Fireworks({ rules: [smoke, drop] }));
  for (let n = 0; n < 50; n++) {
    effect.launch(1, { x: 0, y: 0 });
    effect.launch(2, { x: 0, y: 0 });
  }
  run(world, 1.5);
  const { count, group, y } = world.particles;
  for (let i = 0; i < count; i++) {
    if (group[i] === 1) expect(y[i]).toBeGreaterThan(0.2);
    else expect(y[i]).toBeLessThan(-2);
  }
  run(world, 2);
  expect(world.particleCount).toBe(0);
});

it('a destructible wall: boxes of brittle rods break where they are hit, and others stand', () => {
  const world = new World({ resolver: severity({ iterations: 500 }) });
  const walls = [0, 3].map((y) =>
    world.addBody(box({ x: 0, y, width: 0.5, height: 2, mass: 4, radius: 0.25, breakForce: 400 })),
  );
  const broken: unknown[] = [];
  world.on('linkBroke', ({ link }) => broken.push(link));
  const ball = world.addParticle({ x: -3, y: 0.8, vx: 25, mass: 3, radius: 0.3 });
  world.addContactGenerator({
    addContacts({ x, y, radius }, contacts) {
      for (const { slot } of walls[0].particles) {
        const dx = x[slot] - x[ball.slot];
        const dy = y[slot] - y[ball.slot];
        const distance = Math.hypot(dx, dy);
        const depth = radius[slot] + radius[ball.slot] - distance;
        if (depth > 0) contacts.add(slot, ball.slot, dx / distance, dy / distance, depth, 0);
      }
    },
  });
  run(world, 1);
  expect(broken.length).toBeGreaterThan(0);
  expect(walls[0].links.length).toBe(6 - broken.length);
  expect(walls[1].links.length).toBe(6);
});

it('a pendulum clamp: what swings is held where it is by a rod, and goes on when it is let go', () => {
  const world = new World({ gravity });
  const bob = world.addParticle({ x: 1, y: 2, radius: 0.1 });
  world.addLink(rod({ x: 0, y: 3 }, bob));
  const clamp = world.addLink(rod({ x: 2, y: 2 }, bob));
  run(world, 2);
  expect(Math.hypot(bob.x - 1, bob.y - 2)).toBeLessThan(0.001);
  world.removeLink(clamp);
  run(world, 0.4);
  expect(bob.x).toBeLessThan(0.8);
});

it('walls and borders: what is inside a room stays inside', () => {
  const world = new World({ gravity });
  for (const [x, y] of [
    [0, 1],
    [0, -1],
    [1, 0],
    [-1, 0],
  ]) {
    world.addShape(new HalfPlane({ point: { x: -2 * x, y: -2 * y }, normal: { x, y }, restitution: 0.9 }));
  }
  world.addShape(new Disc({ centre: { x: 0, y: 0 }, radius: 0.5, restitution: 0.9 }));
  const balls = [1, 2, 3].map((n) => world.addParticle({ x: -1, y: 0.5 * n - 1, vx: 3 * n, vy: n, radius: 0.1 }));
  for (let step = 0; step < 600; step++) {
    world.step(1 / 60);
    for (const { x, y } of balls) {
      expect(Math.max(Math.abs(x), Math.abs(y))).toBeLessThan(1.95);
      expect(Math.hypot(x, y)).toBeGreaterThan(0.5);
    }
  }
});
