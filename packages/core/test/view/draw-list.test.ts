import { describe, expect, it } from 'vitest';
import { World } from '../../src/index.ts';
import { Camera, DrawList, interpolate, Palette } from '../../src/view/index.ts';

const none = new Uint8Array(64);

function camera(): Camera {
  return new Camera({ pixelsPerMetre: 10, width: 200, height: 100 });
}

describe('interpolate', () => {
  it('gives the previous positions at 0, the present ones at 1, and the way between', () => {
    const world = new World();
    world.addParticle({ x: 1, y: 2, vx: 6, vy: -12 });
    world.step(0.5);
    const x = new Float64Array(1);
    const y = new Float64Array(1);
    const at = (alpha: number) => {
      interpolate(world.particles, alpha, x, y);
      return [x[0], y[0]];
    };
    expect(at(0)).toEqual([1, 2]);
    expect(at(0.5)).toEqual([2.5, -1]);
    expect(at(1)).toEqual([4, -4]);
  });
});

describe('DrawList', () => {
  it('sorts by paint, and by slot within a paint', () => {
    const world = new World();
    for (const group of [2, 0, 1, 2, 0]) world.addParticle({ x: 0, y: 0, group });
    const palette = new Palette({ groups: { 1: {}, 2: {} } });
    const list = new DrawList();
    list.update(world, palette, camera(), 1, none);
    expect([...list.starts]).toEqual([0, 2, 3, 5]);
    expect([...list.order.subarray(0, 5)]).toEqual([1, 4, 2, 0, 3]);
  });

  it('places discs in CSS px, none smaller than the least radius or the outline', () => {
    const world = new World();
    world.addParticle({ x: 1, y: 1, radius: 2 });
    world.addParticle({ x: -1, y: 0 });
    world.addParticle({ x: 0, y: 0, group: 1 });
    const list = new DrawList();
    const palette = new Palette({ groups: { 1: { stroke: '#000', strokeWidth: 5 } } });
    list.update(world, palette, camera(), 1, none);
    expect([list.x[0], list.y[0], list.radius[0]]).toEqual([110, 40, 20]);
    expect([list.x[1], list.y[1], list.radius[1]]).toEqual([90, 50, 2]);
    expect(list.radius[2]).toBe(5);
  });

  it('leaves out the dead, the hidden and what is out of sight', () => {
    const world = new World();
    const particles = [0, 1, 2, 3].map((x) => world.addParticle({ x, y: 0 }));
    world.addParticle({ x: 10.05, y: 0, radius: 0.2 });
    world.addParticle({ x: 11, y: 0, radius: 0.2 });
    particles[1].remove();
    const hidden = new Uint8Array(64);
    hidden[2] = 1;
    const list = new DrawList();
    list.update(world, new Palette({}), camera(), 1, hidden);
    expect([...list.order.subarray(0, list.starts[1])]).toEqual([0, 3, 4]);
    expect(list.x[2]).toBe(120);
  });

  it('grows with the world', () => {
    const world = new World();
    const list = new DrawList();
    for (let n = 0; n < 300; n++) world.addParticle({ x: 0, y: 0 });
    list.update(world, new Palette({}), camera(), 1, new Uint8Array(300));
    expect(list.starts[1]).toBe(300);
    expect([...list.order.subarray(0, 300)]).toEqual(Array.from({ length: 300 }, (_, i) => i));
  });

  it('refuses an alpha outside 0 to 1', () => {
    const update = (alpha: number) => () => new DrawList().update(new World(), new Palette({}), camera(), alpha, none);
    expect(update(1.5)).toThrow('Renderer.render: alpha must be a number from 0 to 1; got 1.5.');
    expect(update(Number.NaN)).toThrow(RangeError);
  });
});
