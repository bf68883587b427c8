import { Buoyancy, box, HalfPlane, type ParticleOptions, rod, World } from '@mass/core';
import { Camera, type Style } from '@mass/core/view';
import { describe, expect, it } from 'vitest';
import { CanvasRenderer, type CanvasTarget } from '../src/index.ts';
import { type Call, fakeContext } from './fake-context.ts';

const camera = new Camera({ pixelsPerMetre: 10, width: 200, height: 100 });

function scene(style: Style, ...particles: ParticleOptions[]) {
  const fake = fakeContext(200, 100);
  const world = new World();
  const handles = particles.map((options) => world.addParticle(options));
  const renderer = new CanvasRenderer(fake.context, { style });
  const render = (alpha = 1): readonly Call[] => {
    fake.calls.length = 0;
    renderer.render(world, camera, alpha);
    return fake.calls;
  };
  return { ...fake, world, handles, renderer, render };
}

function named(calls: readonly Call[], name: string): Call[] {
  return calls.filter(([each]) => each === name);
}

describe('CanvasRenderer', () => {
  it('draws each particle as a disc of its radius', () => {
    const { render } = scene({}, { x: 0, y: 0, radius: 1 }, { x: 2, y: 3, radius: 0.5 });
    expect(named(render(), 'arc')).toEqual([
      ['arc', 100, 50, 10, 0, 2 * Math.PI],
      ['arc', 120, 20, 5, 0, 2 * Math.PI],
    ]);
  });

  it('fills few paths for many particles', () => {
    const many = Array.from({ length: 1000 }, (_, i) => ({ x: (i % 20) - 10, y: 0, radius: 0.1, group: i % 2 }));
    const { render } = scene({ groups: { 1: { fill: '#ff0000' } } }, ...many);
    const calls = render();
    expect(named(calls, 'arc').length).toBe(1000);
    expect(named(calls, 'fill').length).toBe(2);
    expect(named(calls, 'fillStyle=')).toEqual([
      ['fillStyle=', '#2563eb'],
      ['fillStyle=', '#ff0000'],
    ]);
  });

  it('draws an outline inside the radius', () => {
    const { render } = scene({ particle: { stroke: '#000', strokeWidth: 2 } }, { x: 0, y: 0, radius: 1 });
    const calls = render();
    expect(named(calls, 'arc').every(([, , , radius]) => radius === 9)).toBe(true);
    expect(named(calls, 'lineWidth=')).toEqual([['lineWidth=', 2]]);
    expect(named(calls, 'stroke').length).toBe(1);
  });

  it('fills translucent discs one by one, so that both show where they overlap', () => {
    const { render } = scene({ particle: { alpha: 0.5 } }, { x: 0, y: 0 }, { x: 0.1, y: 0 });
    expect(named(render(), 'fill').length).toBe(2);
  });

  it('draws between the last two steps', () => {
    const { world, render } = scene({}, { x: 0, y: 0, vx: 1 });
    world.step(1);
    expect(named(render(0.5), 'arc')[0].slice(1, 3)).toEqual([105, 50]);
  });

  it('takes its new size with the next frame, in device pixels', () => {
    const { canvas, renderer, render, calls } = scene({ background: '#abcdef' }, { x: 0, y: 0 });
    renderer.resize(300, 150, 2);
    expect(canvas.width).toBe(200);
    render();
    expect(canvas).toEqual({ width: 600, height: 300 });
    expect(calls).toContainEqual(['fillRect', 0, 0, 600, 300]);
    expect(calls).toContainEqual(['setTransform', 2, 0, 0, 2, 0, 0]);
  });

  it('clears to transparent without a background', () => {
    const calls = scene({}).render();
    expect(calls).toContainEqual(['clearRect', 0, 0, 200, 100]);
    expect(named(calls, 'fillRect')).toEqual([]);
  });

  it('draws trails under the discs', () => {
    const style: Style = { particle: { trail: { seconds: 1, points: 10, color: '#123456' } } };
    const { world, render } = scene(style, { x: 0, y: 0, vx: 1 });
    for (let i = 0; i < 60; i++) {
      world.step(1 / 60);
      render();
    }
    const calls = render();
    expect(named(calls, 'lineTo').length).toBeGreaterThanOrEqual(9);
    expect(calls).toContainEqual(['strokeStyle=', '#123456']);
    const names = calls.map(([name]) => name);
    expect(names.lastIndexOf('lineTo')).toBeLessThan(names.indexOf('arc'));
  });

  it("calls a game's own drawing in place of the disc, until it is unbound or the particle is gone", () => {
    const { handles, renderer, render, world } = scene({}, { x: 1, y: 0, radius: 2 }, { x: 0, y: 0 });
    const drawn: unknown[] = [];
    renderer.bind(handles[0], (_, x, y, radius, particle) => drawn.push([x, y, radius, particle]));
    expect(named(render(), 'arc').length).toBe(1);
    expect(drawn).toEqual([[110, 50, 20, handles[0]]]);
    renderer.unbind(handles[0]);
    expect(named(render(), 'arc').length).toBe(2);
    renderer.bind(handles[0], () => drawn.push('again'));
    handles[0].remove();
    world.addParticle({ x: 0, y: 0 });
    expect(named(render(), 'arc').length).toBe(2);
    expect(drawn.length).toBe(1);
  });

  it('draws the ground, then links, then discs, then a drawing of the game, then arrows', () => {
    const style: Style = {
      particle: { fill: '#000004' },
      shapes: { fill: '#000002', stroke: null, hatch: null },
      liquids: { fill: '#000001', surfaceWidth: 0 },
      links: { rod: { color: '#000003' } },
      velocities: { color: '#000006' },
      pins: null,
    };
    const { world, renderer, render, handles } = scene(style, { x: 0, y: 0, vx: 20 }, { x: 3, y: 0 }, { x: 5, y: 0 });
    world.addForce(new Buoyancy(), []);
    world.addShape(new HalfPlane());
    world.addLink(rod(handles[0], handles[1]));
    renderer.bind(handles[2], (context) => {
      context.fillStyle = '#000005';
    });
    const painted = render().filter(([name]) => name === 'fillStyle=' || name === 'strokeStyle=');
    expect([...new Set(painted.map(([, color]) => color))]).toEqual([1, 2, 3, 4, 5, 6].map((n) => `#00000${n}`));
  });

  it('strokes lines of one look together', () => {
    const { world, render, handles } = scene({}, ...Array.from({ length: 100 }, (_, n) => ({ x: n / 10 - 5, y: 0 })));
    for (let n = 1; n < 100; n++) world.addLink(rod(handles[n - 1], handles[n]));
    const calls = render();
    expect(named(calls, 'stroke').length).toBe(1);
    expect(named(calls, 'lineTo').length).toBe(99);
  });

  it('strokes translucent lines one by one, so that both show where they cross', () => {
    const style: Style = { links: { rod: { alpha: 0.5 } } };
    const { world, render, handles } = scene(style, { x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0, y: 1 });
    world.addLink(rod(handles[0], handles[1]));
    world.addLink(rod(handles[0], handles[2]));
    expect(named(render(), 'stroke').length).toBe(2);
  });

  it("calls a game's own drawing in place of a body, with where it is and how it is turned", () => {
    const { world, renderer, render } = scene({});
    const body = world.addBody(box({ x: 2, y: 1, width: 2, height: 1, angle: 0.5 }));
    expect(named(render(), 'fill').length).toBe(1);
    const drawn: unknown[][] = [];
    renderer.bind(body, (_, ...values) => void drawn.push(values));
    expect(named(render(), 'fill').length).toBe(0);
    expect(drawn[0].slice(0, 2).map(Number)).toEqual([120, 40]);
    expect(drawn[0][2]).toBeCloseTo(-0.5, 12);
    expect(drawn[0][3]).toBe(body);
    renderer.unbind(body);
    expect(named(render(), 'fill').length).toBe(1);
    renderer.bind(body, (_, ...values) => void drawn.push(values));
    body.remove();
    render();
    expect(drawn.length).toBe(1);
    expect(() => renderer.bind(body, () => {})).toThrow(
      'CanvasRenderer.bind: the body must be in its world; it was removed.',
    );
    expect(() => renderer.bind(null as never, () => {})).toThrow('must be a particle or a body; got null');
  });

  it('takes a new style with the next frame', () => {
    const { renderer, render } = scene({}, { x: 0, y: 0 });
    renderer.style = { particle: { fill: '#00ff00' } };
    expect(named(render(), 'fillStyle=')).toEqual([['fillStyle=', '#00ff00']]);
    expect(() => {
      renderer.style = { particle: { fill: 'green' } };
    }).toThrow(TypeError);
    expect(named(render(), 'fillStyle=')).toEqual([['fillStyle=', '#00ff00']]);
  });

  it('writes nothing to the world', () => {
    const style: Style = {
      particle: { trail: { seconds: 1 }, colorBy: { by: 'speed', from: 0, to: 1, colors: ['#000', '#fff'] } },
    };
    const { world, render } = scene(style, { x: 1, y: 2, vx: 3, vy: 4, lifetime: 5 });
    world.step(1 / 60);
    const copy = () =>
      JSON.stringify(
        Object.values(world.particles)
          .filter(ArrayBuffer.isView)
          .map((array) => [...(array as Float64Array)]),
      );
    const before = copy();
    expect(before.length).toBeGreaterThan(1000);
    for (let i = 0; i < 10; i++) render(0.3);
    expect(copy()).toBe(before);
  });

  it('empties the canvas when it is destroyed, once, and draws no more', () => {
    const { renderer, render, calls } = scene({}, { x: 0, y: 0 });
    renderer.destroy();
    renderer.destroy();
    expect(named(calls, 'clearRect')).toEqual([['clearRect', 0, 0, 200, 100]]);
    expect(() => render()).toThrow(
      'CanvasRenderer.render: the renderer must not be destroyed; it was. Make a new one.',
    );
  });

  it('refuses what it cannot draw into, with or by', () => {
    expect(() => new CanvasRenderer(null as unknown as CanvasTarget)).toThrow('the target must be a canvas');
    expect(() => new CanvasRenderer({} as CanvasTarget)).toThrow(TypeError);
    const { renderer, handles } = scene({}, { x: 0, y: 0 });
    expect(() => renderer.resize(Number.NaN, 1)).toThrow('width and height must be finite numbers of CSS px');
    expect(() => renderer.resize(1, 1, 0)).toThrow('Use devicePixelRatio.');
    expect(() => renderer.bind(handles[0], 'sprite' as never)).toThrow('the drawing must be a function');
  });
});
