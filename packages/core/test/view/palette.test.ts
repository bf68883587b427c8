import { describe, expect, it } from 'vitest';
import { World } from '../../src/index.ts';
import { Palette, type Style } from '../../src/view/index.ts';

function paintOf(style: Style, options: { group?: number; vx?: number; lifetime?: number } = {}) {
  const world = new World();
  world.addParticle({ x: 0, y: 0, ...options });
  const palette = new Palette(style);
  const classes = new Uint16Array(1);
  const paints = new Uint32Array(1);
  palette.assign(world.particles, classes, paints);
  return { ...palette.paints[paints[0]], minRadius: palette.minRadius[classes[0]] };
}

describe('Palette', () => {
  it('has a look for particles that no style speaks of', () => {
    expect(paintOf({})).toMatchObject({ fill: '#2563eb', stroke: null, alpha: 1, minRadius: 2 });
  });

  it('takes from the group first, then from the particle style', () => {
    const style: Style = { particle: { fill: '#112233', alpha: 0.5 }, groups: { 7: { fill: '#abc' } } };
    expect(paintOf(style, { group: 7 })).toMatchObject({ fill: '#aabbcc', fillRgb: 0xaabbcc, alpha: 0.5 });
    expect(paintOf(style, { group: 6 })).toMatchObject({ fill: '#112233' });
    expect(paintOf(style, { group: 65535 })).toMatchObject({ fill: '#112233' });
  });

  it('draws higher groups later', () => {
    const style: Style = { groups: { 9: { fill: '#999999' }, 3: { fill: '#333333' } } };
    expect(new Palette(style).paints.map(({ fill }) => fill)).toEqual(['#2563eb', '#333333', '#999999']);
  });

  it('colours by speed between the ends of the ramp', () => {
    const style: Style = {
      particle: { colorBy: { by: 'speed', from: 2, to: 4, colors: ['#000000', '#00ff00', '#ffffff'] } },
    };
    expect(paintOf(style, { vx: 0 }).fill).toBe('#000000');
    expect(paintOf(style, { vx: 2 }).fill).toBe('#000000');
    expect(paintOf(style, { vx: -4 }).fill).toBe('#ffffff');
    expect(paintOf(style, { vx: 99 }).fill).toBe('#ffffff');
    const middle = paintOf(style, { vx: 3 }).fillRgb;
    expect((middle >> 8) & 255).toBeGreaterThan(245);
  });

  it('fades out over the end of the lifetime', () => {
    const style: Style = { particle: { fadeOut: 2, alpha: 0.8 } };
    expect(paintOf(style, {}).alpha).toBe(0.8);
    expect(paintOf(style, { lifetime: 2 }).alpha).toBe(0.8);
    expect(paintOf(style, { lifetime: 1 }).alpha).toBeCloseTo(0.4, 9);
    expect(paintOf(style, { lifetime: 1e-6 }).alpha).toBeLessThan(0.06);
  });

  it('fades and colours at once', () => {
    const style: Style = {
      particle: { fadeOut: 2, colorBy: { by: 'speed', from: 0, to: 1, colors: ['#000000', '#ffffff'] } },
    };
    expect(paintOf(style, { vx: 1, lifetime: 1 })).toMatchObject({ fill: '#ffffff', alpha: 0.5 });
    expect(paintOf(style, { vx: 0, lifetime: 9 })).toMatchObject({ fill: '#000000', alpha: 1 });
  });

  it('survives a passage through JSON', () => {
    const style: Style = { particle: { stroke: null, trail: { seconds: 1 } }, groups: { 2: { fill: null } } };
    expect(new Palette(JSON.parse(JSON.stringify(style))).paints).toEqual(new Palette(style).paints);
  });

  it('names the place of what cannot be drawn', () => {
    const bad = (style: unknown) => () => new Palette(style as Style);
    expect(bad({ particle: { fill: 'red' } })).toThrow(
      `Style: particle.fill must be a colour, '#rgb' or '#rrggbb'; got "red".`,
    );
    expect(bad({ groups: { 4: { alpha: 2 } } })).toThrow(
      'Style: groups[4]: alpha must be a number from 0 to 1; got 2.',
    );
    expect(bad({ groups: { '-1': {} } })).toThrow(RangeError);
    expect(bad({ background: 5 })).toThrow(TypeError);
    expect(bad({ particle: { trail: { seconds: 0 } } })).toThrow('Style: particle.trail: seconds');
    expect(bad({ particle: { colorBy: { by: 'speed', from: 0, to: 1, colors: ['#fff'] } } })).toThrow('two colours');
    expect(bad(null)).toThrow(TypeError);
  });
});
