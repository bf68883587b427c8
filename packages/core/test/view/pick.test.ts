import { describe, expect, it } from 'vitest';
import { Buoyancy, box, World } from '../../src/index.ts';
import { pickParticle } from '../../src/view/index.ts';

describe('pickParticle', () => {
  it('finds the nearest within reach, and nothing beyond', () => {
    const world = new World();
    const a = world.addParticle({ x: 0, y: 0 });
    const b = world.addParticle({ x: 1, y: 0 });
    expect(pickParticle(world, 0.4, 0, 1)).toBe(a);
    expect(pickParticle(world, 0.6, 0, 1)).toBe(b);
    expect(pickParticle(world, 0.5, 2, 1)).toBeUndefined();
  });

  it('measures from the edge of the disc', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0 });
    const large = world.addParticle({ x: 3, y: 0, radius: 2 });
    expect(pickParticle(world, 1.2, 0, 0)).toBe(large);
    expect(pickParticle(world, 0.8, 0, 1)).toBe(large);
  });

  it('prefers the nearer centre where discs overlap', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0, radius: 5 });
    const small = world.addParticle({ x: 1, y: 0, radius: 0.5 });
    expect(pickParticle(world, 0.9, 0, 0)).toBe(small);
  });

  it('passes over the removed', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0 }).remove();
    const other = world.addParticle({ x: 1, y: 0 });
    other.remove();
    expect(pickParticle(world, 0, 0, 10)).toBeUndefined();
  });

  it('takes hold of a body by its nearest particle, of the one on top', () => {
    const world = new World();
    const under = world.addBody(box({ x: 0, y: 0, width: 4, height: 2 }));
    expect(pickParticle(world, 0.5, 0.3, 0)).toBe(under.particles[2]);
    expect(pickParticle(world, -1.9, -0.9, 0)).toBe(under.particles[0]);
    expect(pickParticle(world, 2.1, 0, 0)).toBeUndefined();
    const over = world.addBody(box({ x: 1, y: 0, width: 2, height: 2 }));
    expect(pickParticle(world, 0.5, 0.3, 0)).toBe(over.particles[3]);
    const free = world.addParticle({ x: 0.6, y: 0.3 });
    expect(pickParticle(world, 0.5, 0.3, 0.2)).toBe(free);
  });

  it('takes hold of a float by the box that is drawn', () => {
    const world = new World();
    const float = world.addParticle({ x: 1, y: 0 });
    world.addForce(new Buoyancy(), []).setHull(float, { volume: 2, maxDepth: 0.5 });
    expect(pickParticle(world, 1.9, 0.4, 0)).toBe(float);
    expect(pickParticle(world, 2.1, 0.4, 0)).toBeUndefined();
    float.remove();
    expect(pickParticle(world, 1.9, 0.4, 0)).toBeUndefined();
  });

  it('refuses a point that is none', () => {
    expect(() => pickParticle(new World(), Number.NaN, 0, 1)).toThrow('pickParticle: x must be a finite number');
    expect(() => pickParticle(new World(), 0, 0, -1)).toThrow(RangeError);
  });
});
