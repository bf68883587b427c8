import { describe } from '../../math/checks.ts';
import { allFinite } from '../../particles/finite.ts';
import type { Simulation } from '../../world/simulation.ts';
import type { Resolver } from '../resolver.ts';
import { findRestingSpeeds } from './resting-speeds.ts';
import { TwoPhases } from './two-phases.ts';

/** The limit where none is set. */
const MOST_A_CONTACT = 10_000;

/** How the severity resolver works. */
export interface SeverityOptions {
  /**
   * Most contacts to resolve in each of the two phases; `Infinity` for as many as it takes (10 000 a contact at the most, so that
   * a disc in a slot too narrow for it does not hang the step). @default twice the contacts
   */
  iterations?: number;
}

/**
 * The resolver of the thesis: forces, integration, then the contacts one by one, the most severe first, velocities before
 * penetrations (I. Millington, *Game Physics Engine Development*, 2007). Right for a handful of contacts; there is no
 * friction. Of equally severe contacts the one found first goes first. A phase ends early when no contact closes faster than
 * 10⁻⁹ m/s, or is deeper than 10⁻⁹ m.
 */
export function severity({ iterations }: SeverityOptions = {}): Resolver {
  if (iterations !== undefined && iterations !== Infinity && !(Number.isInteger(iterations) && iterations >= 0)) {
    throw new RangeError(
      `severity: iterations must be a whole number, 0 or more, or Infinity; got ${describe(iterations)}. ` +
        'Leave it out for twice the contacts.',
    );
  }
  return new SeverityResolver(iterations);
}

class SeverityResolver implements Resolver {
  readonly name = 'severity';
  readonly #iterations: number | undefined;
  readonly #phases = new TwoPhases();

  constructor(iterations: number | undefined) {
    this.#iterations = iterations;
  }

  step({ particles, forces, sources, contacts, integrate, gravity, before, time }: Simulation, dt: number): boolean {
    forces.apply(dt, time);
    if (!integrate(particles, gravity, dt)) return false;
    sources.gather(contacts, dt);
    if (contacts.count === 0) return true;
    this.#phases.begin(contacts, particles);
    findRestingSpeeds(contacts, particles, before, this.#phases.resting);
    const limit = Math.min(this.#iterations ?? contacts.count * 2, contacts.count * MOST_A_CONTACT);
    this.#phases.resolve(contacts, particles, limit);
    return allFinite(particles);
  }
}
