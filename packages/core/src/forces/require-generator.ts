import { describe } from '../math/checks.ts';
import type { ForceGenerator } from './force-generator.ts';

/** An object with an `apply`. That of a bare function is that of every function: the likeliest slip must not pass. */
export function requireGenerator(where: string, generator: ForceGenerator): void {
  if (typeof generator === 'object' && typeof generator?.apply === 'function') return;
  throw new TypeError(
    `${where}: a force generator must have a method apply(particles, targets, dt, time); got ${describe(generator)}. ` +
      'Wrap a function of one particle in forEachParticle.',
  );
}
