import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { checkParticleStyle, checkStyle } from './check-style.ts';
import { formatColor, mixColors, parseColor } from './colors.ts';
import { type Paint, type TrailPaint, trailPaint } from './paint.ts';
import type { ParticleStyle, Style } from './style.ts';

/** What a particle looks like that no style says anything of. */
export const defaultParticleStyle: ParticleStyle = Object.freeze({
  fill: '#2563eb',
  stroke: null,
  strokeWidth: 1.5,
  alpha: 1,
  minRadius: 2,
  trail: null,
  colorBy: null,
  fadeOut: 0,
});

const rampSteps = 32;
const fadeSteps = 16;

/**
 * Which paint each particle gets: a style made ready, once, for all renderers. A *class* is the particles of one group
 * that the style names, class 0 those of all other groups; a *paint* is a class at one step of its ramp and of its fading.
 * So there are few paints, and a renderer sets each once a frame, whatever the number of particles. For authors of renderers.
 */
export class Palette {
  /** Every paint that a disc may have, in the order in which they are drawn. */
  readonly paints: readonly Paint[];
  /** The smallest radius of a disc by class. Unit: CSS px. */
  readonly minRadius: Float64Array;
  /** How trails are painted by class; `null` for classes without. */
  readonly trails: readonly (TrailPaint | null)[];
  /** Whether any class has a trail. */
  readonly hasTrails: boolean;
  readonly #styles: ParticleStyle[];
  readonly #classOfGroup: Uint16Array;
  readonly #firstPaint: Uint32Array;

  constructor(style: Style) {
    checkStyle(style);
    const { particle = {}, groups = {} } = style;
    const keys = Object.keys(groups)
      .map(Number)
      .sort((a, b) => a - b);
    const base: ParticleStyle = { ...defaultParticleStyle, ...particle };
    this.#styles = [base, ...keys.map((key) => ({ ...base, ...groups[key] }))];
    for (const [c, each] of this.#styles.entries()) {
      checkParticleStyle(`Style: ${c === 0 ? 'particle' : `groups[${keys[c - 1]}]`}`, each);
    }
    this.#classOfGroup = new Uint16Array((keys.at(-1) ?? -1) + 1);
    keys.forEach((key, i) => {
      this.#classOfGroup[key] = i + 1;
    });
    this.#firstPaint = new Uint32Array(this.#styles.length);
    const paints: Paint[] = [];
    this.#styles.forEach((each, c) => {
      this.#firstPaint[c] = paints.length;
      paints.push(...paintsOf(each));
    });
    this.paints = paints;
    this.minRadius = Float64Array.from(this.#styles, ({ minRadius }) => minRadius);
    this.trails = this.#styles.map(trailOf);
    this.hasTrails = this.trails.some((trail) => trail !== null);
  }

  /** The fill of the particles of a group, or their outline where they have none; of a ramp its first colour. */
  fillOf(group: number): string {
    const { fill, stroke, colorBy } = this.#styles[this.classOf(group)];
    return colorBy?.colors[0] ?? fill ?? stroke ?? '#808080';
  }

  /** The class of the particles of a group. */
  classOf(group: number): number {
    return group < this.#classOfGroup.length ? this.#classOfGroup[group] : 0;
  }

  /** Writes the class and the paint of each slot, free slots included. */
  assign({ count, group, vx, vy, lifetime }: ParticleArrays, classes: Uint16Array, paints: Uint32Array): void {
    const classOfGroup = this.#classOfGroup;
    const groups = classOfGroup.length;
    for (let i = 0; i < count; i++) {
      const c = group[i] < groups ? classOfGroup[group[i]] : 0;
      const { colorBy, fadeOut } = this.#styles[c];
      let paint = this.#firstPaint[c];
      if (colorBy !== null) {
        const speed = Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
        const share = (speed - colorBy.from) / (colorBy.to - colorBy.from);
        const step = share > 0 ? Math.min(rampSteps - 1, Math.floor(share * rampSteps)) : 0;
        paint += fadeOut > 0 ? step * (fadeSteps + 1) : step;
      }
      if (fadeOut > 0) paint += lifetime[i] < fadeOut ? Math.ceil((lifetime[i] / fadeOut) * fadeSteps) : fadeSteps;
      classes[i] = c;
      paints[i] = paint;
    }
  }
}

function paintsOf(style: ParticleStyle): Paint[] {
  const { fill, stroke, strokeWidth, alpha, colorBy, fadeOut } = style;
  const strokeRgb = stroke === null ? 0 : parseColor('stroke', stroke);
  const outlined = stroke !== null && strokeWidth > 0;
  const fills: (number | null)[] = [fill === null ? null : parseColor('fill', fill)];
  if (colorBy !== null) {
    const colors = colorBy.colors.map((color) => parseColor('color', color));
    fills.length = 0;
    for (let step = 0; step < rampSteps; step++) fills.push(mixColors(colors, step / (rampSteps - 1)));
  }
  const alphas = fadeOut > 0 ? Array.from({ length: fadeSteps + 1 }, (_, step) => (alpha * step) / fadeSteps) : [alpha];
  return fills.flatMap((rgb) =>
    alphas.map((opacity) => ({
      fill: rgb === null ? null : formatColor(rgb),
      fillRgb: rgb ?? 0,
      stroke: outlined ? formatColor(strokeRgb) : null,
      strokeRgb,
      strokeWidth: outlined ? strokeWidth : 0,
      alpha: opacity,
    })),
  );
}

function trailOf({ trail, fill, stroke, alpha, colorBy }: ParticleStyle): TrailPaint | null {
  if (trail === null) return null;
  const color = trail.color ?? colorBy?.colors[0] ?? fill ?? stroke ?? '#808080';
  const rgb = parseColor('trail.color', color);
  return trailPaint(trail, formatColor(rgb), rgb, alpha);
}
