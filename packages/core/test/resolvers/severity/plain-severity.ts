import { NO_EDGE, SCENERY } from '../../../src/contacts/contact-buffer.ts';
import type { Resolver } from '../../../src/resolvers/resolver.ts';
import type { Simulation } from '../../../src/world/simulation.ts';

const EPSILON = 1e-9;

/** One contact, as an object. */
interface Contact {
  readonly a: number;
  readonly b: number;
  /** The other end of the edge from `b`, else `NO_EDGE`; and where on it. */
  readonly e: number;
  readonly t: number;
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
      const [e, t] = [contacts.edgeEnd[c], contacts.edgeShare[c]];
      let ofSecond = b === SCENERY ? 0 : builtUp(b);
      if (e !== NO_EDGE) ofSecond += t * (builtUp(e) - ofSecond);
      const resting = 4.04 * (Math.max(0, -builtUp(a)) + Math.max(0, ofSecond));
      const [penetration, restitution] = [contacts.penetration[c], contacts.restitution[c]];
      list.push({ a, b, e, t, nx, ny, penetration, restitution, resting, impulse: 0 });
    }
    const weight = ({ a, b, e, t }: Contact): number => {
      if (e !== NO_EDGE) return inverseMass[a] + (1 - t) * (1 - t) * inverseMass[b] + t * t * inverseMass[e];
      return inverseMass[a] + (b === SCENERY ? 0 : inverseMass[b]);
    };
    const movable = list.filter((contact) => weight(contact) > 0);
    const limit = this.#limit ?? list.length * 2;
    const shiftX = new Float64Array(count);
    const shiftY = new Float64Array(count);

    const change = (contact: Contact, ux: Float64Array, uy: Float64Array, by: number): number => {
      const { a, b, e, t, nx, ny } = contact;
      const share = by / weight(contact);
      if (e !== NO_EDGE) {
        for (const [slot, J] of [
          [a, share],
          [b, (t - 1) * share],
          [e, -t * share],
        ]) {
          ux[slot] += J * inverseMass[slot] * nx;
          uy[slot] += J * inverseMass[slot] * ny;
        }
        return share;
      }
      const [wa, wb] = [inverseMass[a], b === SCENERY ? 0 : inverseMass[b]];
      ux[a] += share * wa * nx;
      uy[a] += share * wa * ny;
      if (b !== SCENERY) {
        ux[b] -= share * wb * nx;
        uy[b] -= share * wb * ny;
      }
      return share;
    };
    const along = ({ a, b, e, t, nx, ny }: Contact, ux: Float64Array, uy: Float64Array): number => {
      if (b === SCENERY) return ux[a] * nx + uy[a] * ny;
      if (e === NO_EDGE) return (ux[a] - ux[b]) * nx + (uy[a] - uy[b]) * ny;
      return (ux[a] - (ux[b] + t * (ux[e] - ux[b]))) * nx + (uy[a] - (uy[b] + t * (uy[e] - uy[b]))) * ny;
    };

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
