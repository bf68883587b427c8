import { describe } from '../../math/checks.ts';
import { allFinite } from '../../particles/finite.ts';
import type { Simulation } from '../../world/simulation.ts';
import type { Resolver } from '../resolver.ts';
import { ContactTable } from './contact-table.ts';
import { resolvePenetrations } from './resolve-penetrations.ts';
import { findRestingSpeeds, resolveVelocities } from './resolve-velocities.ts';
import { Tournament } from './tournament.ts';

/** How the severity resolver works. */
export interface SeverityOptions {
  /** Most contacts to resolve in each of the two phases; `Infinity` for no limit. @default twice the contacts */
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
  readonly #table = new ContactTable();
  readonly #tournament = new Tournament();
  #resting = new Float64Array(0);
  #shifts = { x: new Float64Array(0), y: new Float64Array(0) };

  constructor(iterations: number | undefined) {
    this.#iterations = iterations;
  }

  step({ particles, forces, sources, contacts, integrate, gravity, before, time }: Simulation, dt: number): boolean {
    forces.apply(dt, time);
    const finite = integrate(particles, gravity, dt);
    sources.gather(contacts, dt);
    if (contacts.count === 0) return finite;
    this.#prepare(contacts.count, particles.capacity);
    this.#table.build(contacts, particles.count);
    findRestingSpeeds(contacts, particles, before, this.#resting);
    const limit = this.#iterations ?? contacts.count * 2;
    resolveVelocities(contacts, particles, this.#resting, this.#table, this.#tournament, limit);
    resolvePenetrations(contacts, particles, this.#shifts, this.#table, this.#tournament, limit);
    return allFinite(particles);
  }

  #prepare(contactCount: number, capacity: number): void {
    if (this.#resting.length < contactCount) this.#resting = new Float64Array(contactCount * 2);
    if (this.#shifts.x.length === capacity) {
      this.#shifts.x.fill(0);
      this.#shifts.y.fill(0);
    } else {
      this.#shifts = { x: new Float64Array(capacity), y: new Float64Array(capacity) };
    }
  }
}
