import { type ForceGenerator, type ForceTargets, type Particle, type ParticleArrays, Random, World } from '@mass/core';
import { expect } from 'vitest';

/** Everything that a world shows of itself, array by array, so that two states can be compared bit for bit. */
export function snapshot(world: World): Record<string, unknown> {
  const { particles } = world;
  const state: Record<string, unknown> = {
    time: world.time,
    stepCount: world.stepCount,
    particleCount: world.particleCount,
    count: particles.count,
    gravity: { ...world.gravity },
  };
  const { ax, ay, damping } = particles;
  for (const [name, array] of Object.entries({ ...particles, ax, ay, damping })) {
    if (ArrayBuffer.isView(array)) state[name] = Array.from(array as Float64Array);
  }
  return state;
}

/** Runs what must throw; the world must be as before, bit for bit. Returns the error. */
export function failsUnchanged(world: World, act: () => void): Error {
  const before = snapshot(world);
  const error = thrownBy(act);
  expect(snapshot(world)).toEqual(before);
  return error;
}

/** The error that something throws. */
export function thrownBy(act: () => void): Error {
  try {
    act();
  } catch (error) {
    if (error instanceof Error) return error;
    throw new Error(`not an Error was thrown: ${String(error)}`);
  }
  throw new Error('nothing was thrown');
}

/** FNV-1a over the bytes of the arrays that make up the state of motion: one number that any changed bit changes. */
export function hashOf(world: World): string {
  const { x, y, previousX, previousY, vx, vy, fx, fy, lifetime, count } = world.particles;
  let hash = 0x811c9dc5;
  for (const array of [x, y, previousX, previousY, vx, vy, fx, fy, lifetime]) {
    for (const byte of new Uint8Array(array.buffer, 0, count * 8)) hash = Math.imul(hash ^ byte, 0x01000193) >>> 0;
  }
  return hash.toString(16).padStart(8, '0');
}

/** Takes `count` steps of one length. */
export function run(world: World, count: number, dt: number = 1 / 60): void {
  for (let i = 0; i < count; i++) world.step(dt);
}

/** A spring as a game would write it: over the arrays, between a particle and another or a fixed point. */
export class OwnSpring implements ForceGenerator {
  readonly #a: Particle;
  readonly #b: Particle | { readonly x: number; readonly y: number };
  readonly #stiffness: number;
  readonly #rest: number;

  constructor(a: Particle, b: Particle | { x: number; y: number }, stiffness: number, rest: number = 0) {
    this.#a = a;
    this.#b = b;
    this.#stiffness = stiffness;
    this.#rest = rest;
  }

  apply({ fx, fy }: ParticleArrays): void {
    const a = this.#a;
    const b = this.#b;
    const dx = a.x - b.x;
    const dy = a.y - b.y;
    const length = Math.sqrt(dx * dx + dy * dy);
    if (length === 0) return;
    const pull = (-this.#stiffness * (length - this.#rest)) / length;
    fx[a.slot] += pull * dx;
    fy[a.slot] += pull * dy;
    if (!('slot' in b)) return;
    fx[b.slot] -= pull * dx;
    fy[b.slot] -= pull * dy;
  }
}

/** A generator that records the slots it is run on, and pushes each with a force. */
export class Recorder implements ForceGenerator {
  readonly runs: number[][] = [];
  force: number;

  constructor(force: number = 0) {
    this.force = force;
  }

  apply({ fx }: ParticleArrays, { slots, count }: ForceTargets): void {
    this.runs.push(Array.from(slots.subarray(0, count)));
    for (let t = 0; t < count; t++) fx[slots[t]] += this.force;
  }

  /** The slots of the last run. */
  get last(): number[] {
    return this.runs[this.runs.length - 1];
  }
}

/** A world of particles at random places with random velocities and masses, all by a seed. */
export function randomWorld(count: number, seed: number, gravity: { x: number; y: number } = { x: 0, y: 0 }): World {
  const random = new Random(seed);
  const world = new World({ gravity });
  for (let i = 0; i < count; i++) {
    world.addParticle({
      x: random.between(-50, 50),
      y: random.between(0, 50),
      vx: random.between(-10, 10),
      vy: random.between(-10, 10),
      mass: random.between(0.1, 10),
    });
  }
  return world;
}
