/**
 * The motion of some particles, seen as one rigid body. Where particles are pinned (infinite mass) they alone say where the
 * centre is and how it moves: a single one is a pivot, about which the others turn; two stop every rotation.
 */
import type { ParticleArrays } from '../particles/particle-arrays.ts';

/** A share of a step's way from the last position to this one: 1 is now. */
const NOW = 1;

/** Sum of the masses. Unit: kg. */
export function massOf({ mass }: ParticleArrays, slots: readonly number[]): number {
  let sum = 0;
  for (const slot of slots) sum += mass[slot];
  return sum;
}

/** Mean of a quantity, weighted by mass: of positions the centre of mass, of velocities its velocity. */
export function meanOf(
  values: Float64Array,
  particles: ParticleArrays,
  slots: readonly number[],
  previous: Float64Array = values,
  alpha: number = NOW,
): number {
  const { mass } = particles;
  let sum = 0;
  let total = 0;
  let pinnedSum = 0;
  let pinned = 0;
  for (const slot of slots) {
    const value = between(previous, values, slot, alpha);
    if (mass[slot] === Infinity) {
      pinnedSum += value;
      pinned++;
    } else {
      sum += mass[slot] * value;
      total += mass[slot];
    }
  }
  return pinned > 0 ? pinnedSum / pinned : sum / total;
}

/** Moment of inertia about the centre, Σ m·r². Infinite where a pinned particle is off the centre. Unit: kg·m². */
export function inertiaOf(particles: ParticleArrays, slots: readonly number[]): number {
  const { x, y, mass } = particles;
  const cx = meanOf(x, particles, slots);
  const cy = meanOf(y, particles, slots);
  let sum = 0;
  for (const slot of slots) {
    const rx = x[slot] - cx;
    const ry = y[slot] - cy;
    if (rx !== 0 || ry !== 0) sum += mass[slot] * (rx * rx + ry * ry);
  }
  return sum;
}

/** Angular velocity: angular momentum about the centre, Σ r × m·(v - V), over the inertia. Unit: rad/s. */
export function angularVelocityOf(particles: ParticleArrays, slots: readonly number[]): number {
  const { x, y, vx, vy, mass } = particles;
  const cx = meanOf(x, particles, slots);
  const cy = meanOf(y, particles, slots);
  const ux = meanOf(vx, particles, slots);
  const uy = meanOf(vy, particles, slots);
  let momentum = 0;
  for (const slot of slots) {
    if (mass[slot] === Infinity) continue;
    momentum += mass[slot] * ((x[slot] - cx) * (vy[slot] - uy) - (y[slot] - cy) * (vx[slot] - ux));
  }
  const inertia = inertiaOf(particles, slots);
  return inertia === 0 ? 0 : momentum / inertia;
}

/** Kinetic energy of the particles that can move, Σ m·v²/2. Unit: J. */
export function kineticEnergyOf({ vx, vy, mass }: ParticleArrays, slots: readonly number[]): number {
  let sum = 0;
  for (const slot of slots) {
    if (mass[slot] !== Infinity) sum += (mass[slot] * (vx[slot] * vx[slot] + vy[slot] * vy[slot])) / 2;
  }
  return sum;
}

/** What an impulse or a force at a point gives to each particle. */
export interface Push {
  /** The impulse or force. Unit: N·s or N. */
  readonly x: number;
  readonly y: number;
  /** Where it acts. Unit: m. */
  readonly atX: number;
  readonly atY: number;
}

/**
 * Adds to each particle what a rigid body's would get of an impulse J at a distance r from the centre:
 * Δv_i = J/M + (r × J/I) × r_i. Momentum changes by J and angular momentum by r × J, whatever the masses: the first sum over
 * m_i is J since Σ m_i·r_i = 0, the second r × J since I = Σ m_i·r_i². A force is the same times m_i.
 * Reads x, y, mass. Adds to the two arrays.
 */
export function spread(
  push: Push,
  particles: ParticleArrays,
  slots: readonly number[],
  [toX, toY]: readonly [Float64Array, Float64Array],
  timesMass: boolean,
): void {
  const { x, y, mass } = particles;
  const total = massOf(particles, slots);
  const inertia = inertiaOf(particles, slots);
  const cx = meanOf(x, particles, slots);
  const cy = meanOf(y, particles, slots);
  const torque = (push.atX - cx) * push.y - (push.atY - cy) * push.x;
  const turn = inertia === 0 ? 0 : torque / inertia;
  for (const slot of slots) {
    if (mass[slot] === Infinity) continue;
    const factor = timesMass ? mass[slot] : 1;
    toX[slot] += factor * (push.x / total - turn * (y[slot] - cy));
    toY[slot] += factor * (push.y / total + turn * (x[slot] - cx));
  }
}

/**
 * The rotation that brings a shape nearest to where its points are now, in least squares (B. Horn, *Closed-form solution of
 * absolute orientation*, 1987; in the plane it is one arc tangent). Drawing alone uses it, never a step: the last bit of
 * `Math.atan2` is left to the engine. Unit: rad, -π to π.
 */
export function rotationOf(
  shape: Readonly<Record<'x' | 'y', Float64Array>>,
  indices: readonly number[],
  particles: ParticleArrays,
  slots: readonly number[],
  alpha: number = NOW,
): number {
  const { x, y, previousX, previousY } = particles;
  let shapeX = 0;
  let shapeY = 0;
  let nowX = 0;
  let nowY = 0;
  for (let i = 0; i < slots.length; i++) {
    shapeX += shape.x[indices[i]] / slots.length;
    shapeY += shape.y[indices[i]] / slots.length;
    nowX += between(previousX, x, slots[i], alpha) / slots.length;
    nowY += between(previousY, y, slots[i], alpha) / slots.length;
  }
  let sine = 0;
  let cosine = 0;
  for (let i = 0; i < slots.length; i++) {
    const qx = shape.x[indices[i]] - shapeX;
    const qy = shape.y[indices[i]] - shapeY;
    const rx = between(previousX, x, slots[i], alpha) - nowX;
    const ry = between(previousY, y, slots[i], alpha) - nowY;
    sine += qx * ry - qy * rx;
    cosine += qx * rx + qy * ry;
  }
  return Math.atan2(sine, cosine);
}

function between(previous: Float64Array, now: Float64Array, slot: number, alpha: number): number {
  return alpha === NOW ? now[slot] : previous[slot] + (now[slot] - previous[slot]) * alpha;
}
