import type { Ramp } from './color-style.ts';
import { formatColor, mixColors, parseColor } from './colors.ts';
import type { PathPaint } from './path-list.ts';

const steps = 32;

/** A paint for a line or, of width 0, for a fill. Translucent lines that overlap are drawn one by one. */
export function pathPaint(color: string, alpha: number, width: number, together: boolean = alpha === 1): PathPaint {
  const rgb = parseColor('color', color);
  return { color: formatColor(rgb), rgb, alpha, width, together };
}

/** Paints by a quantity, and by how thin a line is: one of few for each value. */
export class PaintRamp<By extends string> {
  /** What it goes by; `null` where there is one colour only. */
  readonly by: By | null;
  readonly #from: number;
  readonly #span: number;
  readonly #widths: number;
  readonly #paints: PathPaint[] = [];

  /** `widths` are as many widths as a line may have, the first the one of share 0. */
  constructor(color: string, ramp: Ramp<By> | null, alpha: number, widths: readonly number[]) {
    this.by = ramp?.by ?? null;
    this.#from = ramp?.from ?? 0;
    this.#span = ramp ? ramp.to - ramp.from : 1;
    this.#widths = widths.length;
    const colors = ramp ? ramp.colors.map((each) => parseColor('color', each)) : [parseColor('color', color)];
    for (let step = 0; step < (ramp ? steps : 1); step++) {
      const rgb = ramp ? mixColors(colors, step / (steps - 1)) : colors[0];
      for (const width of widths) this.#paints.push(pathPaint(formatColor(rgb), alpha, width));
    }
  }

  /** The paint for a value of the quantity and a share, 0 to 1, of the way to the last width. */
  at(value: number, share = 0): PathPaint {
    const width = Math.round(share * (this.#widths - 1));
    if (this.by === null) return this.#paints[width];
    const t = (value - this.#from) / this.#span;
    const step = t > 0 ? Math.min(steps - 1, Math.floor(t * steps)) : 0;
    return this.#paints[step * this.#widths + width];
  }
}
