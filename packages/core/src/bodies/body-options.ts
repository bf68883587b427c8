import type { GivingOptions } from '../links/distance-link.ts';
import {
  requireFinite,
  requireNonNegative,
  requirePositive,
  requirePositiveOrInfinite,
  requireShare,
} from '../math/checks.ts';
import { checkParticleOptions, type ParticleOptions } from '../particles/particle-options.ts';

/** What all particles of a body have in common, and how its links give and break. */
export interface SharedOptions extends Omit<ParticleOptions, 'x' | 'y' | 'mass'>, Omit<GivingOptions, 'damping'> {
  /** Mass in all, positive and finite, spread over the particles. Unit: kg. @default 1 */
  mass?: number;
  /** How much its links calm what swings on them, 0 to 1: the `damping` of a rod or cable. @default 0 */
  linkDamping?: number;
}

/** How a stiff body, such as a box, starts. */
export interface BodyOptions extends SharedOptions {
  /** Centre of mass. Unit: m. */
  x: number;
  y: number;
  /** Orientation, counter-clockwise. Unit: rad. @default 0 */
  angle?: number;
  /** Angular velocity, counter-clockwise. Unit: rad/s. @default 0 */
  angularVelocity?: number;
}

/** The shared options, told apart. */
export interface Shares {
  /** What each particle gets. */
  readonly particle: Omit<ParticleOptions, 'x' | 'y' | 'mass'>;
  /** What each link gets. */
  readonly giving: Required<GivingOptions>;
  /** Mass in all. Unit: kg. */
  readonly mass: number;
}

/** Tells the shared options apart; throws the error that says what is wrong with them, if anything is. */
export function checkedShares(where: string, options: SharedOptions): Shares {
  const { mass = 1, compliance = 0, linkDamping = 0, ...others } = options;
  const { breakForce = Infinity, breakStrain = Infinity, ...particle } = others;
  requirePositive(where, 'mass', mass, 'kilograms', 'To pin a body, set the mass of its particles to Infinity.');
  requirePositiveOrInfinite(where, 'breakForce', breakForce, 'newtons');
  requirePositiveOrInfinite(where, 'breakStrain', breakStrain, '');
  requireNonNegative(where, 'compliance', compliance, 'metres per newton');
  requireShare(where, 'linkDamping', linkDamping);
  checkParticleOptions(where, { ...particle, x: 0, y: 0 });
  return { particle, giving: { breakForce, breakStrain, compliance, damping: linkDamping }, mass };
}

/** Throws the error that says what is wrong with the placing of a stiff body, if anything is. */
export function checkPlacing(where: string, { x, y, angle = 0, angularVelocity = 0 }: BodyOptions): void {
  requireFinite(where, 'x', x, 'metres');
  requireFinite(where, 'y', y, 'metres');
  requireFinite(where, 'angle', angle, 'radians');
  requireFinite(where, 'angularVelocity', angularVelocity, 'radians per second');
}
