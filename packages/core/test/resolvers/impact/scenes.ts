import { DiscContacts, HalfPlane, impact, type Particle, Random, World } from '@mass/core';

/** A world under the impact resolver, in which discs collide. */
export function impactWorld(gravityY = 0): World {
  const world = new World({ resolver: impact(), gravity: { x: 0, y: gravityY } });
  world.addContactGenerator(new DiscContacts());
  return world;
}

/** Four walls around 0 to width, 0 to height. */
export function addWalls(world: World, width: number, height: number, restitution: number): void {
  world.addShape(new HalfPlane({ normal: { x: 0, y: 1 }, restitution }));
  world.addShape(new HalfPlane({ normal: { x: 1, y: 0 }, restitution }));
  world.addShape(new HalfPlane({ point: { x: width, y: 0 }, normal: { x: -1, y: 0 }, restitution }));
  world.addShape(new HalfPlane({ point: { x: 0, y: height }, normal: { x: 0, y: -1 }, restitution }));
}

/** Discs of 0.1 m that fly about in a box of 2 m without losing energy. */
export function gas(count: number, seed: number): World {
  const random = new Random(seed);
  const world = impactWorld();
  addWalls(world, 2, 2, 1);
  for (let i = 0; i < count; i++) {
    world.addParticle({
      x: 0.2 + 0.4 * (i % 5),
      y: 0.2 + 0.4 * Math.floor(i / 5),
      vx: random.between(-3, 3),
      vy: random.between(-3, 3),
      mass: random.between(0.5, 5),
      radius: 0.1,
      restitution: 1,
    });
  }
  return world;
}

export const BALL = 0.028575;

/** A cue ball that flies at 15 racked balls. The first particle is the cue ball. */
export function breakShot(speed: number, restitution: number, offset = 0): { world: World; balls: Particle[] } {
  const world = impactWorld();
  addWalls(world, 2.54, 1.27, restitution);
  const ball = { radius: BALL, mass: 0.17, restitution };
  const balls = [world.addParticle({ x: 0.6, y: 0.635 + offset, vx: speed, ...ball })];
  for (let row = 0; row < 5; row++) {
    for (let k = 0; k <= row; k++) {
      const y = 0.635 + (k - row / 2) * 2 * BALL;
      balls.push(world.addParticle({ x: 1.8 + row * BALL * Math.sqrt(3), y, ...ball }));
    }
  }
  return { world, balls };
}

/** Discs dropped into a box, on one another. */
export function pile(count: number, restitution: number, seed: number): World {
  const random = new Random(seed);
  const world = impactWorld(-9.81);
  addWalls(world, 2, 100, restitution);
  for (let i = 0; i < count; i++) {
    const x = 0.15 + 0.3 * (i % 6) + random.between(0, 0.05);
    world.addParticle({ x, y: 0.3 + 0.4 * Math.floor(i / 6), radius: 0.1, restitution });
  }
  return world;
}

/** Kinetic energy and that of the world's gravity. Unit: J. */
export function energyOf({ particles: p, gravity }: World): number {
  let sum = 0;
  for (let i = 0; i < p.count; i++) {
    if (p.inverseMass[i] === 0) continue;
    sum += p.mass[i] * ((p.vx[i] ** 2 + p.vy[i] ** 2) / 2 - gravity.x * p.x[i] - gravity.y * p.y[i]);
  }
  return sum;
}

export function momentumOf({ particles: p }: World): { x: number; y: number } {
  let x = 0;
  let y = 0;
  for (let i = 0; i < p.count; i++) {
    if (p.inverseMass[i] === 0) continue;
    x += p.mass[i] * p.vx[i];
    y += p.mass[i] * p.vy[i];
  }
  return { x, y };
}

/** How deep any disc is in another, or in one of the walls of `addWalls`, as a share of its radius. */
export function worstOverlap({ particles: p }: World, width = Infinity, height = Infinity): number {
  let worst = 0;
  for (let i = 0; i < p.count; i++) {
    const r = p.radius[i];
    const inWalls = Math.max(r - p.x[i], r - p.y[i], p.x[i] + r - width, p.y[i] + r - height);
    if (width < Infinity) worst = Math.max(worst, inWalls / r);
    for (let j = 0; j < i; j++) {
      const distance = Math.sqrt((p.x[i] - p.x[j]) ** 2 + (p.y[i] - p.y[j]) ** 2);
      worst = Math.max(worst, (r + p.radius[j] - distance) / Math.min(r, p.radius[j]));
    }
  }
  return worst;
}
