import { SCENERY } from '../../../src/contacts/contact-buffer.ts';
import type { Resolver } from '../../../src/resolvers/resolver.ts';
import type { Simulation } from '../../../src/world/simulation.ts';

const EPSILON = 1e-9;

/** One contact, as an object. */
interface Contact {
  readonly a: number;
  readonly b: number;
  readonly nx: number;
  readonly ny: number;
  readonly penetration: number;
  readonly restitution: number;
  /** The closing speed up to which it rests. */
  readonly resting: number;
  impulse: number;
}

/**
 * The resolver as the thesis describes it, for comparison: each iteration looks at all contacts anew, finds the most severe
 * one, the first of equals, and resolves it. It costs O(n) an iteration. Nothing of the real one is used.
 */
export class PlainSeverity implements Resolver {
  readonly name = 'plain';
  readonly #limit: number | undefined;
  /** Iterations of the two phases in the last step. */
  velocityIterations = 0;
  penetrationIterations = 0;

  constructor(limit?: number) {
    this.#limit = limit;
  }

  step({ particles, forces, sources, contacts, integrate, gravity, time, before }: Simulation, dt: number): boolean {
    const { vx, vy, x, y, inverseMass, count } = particles;
    forces.apply(dt, time);
    if (!integrate(particles, gravity, dt)) return false;
    sources.gather(contacts, dt);
    const list: Contact[] = [];
    for (let c = 0; c < contacts.count; c++) {
      const [a, b, nx, ny] = [contacts.a[c], contacts.b[c], contacts.normalX[c], contacts.normalY[c]];
      const builtUp = (i: number) => (vx[i] - before.vx[i]) * nx + (vy[i] - before.vy[i]) * ny;
      const resting = 4.04 * (Math.max(0, -builtUp(a)) + (b === SCENERY ? 0 : Math.max(0, builtUp(b))));
      const [penetration, restitution] = [contacts.penetration[c], contacts.restitution[c]];
      list.push({ a, b, nx, ny, penetration, restitution, resting, impulse: 0 });
    }
    const movable = list.filter(({ a, b }) => inverseMass[a] + (b === SCENERY ? 0 : inverseMass[b]) > 0);
    const limit = this.#limit ?? list.length * 2;
    const shiftX = new Float64Array(count);
    const shiftY = new Float64Array(count);

    const change = ({ a, b, nx, ny }: Contact, ux: Float64Array, uy: Float64Array, by: number): number => {
      const [wa, wb] = [inverseMass[a], b === SCENERY ? 0 : inverseMass[b]];
      const share = by / (wa + wb);
      ux[a] += share * wa * nx;
      uy[a] += share * wa * ny;
      if (b !== SCENERY) {
        ux[b] -= share * wb * nx;
        uy[b] -= share * wb * ny;
      }
      return share;
    };
    const along = ({ a, b, nx, ny }: Contact, ux: Float64Array, uy: Float64Array): number =>
      b === SCENERY ? ux[a] * nx + uy[a] * ny : (ux[a] - ux[b]) * nx + (uy[a] - uy[b]) * ny;

    this.velocityIterations = repeat(
      movable,
      limit,
      (contact) => along(contact, vx, vy),
      (contact, velocity) => {
        const after = -velocity <= contact.resting ? 0 : -contact.restitution * velocity;
        contact.impulse += change(contact, vx, vy, after - velocity);
      },
    );
    this.penetrationIterations = repeat(
      movable,
      limit,
      (contact) => along(contact, shiftX, shiftY) - contact.penetration,
      (contact, gap) => change(contact, shiftX, shiftY, -gap),
    );
    for (let i = 0; i < count; i++) {
      x[i] += shiftX[i];
      y[i] += shiftY[i];
    }
    list.forEach((contact, c) => {
      contacts.impulse[c] = contact.impulse;
    });
    return [x, y, vx, vy].every((array) => array.subarray(0, count).every(Number.isFinite));
  }
}

/** Resolves the contact with the least number, the first of equals, again and again; returns how often. */
function repeat(
  contacts: readonly Contact[],
  limit: number,
  number: (contact: Contact) => number,
  resolve: (contact: Contact, number: number) => void,
): number {
  for (let iteration = 0; iteration < limit; iteration++) {
    let worst: Contact | undefined;
    let least = -EPSILON;
    for (const contact of contacts) {
      const value = number(contact);
      if (value < least) {
        worst = contact;
        least = value;
      }
    }
    if (worst === undefined) return iteration;
    resolve(worst, least);
  }
  return limit;
}
