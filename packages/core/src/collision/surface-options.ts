import {
  requireFinite,
  requireFlag,
  requireFunction,
  requireInteger,
  requireNonNegative,
  requireShare,
} from '../math/checks.ts';

/** What all static shapes can be told: how their surface is, and what may touch it. */
export interface SurfaceOptions {
  /** Share of the closing speed that is given back, 0 to 1; of this and the particle's the greater counts. @default 0 */
  restitution?: number;
  /** Coefficient of friction, 0 or more; of this and the particle's the geometric mean counts. @default 0 */
  friction?: number;
  /**
   * How fast the surface moves along the tangent (normalY, -normalX), to the right on a floor: a conveyor. It pulls by
   * friction. Unit: m/s. @default 0
   */
  surfaceSpeed?: number;
  /** Whether it only tells who touches it, by `contactBegin` and `contactEnd`, and pushes nothing. @default false */
  sensor?: boolean;
  /** What it is: bits, 0 to 0xffff. A particle touches it if each has a bit of the other's category in its mask. @default 1 */
  category?: number;
  /** What may touch it: bits, 0 to 0xffff. @default 0xffff */
  mask?: number;
  /** Whether a particle, by slot, may touch it; asked in each step of those that are near. @default all may */
  filter?: ((slot: number) => boolean) | undefined;
}

/** Throws the error that says what is wrong with a surface, a game's own included, if anything is. */
export function checkSurface(where: string, options: SurfaceOptions): void {
  const {
    restitution = 0,
    friction = 0,
    surfaceSpeed = 0,
    sensor = false,
    category = 1,
    mask = 0xffff,
    filter,
  } = options;
  requireShare(where, 'restitution', restitution);
  requireNonNegative(where, 'friction', friction, '');
  requireFinite(where, 'surfaceSpeed', surfaceSpeed, 'metres per second');
  requireInteger(where, 'category', category, 0, 0xffff);
  requireInteger(where, 'mask', mask, 0, 0xffff);
  requireFlag(where, 'sensor', sensor);
  if (filter !== undefined) requireFunction(where, 'filter', filter, 'of the slot of a particle');
}
