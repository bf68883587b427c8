import type { TrailStyle } from './style.ts';

/** How one bucket of discs is painted, colours both as CSS and as a number. */
export interface Paint {
  /** `null` for no fill. */
  readonly fill: string | null;
  /** 0xrrggbb. */
  readonly fillRgb: number;
  /** `null` for no outline. */
  readonly stroke: string | null;
  /** 0xrrggbb. */
  readonly strokeRgb: number;
  /** Unit: CSS px. */
  readonly strokeWidth: number;
  /** 0 to 1. */
  readonly alpha: number;
}

/** How many steps a trail fades in. */
export const trailLevels = 16;

/** How the trails of one class of particles are painted, level 0 beside the particle. */
export interface TrailPaint {
  /** Unit: s. */
  readonly seconds: number;
  readonly points: number;
  readonly color: string;
  /** 0xrrggbb. */
  readonly rgb: number;
  /** Opacity of each level. */
  readonly alpha: Float64Array;
  /** Width of each level. Unit: CSS px. */
  readonly width: Float64Array;
}

/** The levels of a trail: it fades and narrows with age, more slowly at first. */
export function trailPaint(style: TrailStyle, color: string, rgb: number, opacity: number): TrailPaint {
  const { seconds, points = Math.min(120, Math.max(4, Math.ceil(seconds * 30))), width = 2, alpha = 0.6 } = style;
  const alphas = new Float64Array(trailLevels);
  const widths = new Float64Array(trailLevels);
  for (let level = 0; level < trailLevels; level++) {
    const left = 1 - (level + 0.5) / trailLevels;
    alphas[level] = alpha * opacity * left * (2 - left);
    widths[level] = width * (0.25 + 0.75 * left);
  }
  return { seconds, points, color, rgb, alpha: alphas, width: widths };
}
