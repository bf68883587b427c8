import { Drag, Fireworks, forEachParticle, Gravity, Random, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { hashOf, OwnSpring, run } from '../helpers.ts';

/** A bit of everything, by a seed. */
function mixedWorld(seed: number): { world: World; advance: () => void } {
  const random = new Random(seed);
  const world = new World({ gravity: { x: 0.3, y: -9.81 }, capacity: 16 });
  const particles = Array.from({ length: 150 }, (_, i) =>
    world.addParticle({
      x: random.between(-20, 20),
      y: random.between(0, 20),
      vx: random.between(-5, 5),
      vy: random.between(-5, 5),
      mass: i % 10 === 0 ? Infinity : random.between(0.1, 10),
      damping: i % 3 === 0 ? 1 : random.between(0.1, 1),
      ax: i % 7 === 0 ? random.between(-2, 2) : 0,
      lifetime: i % 4 === 0 ? random.between(0.5, 6) : Infinity,
    }),
  );
  world.addForce(new Drag({ k1: 0.05, k2: 0.01 }));
  world.addForce(new Gravity({ x: 1, y: 2 }), particles.slice(20, 60));
  world.addForce(forEachParticle((p, dt) => p.applyForce(Math.sqrt(p.mass > 1e9 ? 0 : p.mass) * dt, -p.y)));
  for (let i = 61; i < 80; i += 2) {
    if (particles[i].mass < Infinity) world.addForce(new OwnSpring(particles[i], { x: 0, y: 5 }, 30, 2));
  }
  for (let i = 61; i < 80; i += 2) particles[i].lifetime = Infinity;
  const spark = {
    type: 2,
    minAge: 0.3,
    maxAge: 1,
    minVelocity: { x: -5, y: -5 },
    maxVelocity: { x: 5, y: 5 },
    damping: 0.5,
  };
  const rocket = { ...spark, type: 1, payloads: [{ type: 2, count: 12 }], acceleration: { x: 0, y: 3 } };
  const fireworks = world.addEffect(new Fireworks({ rules: [rocket, spark], seed }));
  const advance = () => {
    if (world.stepCount % 10 === 0) fireworks.launch(1);
    if (world.stepCount % 25 === 24) {
      const particle = particles[random.integer(81, 149)];
      if (particle.alive) particle.remove();
      world.addParticle({ x: random.between(-1, 1), y: 0, damping: 0.3 });
    }
    world.step(1 / 60);
  };
  return { world, advance };
}

describe('determinism', () => {
  it('[D1] the same calls give the same bits', () => {
    const hashes = [1, 2].map(() => {
      const { world, advance } = mixedWorld(7);
      for (let i = 0; i < 400; i++) advance();
      return hashOf(world);
    });
    expect(hashes[0]).toBe(hashes[1]);
  });

  it('[D1] another seed gives others', () => {
    const hashes = [7, 8].map((seed) => {
      const { world, advance } = mixedWorld(seed);
      for (let i = 0; i < 50; i++) advance();
      return hashOf(world);
    });
    expect(hashes[0]).not.toBe(hashes[1]);
  });

  it('[D3] two worlds that are stepped in turns are as when each is stepped alone', () => {
    const alone = [3, 4].map((seed) => {
      const { world, advance } = mixedWorld(seed);
      for (let i = 0; i < 200; i++) advance();
      return hashOf(world);
    });
    const [a, b] = [3, 4].map(mixedWorld);
    for (let i = 0; i < 200; i++) {
      a.advance();
      b.advance();
    }
    expect([hashOf(a.world), hashOf(b.world)]).toEqual(alone);
  });

  it('[D4] golden: the mixed world after 400 steps, on every machine and in every engine', () => {
    const { world, advance } = mixedWorld(2012);
    for (let i = 0; i < 400; i++) advance();
    expect({ particles: world.particleCount, hash: hashOf(world) }).toMatchInlineSnapshot(`
      {
        "hash": "b381a4d2",
        "particles": 188,
      }
    `);
  });

  it('[D4] golden: a damped shot after 10 s', () => {
    const world = new World({ gravity: { x: 0, y: -9.81 } });
    const shot = world.addParticle({ x: 0, y: 0, vx: 20, vy: 15, damping: 0.99 });
    run(world, 600);
    expect([shot.x, shot.y, shot.vx, shot.vy]).toMatchInlineSnapshot(`
      [
        190.26213320547825,
        -332.5137517346146,
        18.087641500175536,
        -79.75784521215503,
      ]
    `);
  });
});
