import { readdirSync, readFileSync } from 'node:fs';
import { Drag, Fireworks, FixedTimestep, Gravity, vec2, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { OwnSpring, run } from './helpers.ts';

describe('faults of the listings of the thesis: none may come back', () => {
  it('[M4] fault 1: vectors are copied, not shared: drag leaves the velocity that it reads alone', () => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0, vx: 3, vy: 4 });
    const dt = 2 ** -10;
    world.addForce(new Drag({ k1: 1 }));
    world.step(dt);
    // Had the force been the velocity itself, normalised in place, the speed would be 1.
    expect([particle.vx, particle.vy]).toEqual([3 - 3 * dt, 4 - 4 * dt]);
    const v = Object.freeze({ x: 3, y: 4 });
    expect(vec2.normalise(v)).toEqual({ x: 0.6, y: 0.8 });
    expect(v).toEqual({ x: 3, y: 4 });
  });

  it('[P1] fault 1: one start position for many particles is copied into each', () => {
    const world = new World({ gravity: { x: 0, y: -10 } });
    const start = { x: 1, y: 2 };
    const [a, b] = [world.addParticle(start), world.addParticle(start)];
    a.x = 50;
    run(world, 10);
    expect([b.x, start.x, start.y]).toEqual([1, 1, 2]);
    expect(a.y).toBe(b.y);
  });

  it('[F12] fault 5: a zero vector is not normalised to NaN: drag at rest, a spring without length', () => {
    const world = new World();
    const a = world.addParticle({ x: 1, y: 1 });
    const b = world.addParticle({ x: 1, y: 1 });
    world.addForce(new Drag({ k1: 1, k2: 1 }));
    world.addForce(new OwnSpring(a, b, 100, 1));
    run(world, 10);
    expect([a.x, a.y, b.x, b.y]).toEqual([1, 1, 1, 1]);
    expect(vec2.normalise({ x: 0, y: 0 })).toEqual({ x: 0, y: 0 });
  });

  it('[F10] fault 6: gravity leaves an infinite mass where it is, and does not divide by its inverse', () => {
    const world = new World();
    const pin = world.addParticle({ x: 1, y: 2, mass: Infinity });
    const loose = world.addParticle({ x: 0, y: 0, mass: 5 });
    world.addForce(new Gravity({ x: 0, y: -10 }));
    let greatest = 0;
    world.addForce({ apply: ({ fx, fy }) => void (greatest = Math.max(greatest, Math.abs(fx[0]), Math.abs(fy[0]))) });
    run(world, 10, 0.1);
    expect([pin.x, pin.y, greatest]).toEqual([1, 2, 0]);
    expect(loose.vy).toBeCloseTo(-10, 12);
  });

  it('[E6] fault 7: fireworks that end with the same step are all removed, and all burst', () => {
    const still = { minVelocity: { x: 0, y: 0 }, maxVelocity: { x: 0, y: 0 }, damping: 1 };
    const world = new World();
    const fireworks = world.addEffect(
      new Fireworks({
        rules: [
          { type: 1, minAge: 0.1, maxAge: 0.1, ...still, payloads: [{ type: 2, count: 1 }] },
          { type: 2, minAge: 0.1, maxAge: 0.1, ...still },
        ],
      }),
    );
    for (let i = 0; i < 100; i++) fireworks.launch(1);
    world.step(0.1);
    expect([fireworks.bursts, world.particleCount]).toEqual([100, 100]);
    world.step(0.1);
    expect(world.particleCount).toBe(0);
  });

  it('[T2] fault 10: a frame of any length reaches the integrator as equal steps, a negative one not at all', () => {
    const durations = new Set<number>();
    const clock = new FixedTimestep();
    for (const elapsed of [0.004, 0.1, 3, 0.017, 0]) clock.advance(elapsed, (dt) => void durations.add(dt));
    expect([...durations]).toEqual([1 / 60]);
    expect(() => clock.advance(-0.01, () => {})).toThrow(RangeError);
    expect(() => new World().step(-0.01)).toThrow(RangeError);
  });

  it('[P1] fault 11: the physics knows no renderer: no file of it names one, or the view', () => {
    const root = new URL('../src/', import.meta.url);
    const files = readdirSync(root, { recursive: true, encoding: 'utf8' })
      .map((file) => file.replaceAll('\\', '/'))
      .filter((file) => file.endsWith('.ts') && !file.startsWith('view/'));
    expect(files.length).toBeGreaterThan(20);
    for (const file of files) {
      const source = readFileSync(new URL(file, root), 'utf8');
      expect([
        file,
        /from '[^']*(view|canvas|pixi)[^']*'|\b(document|window|CanvasRenderingContext2D)\b\./.test(source),
      ]).toEqual([file, false]);
    }
  });
});
