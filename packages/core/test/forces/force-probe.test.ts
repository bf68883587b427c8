import { describe, expect, it } from 'vitest';
import { Drag, ForceProbe, Gravity, World } from '../../src/index.ts';

describe('ForceProbe', () => {
  it('remembers the sum of the forces before it, and adds none', () => {
    const run = (probe?: ForceProbe): number => {
      const world = new World({ gravity: { x: 1, y: 0 } });
      world.addForce(new Gravity({ x: 0, y: -10 }));
      world.addForce(new Drag({ k1: 0.5 }));
      if (probe) world.addForce(probe);
      const particle = world.addParticle({ x: 0, y: 0, mass: 2, vx: 3 });
      particle.applyForce(0, 1);
      world.step(0.1);
      return particle.x * 1e6 + particle.y;
    };
    const probe = new ForceProbe();
    expect(run(probe)).toBe(run());
    expect([probe.fx[0], probe.fy[0]]).toEqual([-1.5, -19]);
  });

  it('knows its own particles alone, and forgets what was', () => {
    const world = new World();
    const [a, b] = [0, 1].map((x) => world.addParticle({ x, y: 0 }));
    const probe = world.addForce(new ForceProbe(), [b]);
    a.applyForce(1, 0);
    b.applyForce(2, 0);
    world.step(0.1);
    expect([...probe.fx.subarray(0, 2)]).toEqual([0, 2]);
    world.step(0.1);
    expect([...probe.fx.subarray(0, 2)]).toEqual([0, 0]);
  });

  it('grows with the world', () => {
    const world = new World({ capacity: 1 });
    const probe = world.addForce(new ForceProbe());
    for (let n = 0; n < 200; n++) world.addParticle({ x: n, y: 0 }).applyForce(n, 0);
    world.step(0.1);
    expect(probe.fx[199]).toBe(199);
  });
});
