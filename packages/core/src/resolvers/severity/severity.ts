import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import { describe } from '../../math/checks.ts';
import { allFinite } from '../../particles/finite.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { Simulation } from '../../world/simulation.ts';
import type { Resolver } from '../resolver.ts';
import { ContactTable } from './contact-table.ts';
import { LeastTree } from './least-tree.ts';
import { resolveMostSevereFirst } from './most-severe-first.ts';
import { findRestingSpeeds } from './resting-speeds.ts';

/** Where no limit is set: what cannot be resolved, such as a disc in a slot too narrow for it, must not hang the step. */
const MOST_A_CONTACT = 10_000;

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
  readonly #tree = new LeastTree();
  /** For each contact: none, the closing speed up to which it rests, and what the phase of the penetrations has no use for. */
  #zero = new Float64Array(0);
  #resting = new Float64Array(0);
  #always = new Float64Array(0);
  #unused = new Float64Array(0);
  /** For each slot, and one more for scenery: what a phase works on, x and y in turn, and inverse mass. */
  #u = new Float64Array(2);
  #inverseMass = new Float64Array(1);

  constructor(iterations: number | undefined) {
    this.#iterations = iterations;
  }

  step({ particles, forces, sources, contacts, integrate, gravity, before }: Simulation, dt: number): boolean {
    forces.apply(dt);
    if (!integrate(particles, gravity, dt)) return false;
    sources.gather(contacts, dt);
    if (contacts.count === 0) return true;
    this.#prepare(contacts.count, particles);
    this.#table.build(contacts, this.#inverseMass, particles.count);
    findRestingSpeeds(contacts, particles, before, this.#resting);
    const limit = Math.min(this.#iterations ?? contacts.count * 2, contacts.count * MOST_A_CONTACT);
    this.#resolveVelocities(contacts, particles, limit);
    this.#resolvePenetrations(contacts, particles, limit);
    return allFinite(particles);
  }

  /** Reads the contacts, inverse masses. Writes vx, vy and the contacts' impulse. */
  #resolveVelocities(contacts: ContactBuffer, { count, vx, vy }: ParticleArrays, limit: number): void {
    const u = this.#u;
    for (let i = 0; i < count; i++) {
      u[i * 2] = vx[i];
      u[i * 2 + 1] = vy[i];
    }
    const { restitution, impulse } = contacts;
    const phase = {
      u,
      inverseMass: this.#inverseMass,
      penetration: this.#zero,
      resting: this.#resting,
      restitution,
      impulse,
    };
    resolveMostSevereFirst(contacts, phase, this.#table, this.#tree, limit);
    for (let i = 0; i < count; i++) {
      vx[i] = u[i * 2];
      vy[i] = u[i * 2 + 1];
    }
  }

  /** Reads the contacts, inverse masses. Writes x, y. */
  #resolvePenetrations(contacts: ContactBuffer, { count, x, y }: ParticleArrays, limit: number): void {
    const u = this.#u;
    u.fill(0);
    const { penetration, restitution } = contacts;
    const phase = {
      u,
      inverseMass: this.#inverseMass,
      penetration,
      resting: this.#always,
      restitution,
      impulse: this.#unused,
    };
    resolveMostSevereFirst(contacts, phase, this.#table, this.#tree, limit);
    for (let i = 0; i < count; i++) {
      x[i] += u[i * 2];
      y[i] += u[i * 2 + 1];
    }
  }

  #prepare(contactCount: number, { count, inverseMass }: ParticleArrays): void {
    if (this.#resting.length < contactCount) {
      this.#zero = new Float64Array(contactCount * 2);
      this.#resting = new Float64Array(contactCount * 2);
      this.#always = new Float64Array(contactCount * 2).fill(Infinity);
      this.#unused = new Float64Array(contactCount * 2);
    }
    if (this.#inverseMass.length !== count + 1) {
      this.#u = new Float64Array(count * 2 + 2);
      this.#inverseMass = new Float64Array(count + 1);
    }
    for (let i = 0; i < count; i++) this.#inverseMass[i] = inverseMass[i];
  }
}
