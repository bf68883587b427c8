import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { type Particle, World } from '@mass/core';

/** Takes steps until a time has passed, with a look at the world after each. */
export function run(world: World, seconds: number, dt: number, look: () => void = () => {}): void {
  const steps = Math.round(seconds / dt);
  for (let step = 0; step < steps; step++) {
    world.step(dt);
    look();
  }
}

/** Mean time between upward crossings of `middle`, with the crossing interpolated within its step. */
export function period(world: World, dt: number, swings: number, read: () => number, middle = 0): number {
  let first = Number.NaN;
  let last = Number.NaN;
  let crossings = 0;
  let before = read() - middle;
  while (crossings <= swings) {
    if (world.time > 1e5) throw new Error('it does not swing');
    world.step(dt);
    const after = read() - middle;
    if (before < 0 && after >= 0) {
      last = world.time - dt + (dt * before) / (before - after);
      if (crossings++ === 0) first = last;
    }
    before = after;
  }
  return (last - first) / swings;
}

/** What a step of next to no duration does to the velocity, as a force: the sum of the forces on a particle now. */
export function forceOn(world: World, particle: Particle): { x: number; y: number } {
  const { vx, vy, mass } = particle;
  const dt = 2 ** -40;
  world.step(dt);
  return { x: ((particle.vx - vx) * mass) / dt, y: ((particle.vy - vy) * mass) / dt };
}

export function momentum(particles: Iterable<Particle>): { x: number; y: number } {
  let x = 0;
  let y = 0;
  for (const { mass, vx, vy } of particles) {
    x += mass * vx;
    y += mass * vy;
  }
  return { x, y };
}

/**
 * Bytes that a step leaves on the heap after warm-up, beyond those of a world without forces. A number that crosses from
 * one function to another may take some; an object for each particle or spring would take thousands.
 */
export function garbagePerStep(world: World): number {
  return heapGrowth(world) - heapGrowth(new World());
}

function heapGrowth(world: World): number {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc') as () => void;
  const dt = 1 / 240;
  run(world, 3000 * dt, dt);
  let least = Infinity;
  for (let attempt = 0; attempt < 3; attempt++) {
    collect();
    const before = process.memoryUsage().heapUsed;
    run(world, 2000 * dt, dt);
    least = Math.min(least, (process.memoryUsage().heapUsed - before) / 2000);
  }
  return least;
}
