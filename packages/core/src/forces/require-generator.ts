import { wrong } from '../math/checks.ts';
import type { ForceGenerator } from './force-generator.ts';

/** An object with an `apply`. That of a bare function is that of every function: the likeliest slip must not pass. */
export function requireGenerator(where: string, generator: ForceGenerator): void {
  if (typeof generator === 'object' && typeof generator?.apply === 'function') return;
  const must = 'a force generator must have a method apply(particles, targets, dt, time)';
  throw wrong(where, must, generator, 'Wrap a function of one particle in forEachParticle.');
}
