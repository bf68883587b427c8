import {
  requireFinite,
  requireFlag,
  requireInteger,
  requireMass,
  requireNonNegative,
  requireOptions,
  requirePositiveOrInfinite,
  requireShare,
} from '../math/checks.ts';
import type { ParticleStore } from './particle-store.ts';

/** What a new particle is made of. Only the position is asked for; all else has a default. */
export interface ParticleOptions {
  /** Position. Unit: m. */
  x: number;
  y: number;
  /** Velocity. Unit: m/s. @default 0 */
  vx?: number;
  vy?: number;
  /** Constant acceleration, on top of the world's gravity. Unit: m/s². @default 0 */
  ax?: number;
  ay?: number;
  /** Mass, positive; `Infinity` pins the particle: no force or impulse moves it. Unit: kg. @default 1 */
  mass?: number;
  /** Share of the velocity kept per second, 0 to 1. @default 1 */
  damping?: number;
  /** Radius of the disc, 0 or more. Unit: m. @default 0 */
  radius?: number;
  /** Share of the closing speed that a hit gives back, 0 to 1; of two that hit the greater counts. @default 0 */
  restitution?: number;
  /**
   * Coefficient of friction, static and kinetic, 0 or more; of two that touch the geometric mean counts. A particle has no angle
   * and does not roll: with friction a ball on a slope sticks or slides. @default 0
   */
  friction?: number;
  /** Time until the world removes the particle, more than 0. Unit: s. @default Infinity */
  lifetime?: number;
  /** A number of the game's own, 0 to 65535, for styles. @default 0 */
  group?: number;
  /** What it is: bits, 0 to 0xffff. Two touch if each has a bit of the other's category in its mask. @default 1 */
  category?: number;
  /** What it touches: bits, 0 to 0xffff. @default 0xffff */
  mask?: number;
  /** Whether it only tells what touches it, by `contactBegin` and `contactEnd`, and neither pushes nor is pushed. @default false */
  sensor?: boolean;
}

/** Throws the error that says what is wrong with the options, if anything is. */
export function checkParticleOptions(where: string, options: ParticleOptions): void {
  requireOptions(where, 'options', options, '{ x: 0, y: 0 }');
  const {
    vx = 0,
    vy = 0,
    ax = 0,
    ay = 0,
    mass = 1,
    damping = 1,
    radius = 0,
    restitution = 0,
    friction = 0,
    lifetime = Infinity,
    group = 0,
    category = 1,
    mask = 0xffff,
    sensor = false,
  } = options;
  requireFinite(where, 'x', options.x, 'metres');
  requireFinite(where, 'y', options.y, 'metres');
  requireFinite(where, 'vx', vx, 'metres per second');
  requireFinite(where, 'vy', vy, 'metres per second');
  requireFinite(where, 'ax', ax, 'metres per second squared');
  requireFinite(where, 'ay', ay, 'metres per second squared');
  requireMass(where, mass);
  requireShare(where, 'damping', damping, '1 keeps all of the velocity.');
  requireNonNegative(where, 'radius', radius, 'metres');
  requireShare(where, 'restitution', restitution);
  requireNonNegative(where, 'friction', friction, '');
  requirePositiveOrInfinite(where, 'lifetime', lifetime, 'seconds', 'Leave it out for a particle that stays.');
  requireInteger(where, 'group', group, 0, 65535);
  requireInteger(where, 'category', category, 0, 0xffff);
  requireInteger(where, 'mask', mask, 0, 0xffff);
  requireFlag(where, 'sensor', sensor);
}

/** Writes checked options to a new slot, and the default of whatever is left out. */
export function writeParticle(store: ParticleStore, slot: number, options: Partial<ParticleOptions>): void {
  const {
    vx = 0,
    vy = 0,
    ax = 0,
    ay = 0,
    mass = 1,
    damping = 1,
    radius = 0,
    restitution = 0,
    friction = 0,
    lifetime = Infinity,
    group = 0,
    category = 1,
    mask = 0xffff,
    sensor = false,
  } = options;
  store.vx[slot] = vx;
  store.vy[slot] = vy;
  if (ax !== 0) store.ax[slot] = ax;
  if (ay !== 0) store.ay[slot] = ay;
  store.mass[slot] = mass;
  store.inverseMass[slot] = 1 / mass;
  if (damping !== 1) store.damping[slot] = damping;
  store.radius[slot] = radius;
  store.restitution[slot] = restitution;
  store.friction[slot] = friction;
  store.group[slot] = group;
  store.category[slot] = category;
  store.mask[slot] = mask;
  store.sensor[slot] = sensor ? 1 : 0;
  store.setLifetime(slot, lifetime);
}
