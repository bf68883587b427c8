import {
  requireFinite,
  requireNonNegative,
  requireOptions,
  requirePositive,
  requireVector,
  wrong,
} from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';

/** A fixed point that attracts. */
export interface Attractor extends Vec2 {
  /** Mass, positive and finite. Unit: kg. */
  mass: number;
}

/** How particles attract. */
export interface AttractionOptions {
  /** The gravitational constant; negative repels. Unit: N·m²/kg². @default 6.6743e-11, nature's */
  G?: number;
  /**
   * Distance below which the force fades away instead of growing, so that close passes stay tame; 0 for the plain law.
   * Unit: m. @default 0
   */
  softening?: number;
  /** Fixed points that attract the particles, which then do not attract one another. @default none */
  to?: Iterable<Readonly<Attractor>>;
}

/** Closer than 10⁻¹⁰⁰ m counts as coincident, so that one over the square of the distance is a number. */
const COINCIDENT = 1e-200;

/**
 * Gravity between point masses, f = G·m₁·m₂·r / (r² + ε²)^(3/2): G·m₁·m₂ / r² where the softening ε is 0 (H. C. Plummer,
 * 1911). Every target attracts every other, each pair with forces equal and opposite; or, with `to`, fixed points attract
 * the targets. Coincident particles define no direction and feel none; an infinite mass neither attracts nor feels any.
 *
 * n particles take n·(n - 1) / 2 pairs: fine for some hundreds. For many that circle a few, use `to`.
 *
 * @example
 * ```ts
 * world.addForce(new Attraction({ G: 1, softening: 0.05 }), [sun, earth, moon]);
 * world.addForce(new Attraction({ G: 1, to: [{ x: 0, y: 0, mass: 1000 }] }), dust);
 * ```
 */
export class Attraction implements ForceGenerator {
  readonly G: number;
  readonly softening: number;
  /** The fixed points that attract; empty where particles attract one another. */
  readonly to: readonly Readonly<Attractor>[];
  readonly #mutual: boolean;

  constructor(options: AttractionOptions = {}) {
    requireOptions('Attraction', 'options', options, '{ G: 1 }');
    const { G = 6.6743e-11, softening = 0, to } = options;
    requireFinite('Attraction', 'G', G, 'newton square metres per square kilogram');
    requireNonNegative('Attraction', 'softening', softening, 'metres');
    this.G = G;
    this.softening = softening;
    this.to = to === undefined ? [] : checkedAttractors(to);
    this.#mutual = to === undefined;
  }

  /** Reads x, y, mass, inverseMass. Adds to fx, fy. */
  apply(particles: ParticleArrays, targets: ForceTargets): void {
    if (this.#mutual) this.#attractEachOther(particles, targets);
    else for (let p = 0; p < this.to.length; p++) this.#attractTo(this.to[p], particles, targets);
  }

  #attractEachOther({ x, y, mass, inverseMass, fx, fy }: ParticleArrays, { slots, count }: ForceTargets): void {
    const { G } = this;
    const softening2 = this.softening * this.softening;
    for (let s = 0; s < count; s++) {
      const i = slots[s];
      if (inverseMass[i] === 0) continue;
      const xi = x[i];
      const yi = y[i];
      const strength = G * mass[i];
      let sumX = 0;
      let sumY = 0;
      for (let t = s + 1; t < count; t++) {
        const j = slots[t];
        if (inverseMass[j] === 0) continue;
        const dx = x[j] - xi;
        const dy = y[j] - yi;
        const r2 = dx * dx + dy * dy + softening2;
        if (r2 < COINCIDENT) continue;
        const f = (strength * mass[j]) / (r2 * Math.sqrt(r2));
        sumX += f * dx;
        sumY += f * dy;
        fx[j] -= f * dx;
        fy[j] -= f * dy;
      }
      fx[i] += sumX;
      fy[i] += sumY;
    }
  }

  #attractTo(
    { x: px, y: py, mass: centre }: Readonly<Attractor>,
    { x, y, mass, inverseMass, fx, fy }: ParticleArrays,
    { slots, count }: ForceTargets,
  ): void {
    const strength = this.G * centre;
    const softening2 = this.softening * this.softening;
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      if (inverseMass[i] === 0) continue;
      const dx = px - x[i];
      const dy = py - y[i];
      const r2 = dx * dx + dy * dy + softening2;
      if (r2 < COINCIDENT) continue;
      const f = (strength * mass[i]) / (r2 * Math.sqrt(r2));
      fx[i] += f * dx;
      fy[i] += f * dy;
    }
  }
}

function checkedAttractors(to: Iterable<Readonly<Attractor>>): readonly Readonly<Attractor>[] {
  if (typeof to?.[Symbol.iterator] !== 'function') {
    throw wrong('Attraction', 'to must be a list of fixed points { x, y, mass }', to, 'Put it in [ ].');
  }
  return Object.freeze(
    Array.from(to, (point) => {
      if (point instanceof Particle) {
        throw new TypeError(
          'Attraction: to must be fixed points { x, y, mass }; got a particle. Name it among the particles of World.addForce.',
        );
      }
      requireVector('Attraction', 'a point of to', point, 'metres');
      requirePositive('Attraction', 'the mass of a point', point.mass, 'kilograms');
      return Object.freeze({ x: point.x, y: point.y, mass: point.mass });
    }),
  );
}
