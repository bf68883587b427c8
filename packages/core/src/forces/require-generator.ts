import { describe } from '../math/checks.ts';
import type { ForceGenerator } from './force-generator.ts';

/** Something with an `apply`. */
export function requireGenerator(where: string, generator: ForceGenerator): void {
  if (typeof generator?.apply !== 'function') {
    throw new TypeError(
      `${where}: a force generator must have a method apply(particles, targets, dt, time); got ${describe(generator)}.`,
    );
  }
}
