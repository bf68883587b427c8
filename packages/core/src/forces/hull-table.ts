import { requireOptions, requirePositive } from '../math/checks.ts';
import { requireParticle } from '../particles/membership.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';

/** What of a particle displaces liquid. */
export interface Hull {
  /** Volume, positive. Unit: m³. */
  volume: number;
  /** Depth of the centre at which it is wholly under, positive: half its height. Unit: m. */
  maxDepth: number;
}

/** Hulls that a game gave to particles, by slot; a volume of 0 stands for none. */
export class HullTable {
  volume: Float64Array = new Float64Array(0);
  maxDepth: Float64Array = new Float64Array(0);
  readonly #hulls = new Map<Particle, Readonly<Hull>>();
  #particles: ParticleArrays | undefined;
  #version = -1;

  /** What was set; a particle that is gone is forgotten with the next refresh. */
  get map(): ReadonlyMap<Particle, Readonly<Hull>> {
    return this.#hulls;
  }

  /** Gives a particle a hull of its own. */
  set(where: string, particle: Particle, hull: Readonly<Hull>): void {
    requireParticle(where, particle);
    if (!particle.alive) throw new Error(`${where}: the particle must be in its world; it was removed.`);
    requireOptions(where, 'hull', hull, '{ volume: 0.001, maxDepth: 0.05 }');
    requirePositive(where, 'volume', hull.volume, 'cubic metres');
    requirePositive(where, 'maxDepth', hull.maxDepth, 'metres');
    this.#hulls.set(particle, Object.freeze({ volume: hull.volume, maxDepth: hull.maxDepth }));
    this.#particles = undefined;
  }

  /** The hull that a particle was given, or the disc of its radius, 1 m thick. */
  get(particle: Particle): Readonly<Hull> {
    const { radius } = particle;
    return this.#hulls.get(particle) ?? { volume: Math.PI * radius * radius, maxDepth: radius };
  }

  /** Brings the table up to date when particles came or went, and forgets the hulls of those that went. */
  refresh(particles: ParticleArrays): this {
    if (this.#particles === particles && this.#version === particles.version) return this;
    this.#particles = particles;
    this.#version = particles.version;
    const capacity = particles.x.length;
    if (this.volume.length < capacity) {
      this.volume = new Float64Array(capacity);
      this.maxDepth = new Float64Array(capacity);
    } else {
      this.volume.fill(0);
    }
    for (const [particle, { volume, maxDepth }] of this.#hulls) {
      if (!particle.alive) this.#hulls.delete(particle);
      if (!particle.isIn(particles)) continue;
      this.volume[particle.slot] = volume;
      this.maxDepth[particle.slot] = maxDepth;
    }
    return this;
  }
}
