import type { Color, Ramp } from './color-style.ts';

/** How static shapes look. */
export interface ShapeStyle {
  /** Of the solid side. `null` for none. @default a grey that suits the background */
  readonly fill: Color | null;
  /** Opacity of the fill, 0 to 1. @default 0.1 */
  readonly fillAlpha: number;
  /** The surface. `null` for none. @default a grey that suits the background */
  readonly stroke: Color | null;
  /** Unit: CSS px. @default 2 */
  readonly strokeWidth: number;
  /** Slanting lines over the solid side. `null` for none. @default a grey that suits the background */
  readonly hatch: Color | null;
  /** Opacity of the hatching, 0 to 1. @default 0.26 */
  readonly hatchAlpha: number;
  /** From one line of the hatching to the next, whatever the zoom; at least 2. Unit: CSS px. @default 9 */
  readonly hatchSpacing: number;
}

/** How the liquids of buoyancy look. */
export interface LiquidStyle {
  /** @default a blue that suits the background */
  readonly fill: Color;
  /** Replaces `fill`: by density, in kg/m³. @default null */
  readonly colorBy: Ramp<'density'> | null;
  /** Opacity of the body, 0 to 1. @default 0.22 */
  readonly alpha: number;
  /** Width of the line along the surface, in the colour of the fill; 0 for none. Unit: CSS px. @default 2 */
  readonly surfaceWidth: number;
  /**
   * Whether a particle that has a hull of its own is drawn as the upright box that its buoyancy is exact for, in place of
   * its disc. @default true
   */
  readonly hulls: boolean;
}

/** How aggregates look that are a ring of particles: a filled outline in place of their discs and links. */
export interface BodyStyle {
  /** @default the fill of the particles of its group */
  readonly fill: Color | null;
  /** Opacity of the fill, 0 to 1. @default 0.3 */
  readonly fillAlpha: number;
  /** @default the colour of the fill */
  readonly stroke: Color | null;
  /** Drawn inside the outline. Unit: CSS px. @default 2 */
  readonly strokeWidth: number;
  /** Whether a line from the centre shows how it is turned. @default true */
  readonly mark: boolean;
  /** Whether the particles and links that it is made of are drawn too. @default false */
  readonly skeleton: boolean;
}

/** How velocities or forces look: arrows. They are drawn where a style asks for them, if only by `{}`. */
export interface ArrowStyle {
  /** @default green for velocities, red for forces */
  readonly color: Color;
  /** Unit: CSS px. @default 2 */
  readonly width: number;
  /** Length of the arrow for each m/s, or for each N. Unit: s, or m/N. @default 0.15 for velocities, 0.05 for forces */
  readonly scale: number;
  /** No arrow is drawn longer. Unit: CSS px. @default 160 */
  readonly longest: number;
  /** Opacity, 0 to 1. @default 1 */
  readonly alpha: number;
}

/** How contacts look: a point, its normal, and the impulse along it. They are drawn where a style asks for them. */
export interface ContactStyle {
  /** @default an orange that suits the background */
  readonly color: Color;
  /** Unit: CSS px. @default 1.75 */
  readonly width: number;
  /** Length of the normal. Unit: CSS px. @default 14 */
  readonly normal: number;
  /** Length of the impulse for each N·s; 0 for none. Unit: m/(N·s). @default 0.5 */
  readonly scale: number;
  /** No impulse is drawn longer. Unit: CSS px. @default 160 */
  readonly longest: number;
  /** Opacity, 0 to 1. @default 1 */
  readonly alpha: number;
}
