import type { Color, Ramp } from './color-style.ts';

/** How links of one kind look. A rod is a straight line; what is shorter than its greatest length hangs slack. */
export interface LinkStyle {
  /** @default a grey that suits the background */
  readonly color: Color;
  /** Replaces `color`: by strain, how much it is longer than its greatest length, or shorter than its smallest, as a share. @default null */
  readonly colorBy: Ramp<'strain'> | null;
  /** Unit: CSS px. @default 3 for a rod, 1.75 for a cable, 2 for any other */
  readonly width: number;
  /** Opacity, 0 to 1. @default 1 */
  readonly alpha: number;
}

/**
 * What a spring or bungee is coloured by: strain, the extension as a share of the rest length; force, the tension in N;
 * stiffness in N/m.
 */
export type SpringQuantity = 'strain' | 'force' | 'stiffness';

/** How springs look: coils whose number stays the same and which grow narrower as the spring is stretched. */
export interface SpringStyle {
  /** @default a grey that suits the background */
  readonly color: Color;
  /** Replaces `color`. @default null */
  readonly colorBy: Ramp<SpringQuantity> | null;
  /** Width of the wire. Unit: CSS px. @default 1.75 */
  readonly width: number;
  /** Opacity, 0 to 1. @default 1 */
  readonly alpha: number;
  /** How many coils, 0 to 100; without any it is a straight line, the cheapest where there are thousands. @default 9 */
  readonly coils: number;
  /** Width of the coils at rest; less where the spring is short on the screen. Unit: CSS px. @default 16 */
  readonly diameter: number;
}

/** How bungees look: a cord that grows thinner as it is stretched and hangs in a curve when slack. */
export interface BungeeStyle {
  /** @default a grey that suits the background */
  readonly color: Color;
  /** Replaces `color`. @default null */
  readonly colorBy: Ramp<SpringQuantity> | null;
  /** Width at the rest length and below. Unit: CSS px. @default 4 */
  readonly width: number;
  /** Opacity, 0 to 1. @default 1 */
  readonly alpha: number;
}

/** How the marks look where something hangs on a fixed point or on a particle that cannot move. */
export interface PinStyle {
  /** @default a grey that suits the background */
  readonly color: Color;
  /** Radius of the ring. Unit: CSS px. @default 5 */
  readonly radius: number;
  /** Opacity, 0 to 1. @default 1 */
  readonly alpha: number;
}
