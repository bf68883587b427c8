/**
 * Counts the bytes that steps allocate, in a process of its own: `node --expose-gc --min-semi-space-size=… allocation-run.ts
 * <scene>`. The young generation is so large that nothing is collected while it counts, so what the heap gained is what was
 * allocated. Prints one line of JSON.
 */
import { getHeapStatistics } from 'node:v8';
import {
  Box,
  cable,
  DiscContacts,
  Drag,
  type End,
  Fireworks,
  FixedTimestep,
  type ForceGenerator,
  forEachParticle,
  HalfPlane,
  rod,
  Segment,
  World,
} from '@mass/core';

const COUNT = 10_000;
const STEPS = 1000;
const ROUNDS = 16;

/** A force of the game's own, over the arrays: a wind that grows with the height. */
const wind: ForceGenerator = {
  apply({ y, fx }, { slots, count }) {
    for (let t = 0; t < count; t++) fx[slots[t]] += 0.01 * y[slots[t]];
  },
};

function crowd(count: number): World {
  const world = new World({ gravity: { x: 0, y: -9.81 }, capacity: count });
  for (let i = 0; i < count; i++) {
    world.addParticle({ x: i, y: i % 100, vx: (i % 7) - 3, mass: 1 + (i % 3), damping: i < count / 2 ? 0.9 : 0.99 });
  }
  return world;
}

const scenes: Record<string, () => () => void> = {
  flight() {
    const world = crowd(COUNT);
    world.addForce(new Drag({ k1: 0.1, k2: 0.01 }));
    world.addForce(wind);
    return () => world.step(1 / 60);
  },
  dampings() {
    const world = crowd(COUNT);
    const { damping } = world.particles;
    for (let i = 0; i < COUNT; i++) damping[i] = 0.5 + (i / COUNT) * 0.4;
    return () => world.step(1 / 60);
  },
  particles() {
    const world = crowd(COUNT / 10);
    world.addForce(forEachParticle((particle) => particle.applyForce(-0.1 * particle.vx, -0.1 * particle.vy)));
    const clock = new FixedTimestep();
    const takeStep = (dt: number) => world.step(dt);
    return () => void clock.advance(1 / 60, takeStep);
  },
  links() {
    const world = new World({ gravity: { x: 0, y: -9.81 } });
    let previous: End = { x: 0, y: 0 };
    for (let i = 1; i <= 100; i++) {
      const bead = world.addParticle({ x: i * 0.1, y: 0 });
      world.addLink(i % 2 === 0 ? rod(previous, bead) : cable(previous, bead));
      previous = bead;
    }
    return () => world.step(1 / 60);
  },
  contacts() {
    const world = new World({ gravity: { x: 0, y: -9.81 } });
    world.addShape(new HalfPlane());
    world.addShape(new Box({ centre: { x: 3, y: 1 }, width: 1, height: 1 }));
    world.addShape(new Segment({ a: { x: 5, y: 1 }, b: { x: 7, y: 1 } }));
    world.addContactGenerator(new DiscContacts());
    for (let i = 0; i < 200; i++) world.addParticle({ x: (i % 20) * 0.5, y: 3 + i * 0.1, radius: 0.1 });
    world.on('contactBegin', () => {});
    return () => world.step(1 / 60);
  },
  fireworks() {
    const still = { minVelocity: { x: -9, y: -9 }, maxVelocity: { x: 9, y: 9 }, damping: 0.5 };
    const world = new World({ gravity: { x: 0, y: -9.81 }, capacity: COUNT });
    const spark = { type: 2, minAge: 1, maxAge: 2, ...still };
    const rocket = { type: 1, minAge: 0.5, maxAge: 1, ...still, payloads: [{ type: 2, count: 50 }] };
    const fireworks = world.addEffect(new Fireworks({ rules: [rocket, spark] }));
    return () => {
      fireworks.launch(1);
      fireworks.launch(1);
      world.step(1 / 60);
    };
  },
};

/** What a number of steps allocates. */
function count(step: () => void): { bytesPerStep: number; bufferBytes: number } {
  globalThis.gc?.();
  const before = getHeapStatistics();
  for (let i = 0; i < STEPS; i++) step();
  const after = getHeapStatistics();
  return {
    bytesPerStep: (after.used_heap_size - before.used_heap_size) / STEPS,
    bufferBytes: after.external_memory - before.external_memory,
  };
}

// How long V8 warms up depends on how busy the machine is: the round that allocates least is one after the warm-up.
const step = scenes[process.argv[2]]();
const rounds = Array.from({ length: ROUNDS }, () => count(step));
console.log(JSON.stringify(rounds.reduce((least, round) => (round.bytesPerStep < least.bytesPerStep ? round : least))));
