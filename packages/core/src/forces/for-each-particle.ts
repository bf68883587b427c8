import { requireFunction } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';

/**
 * A force generator from a function that is called once for each particle (the thesis's `updateForce(particle, dt)`).
 *
 * @example
 * ```ts
 * world.addForce(forEachParticle((particle) => particle.applyForce(0, 5 - particle.y)), [balloon]);
 * ```
 */
export function forEachParticle(updateForce: (particle: Particle, dt: number) => void): ForceGenerator {
  requireFunction('forEachParticle', 'updateForce', updateForce, 'of a particle and the duration of the step');
  return new ForEachParticle(updateForce);
}

class ForEachParticle implements ForceGenerator {
  readonly #updateForce: (particle: Particle, dt: number) => void;

  constructor(updateForce: (particle: Particle, dt: number) => void) {
    this.#updateForce = updateForce;
  }

  apply(_particles: ParticleArrays, targets: ForceTargets, dt: number): void {
    const updateForce = this.#updateForce;
    for (let t = 0; t < targets.count; t++) updateForce(targets.particle(t), dt);
  }
}
