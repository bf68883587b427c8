import type { Color, Ramp } from './color-style.ts';
import type { BungeeStyle, LinkStyle, PinStyle, SpringStyle } from './link-style.ts';
import type { ArrowStyle, BodyStyle, ContactStyle, LiquidStyle, ShapeStyle } from './scenery-style.ts';

/** A line of where the particle has been, which fades out towards its end. */
export interface TrailStyle {
  /** How far back it reaches. Unit: s of the world's time. */
  readonly seconds: number;
  /** Points along the whole of it, 2 to 240. Few are cheap, many follow tight turns. @default 30 a second, 4 to 120 */
  readonly points?: number;
  /** Width beside the particle; it narrows towards the end. Unit: CSS px. @default 2 */
  readonly width?: number;
  /** @default the fill of the particle */
  readonly color?: Color;
  /** Opacity beside the particle, 0 to 1. @default 0.6 */
  readonly alpha?: number;
}

/** Fill by speed, in m/s: see `Ramp`. */
export type SpeedRamp = Ramp<'speed'>;

/** How a particle looks: a disc of its own radius. */
export interface ParticleStyle {
  /** `null` leaves the disc empty. @default '#2563eb' */
  readonly fill: Color | null;
  /** Outline, drawn inside the radius, so that discs that touch are seen to touch. @default null */
  readonly stroke: Color | null;
  /** Width of the outline. Unit: CSS px. @default 1.5 */
  readonly strokeWidth: number;
  /** Opacity, 0 to 1. @default 1 */
  readonly alpha: number;
  /** A smaller disc is drawn with this radius, so that points are seen. Unit: CSS px. @default 2 */
  readonly minRadius: number;
  /** @default null */
  readonly trail: TrailStyle | null;
  /** Replaces `fill`. @default null */
  readonly colorBy: SpeedRamp | null;
  /** Fades to nothing during the last so many seconds of the particle's lifetime; 0 for not at all. @default 0 */
  readonly fadeOut: number;
}

/**
 * How a world looks: plain data, the same for every renderer; what it leaves out has a default. A section that is `null` is
 * not drawn.
 */
export interface Style {
  /** Behind everything; without it the ground is left transparent. */
  readonly background?: Color;
  /** Every particle. */
  readonly particle?: Partial<ParticleStyle>;
  /** Particles of a group: what differs from `particle`. Higher groups are drawn on top. */
  readonly groups?: { readonly [group: number]: Partial<ParticleStyle> };
  /** Links by kind: `rod`, `cable`, or a game's own word. */
  readonly links?: { readonly [kind: string]: Partial<LinkStyle> | null } | null;
  readonly springs?: Partial<SpringStyle> | null;
  readonly bungees?: Partial<BungeeStyle> | null;
  /** Where a link or spring hangs on a fixed point, or on a particle that cannot move. */
  readonly pins?: Partial<PinStyle> | null;
  readonly shapes?: Partial<ShapeStyle> | null;
  readonly liquids?: Partial<LiquidStyle> | null;
  readonly bodies?: Partial<BodyStyle> | null;
  /** @default null */
  readonly velocities?: Partial<ArrowStyle> | null;
  /** The forces that a `ForceProbe` in the world has seen. @default null */
  readonly forces?: Partial<ArrowStyle> | null;
  /** @default null */
  readonly contacts?: Partial<ContactStyle> | null;
}
