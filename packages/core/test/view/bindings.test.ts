import { describe, expect, it } from 'vitest';
import { type Particle, World } from '../../src/index.ts';
import { Bindings } from '../../src/view/index.ts';

describe('Bindings', () => {
  const drawn = (bindings: Bindings<string>): string[] => {
    const all: string[] = [];
    bindings.forEach((drawing) => void all.push(drawing));
    return all;
  };

  it('marks the slots of bound particles', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0 });
    const particle = world.addParticle({ x: 0, y: 0 });
    const bindings = new Bindings<string>('Test');
    bindings.bind(particle, 'a');
    bindings.prune(world.particles);
    expect([...bindings.bound.subarray(0, 2)]).toEqual([0, 1]);
    bindings.unbind(particle);
    expect(bindings.bound[1]).toBe(0);
  });

  it('lets go of the removed, and leaves the next particle of the slot alone', () => {
    const world = new World();
    const released: string[] = [];
    const bindings = new Bindings<string>('Test', (drawing) => released.push(drawing));
    const first = world.addParticle({ x: 0, y: 0 });
    bindings.bind(first, 'first');
    first.remove();
    const second = world.addParticle({ x: 0, y: 0 });
    expect(second.slot).toBe(first.slot);
    bindings.prune(world.particles);
    expect(released).toEqual(['first']);
    expect(bindings.bound[second.slot]).toBe(0);
    bindings.bind(second, 'second');
    bindings.prune(world.particles);
    expect(drawn(bindings)).toEqual(['second']);
    expect(bindings.bound[second.slot]).toBe(1);
  });

  it('lets go of the particles of another world', () => {
    const bindings = new Bindings<string>('Test');
    bindings.bind(new World().addParticle({ x: 0, y: 0 }), 'elsewhere');
    const world = new World();
    world.addParticle({ x: 0, y: 0 });
    bindings.prune(world.particles);
    expect(drawn(bindings)).toEqual([]);
    expect(bindings.bound[0]).toBe(0);
  });

  it('replaces and releases', () => {
    const released: string[] = [];
    const bindings = new Bindings<string>('Test', (drawing) => released.push(drawing));
    const particle = new World().addParticle({ x: 0, y: 0 });
    bindings.bind(particle, 'a');
    bindings.bind(particle, 'a');
    expect(released).toEqual([]);
    bindings.bind(particle, 'b');
    expect(released).toEqual(['a']);
    bindings.clear();
    expect(released).toEqual(['a', 'b']);
    bindings.unbind(particle);
    expect(released).toEqual(['a', 'b']);
  });

  it('refuses what is no particle, or no longer one', () => {
    const particle = new World().addParticle({ x: 0, y: 0 });
    particle.remove();
    const bindings = new Bindings<string>('Test');
    expect(() => bindings.bind(particle, 'a')).toThrow('Test.bind: the particle must be in its world; it was removed.');
    expect(() => bindings.bind({} as Particle, 'a')).toThrow(TypeError);
    expect(() => bindings.bind(undefined as unknown as Particle, 'a')).toThrow(TypeError);
  });
});
