import { describe, expect, it } from 'vitest';
import { completeStyle } from '../../src/view/complete-style.ts';
import { Palette, Sketch, type Style } from '../../src/view/index.ts';

function luma(color: string): number {
  const rgb = Number.parseInt(color.slice(1), 16);
  return 0.3 * (rgb >> 16) + 0.59 * ((rgb >> 8) & 255) + 0.11 * (rgb & 255);
}

const make = (style: unknown) => () => new Sketch(style as Style, new Palette({}));

describe('a style of links, scenery and arrows', () => {
  it('may be left out, empty or null', () => {
    expect(make({})).not.toThrow();
    const names = ['links', 'springs', 'bungees', 'pins', 'shapes', 'liquids', 'bodies'];
    for (const name of [...names, 'velocities', 'forces', 'contacts']) {
      expect(make({ [name]: {} }), name).not.toThrow();
      expect(make({ [name]: null }), name).not.toThrow();
    }
  });

  it('stands out from the background unless it says otherwise', () => {
    const gap = (background: string): number => {
      const style: Style = { background };
      const { links, springs, bungees, pins, shapes, liquids } = completeStyle(style);
      const used = [links['rod'], links['cable'], springs, bungees, pins].map((each) => each?.color);
      return Math.min(
        ...[...used, shapes?.stroke, liquids?.fill].map((color) => Math.abs(luma(String(color)) - luma(background))),
      );
    };
    expect(gap('#ffffff')).toBeGreaterThan(100);
    expect(gap('#14171c')).toBeGreaterThan(100);
  });

  it('names the place of what cannot be drawn', () => {
    const ramp = { by: 'strain', from: 0, to: 1, colors: ['#000', '#fff'] };
    for (const [style, message] of [
      [
        { springs: true },
        'Style: springs must be an object, {} for the defaults, or null to leave them out; got true.',
      ],
      [{ springs: { color: 'red' } }, `Style: springs.color must be a colour, '#rgb' or '#rrggbb'; got "red".`],
      [{ springs: { coils: 2.5 } }, 'Style: springs: coils must be a whole number from 0 to 100; got 2.5.'],
      [
        { springs: { colorBy: { ...ramp, by: 'speed' } } },
        `Style: springs.colorBy: by must be 'strain' or 'force' or 'stiffness'; got "speed".`,
      ],
      [
        { bungees: { colorBy: { ...ramp, to: 0 } } },
        'Style: bungees.colorBy: to - from must be a positive, finite number; got 0. Turn the colours around',
      ],
      [
        { bungees: { colorBy: { ...ramp, colors: ['#000'] } } },
        'Style: bungees.colorBy: colors must be two colours or more',
      ],
      [{ links: { rod: { width: 0 } } }, 'Style: links.rod: width must be a positive, finite number of pixels; got 0.'],
      [
        { links: { rod: { colorBy: { ...ramp, by: 'force' } } } },
        `Style: links.rod.colorBy: by must be 'strain'; got "force".`,
      ],
      [{ pins: { radius: -1 } }, 'Style: pins: radius must be a finite number of pixels, 0 or more; got -1.'],
      [
        { shapes: { hatchSpacing: 0 } },
        'Style: shapes: hatchSpacing must be a finite number of pixels, 2 or more; got 0. For no hatching set hatch to null.',
      ],
      [{ shapes: { fill: 7 } }, 'Style: shapes.fill must be a colour'],
      [{ liquids: { alpha: 2 } }, 'Style: liquids: alpha must be a number from 0 to 1; got 2.'],
      [{ liquids: { colorBy: { ...ramp } } }, `Style: liquids.colorBy: by must be 'density'; got "strain".`],
      [{ bodies: { fillAlpha: Number.NaN } }, 'Style: bodies: fillAlpha must be a number from 0 to 1; got NaN.'],
      [{ velocities: { scale: 0 } }, 'Style: velocities: scale must be a positive, finite number; got 0.'],
      [{ forces: { longest: 0 } }, 'Style: forces: longest must be a positive, finite number of pixels; got 0.'],
      [{ contacts: { normal: -1 } }, 'Style: contacts: normal must be a finite number of pixels, 0 or more; got -1.'],
    ] as [unknown, string][]) {
      expect(make(style)).toThrow(message);
    }
  });

  it('survives a passage through JSON', () => {
    const style: Style = {
      springs: { colorBy: { by: 'strain', from: -1, to: 1, colors: ['#000', '#fff'] } },
      links: { rod: null, tow: { width: 3 } },
      shapes: null,
      contacts: {},
    };
    expect(make(JSON.parse(JSON.stringify(style)))).not.toThrow();
  });
});
