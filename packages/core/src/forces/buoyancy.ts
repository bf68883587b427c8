import { requireFinite, requireNonNegative, requireOptions, requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';
import { type Hull, HullTable } from './hull-table.ts';

/** The height of a liquid's surface at a place and a time, in m and s: waves. See `travellingWave`. */
export type LiquidLevel = (x: number, time: number) => number;

/** What a liquid is made of. */
export interface BuoyancyOptions {
  /** Height of the surface, or a function of place and time that gives it. Unit: m. @default 0 */
  level?: number | LiquidLevel;
  /** Density of the liquid, 0 or more. Unit: kg/m³. @default 1000, water */
  density?: number;
  /** Weight of each kilogram, 0 or more; up is the direction of +y. Unit: m/s². @default 9.81 */
  g?: number;
  /** Drag of what is wholly under, growing with the speed. Unit: N·s/m. @default 0 */
  k1?: number;
  /** Drag of what is wholly under, growing with the square of the speed. Unit: N·s²/m². @default 0 */
  k2?: number;
  /** Velocity of the liquid, which its drag takes along what floats in it. Unit: m/s. @default { x: 0, y: 0 } */
  flow?: Readonly<Vec2>;
}

/**
 * Buoyancy in a liquid with a surface. Of a particle at y with the volume V and half the height s (its max depth) the share
 * d = (level + s - y) / 2s, clamped to 0 and 1, is under; the force is d·ρ·V·g up. Exact for an upright box of the height
 * 2s and the area A = V / 2s: it floats m / (ρ·A) deep and bobs with the period 2π·√(m / (ρ·A·g)).
 *
 * A particle is a disc 1 m thick, V = π·r² and s = r, unless `setHull` says otherwise; a point has no volume and no force.
 * Drag is in proportion to d too, and never more than what brings the particle to rest in the liquid within the step.
 *
 * @example
 * ```ts
 * const water = world.addForce(new Buoyancy({ level: 0, density: 1000, k1: 2 }), [crate, ball]);
 * water.setHull(crate, { volume: 0.001, maxDepth: 0.05 });
 * ```
 */
export class Buoyancy implements ForceGenerator {
  readonly g: number;
  readonly k1: number;
  readonly k2: number;
  readonly flow: Readonly<Vec2>;
  readonly #hulls = new HullTable();
  #level: number | LiquidLevel;
  #density: number;
  #time = 0;

  constructor(options: BuoyancyOptions = {}) {
    requireOptions('Buoyancy', 'options', options, '{ level: 0, density: 1000 }');
    const { level = 0, density = 1000, g = 9.81, k1 = 0, k2 = 0, flow = { x: 0, y: 0 } } = options;
    if (typeof level !== 'function') requireFinite('Buoyancy', 'level', level, 'metres', 'Or give a function.');
    requireNonNegative('Buoyancy', 'density', density, 'kilograms per cubic metre');
    requireNonNegative('Buoyancy', 'g', g, 'metres per second squared');
    requireNonNegative('Buoyancy', 'k1', k1, 'newton-seconds per metre');
    requireNonNegative('Buoyancy', 'k2', k2, 'newton-seconds squared per square metre');
    requireVector('Buoyancy', 'flow', flow, 'metres per second');
    this.g = g;
    this.k1 = k1;
    this.k2 = k2;
    this.flow = Object.freeze({ x: flow.x, y: flow.y });
    this.#level = level;
    this.#density = density;
  }

  /** Height of the surface, or the function that gives it. Unit: m. */
  get level(): number | LiquidLevel {
    return this.#level;
  }
  set level(value: number | LiquidLevel) {
    if (typeof value !== 'function') requireFinite('Buoyancy.level', 'level', value, 'metres', 'Or give a function.');
    this.#level = value;
  }

  /** Density of the liquid, 0 or more. Unit: kg/m³. */
  get density(): number {
    return this.#density;
  }
  set density(value: number) {
    requireNonNegative('Buoyancy.density', 'density', value, 'kilograms per cubic metre');
    this.#density = value;
  }

  /** Says what of a particle displaces liquid, in place of the disc of its radius. It is forgotten with the particle. */
  setHull(particle: Particle, hull: Readonly<Hull>): void {
    this.#hulls.set('Buoyancy.setHull', particle, hull);
  }

  /** What of a particle displaces liquid. */
  hullOf(particle: Particle): Readonly<Hull> {
    return this.#hulls.get(particle);
  }

  /** The particles that were given a hull, and theirs. */
  get hulls(): ReadonlyMap<Particle, Readonly<Hull>> {
    return this.#hulls.map;
  }

  /** Height of the surface at a place, after the last step; for drawing. Unit: m. */
  levelAt(x: number): number {
    const level = this.#level;
    return typeof level === 'function' ? level(x, this.#time) : level;
  }

  /** Share of a particle's height that is under the surface now, 0 to 1; of a point 0 or 1. */
  submergedShare(particle: Particle): number {
    const depth = this.levelAt(particle.x) - particle.y;
    const { maxDepth } = this.hullOf(particle);
    return maxDepth === 0 ? (depth > 0 ? 1 : 0) : submerged(depth, maxDepth);
  }

  /** Buoyant force on a particle now, upwards, without drag. Unit: N. */
  force(particle: Particle): number {
    return this.submergedShare(particle) * this.#density * this.hullOf(particle).volume * this.g;
  }

  /** Reads x, y, vx, vy, mass, radius. Adds to fx, fy. */
  apply(particles: ParticleArrays, { slots, count }: ForceTargets, dt: number, time: number): void {
    const { x, y, vx, vy, mass, radius, fx, fy } = particles;
    const { volume, maxDepth } = this.#hulls.refresh(particles);
    const { k1, k2, flow } = this;
    const level = this.#level;
    const weight = this.#density * this.g;
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      const own = volume[i];
      const r = radius[i];
      const s = own === 0 ? r : maxDepth[i];
      if (s === 0) continue;
      const surface = typeof level === 'function' ? level(x[i], time) : level;
      const share = submerged(surface - y[i], s);
      if (share === 0) continue;
      const ux = vx[i] - flow.x;
      const uy = vy[i] - flow.y;
      const k = Math.min(share * (k1 + k2 * Math.sqrt(ux * ux + uy * uy)), mass[i] / dt);
      const lift = share * weight * (own === 0 ? Math.PI * r * r : own);
      fx[i] -= k * ux;
      fy[i] += lift - k * uy;
    }
    this.#time = time + dt;
  }
}

/** Share of the height 2s that is under, with the middle at a depth. */
function submerged(depth: number, s: number): number {
  return Math.max(0, Math.min(1, (depth + s) / (2 * s)));
}
