import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ContactGenerator } from '../contacts/contact-generator.ts';
import type { ContactKeeper } from '../contacts/contact-keeper.ts';
import { contactKeeper } from '../contacts/solver/make-keeper.ts';
import type { Link } from '../links/link.ts';
import { describe } from '../math/checks.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { EdgeBounds } from './edge-bounds.ts';
import { EdgePairs } from './edge-pairs.ts';
import type { EdgeSource } from './edge-source.ts';
import { EdgeTable, NONE } from './edge-table.ts';
import { EdgeTouches } from './edge-touches.ts';
import { mayTouch } from './filter.ts';

/**
 * Collision of particles with edges: with the outline of each closed body, the links of each open one, such as a chain, and whatever
 * other links are named. So boxes rest on boxes, a rope lies over a box, a ball on a bridge. Bodies that come later are found
 * too. An edge is as thick as the thinner of its two ends, and round at the ends; nothing touches where all radii are 0, but that what is
 * inside a closed body is pushed out.
 *
 * The particles of a body do not collide with its own edges, nor a particle with an edge to whose end a link joins it. The greatest
 * restitution counts, and the geometric mean of the frictions, each at the place of the touch. A link to a fixed point is no
 * edge: pin a particle there. Categories and masks count for both ends of an edge. Contacts come in the order of the slots. Under
 * `impact` edges do not collide.
 *
 * @example
 * ```ts
 * world.addContactGenerator(new EdgeContacts(world));
 * ```
 */
export class EdgeContacts implements ContactGenerator {
  readonly keeper: () => ContactKeeper = contactKeeper;
  readonly #source: EdgeSource;
  readonly #groups: Set<Link>[] = [];
  readonly #table = new EdgeTable();
  readonly #bounds = new EdgeBounds();
  readonly #pairs = new EdgePairs();
  readonly #touches = new EdgeTouches(this.#table, this.#bounds);
  #version = -1;
  #linkVersion = -1;
  #groupCount = 0;

  /** @param world - Whose bodies collide. */
  constructor(world: EdgeSource) {
    if (!Array.isArray(world?.bodies) || !Array.isArray(world.links)) {
      throw new TypeError(`EdgeContacts: it must be given the world whose bodies collide; got ${describe(world)}.`);
    }
    this.#source = world;
  }

  /**
   * Lets links collide that are of no open body, as long as they are in the world: a bridge, the frame of a crane. Links that
   * are added together do not collide with each other.
   */
  add(links: Iterable<Link>): void {
    if (typeof links?.[Symbol.iterator] !== 'function') {
      throw new TypeError(`EdgeContacts.add: links must be a list of links; got ${describe(links)}. Put it in [ ].`);
    }
    this.#groups.push(new Set(links));
  }

  /**
   * Reads x, y, vx, vy, radius, inverseMass, restitution, friction, asleep. Adds a contact for each place where a particle touches an
   * edge or one of its ends, nearly does, or will within the time that the contacts look ahead.
   */
  addContacts(particles: ParticleArrays, contacts: ContactBuffer, dt: number): void {
    if (!contacts.takesEdges) return;
    const changed = this.#isOutOfDate(particles, contacts);
    if (changed) this.#table.build(this.#source, this.#groups, particles.count);
    if (this.#table.edgeCount === 0) return;
    this.#bounds.update(particles, this.#table, contacts, dt);
    this.#pairs.update(particles, this.#table, this.#bounds, changed);
    this.#touches.begin(particles, contacts, dt);
    this.#find(particles, contacts);
  }

  #isOutOfDate({ version }: ParticleArrays, { linkVersion }: ContactBuffer): boolean {
    if (version === this.#version && linkVersion === this.#linkVersion && this.#groups.length === this.#groupCount) {
      return false;
    }
    this.#version = version;
    this.#linkVersion = linkVersion;
    this.#groupCount = this.#groups.length;
    return true;
  }

  #find(particles: ParticleArrays, contacts: ContactBuffer): void {
    const { count, x, y, inverseMass, asleep } = particles;
    const { reach, minX, minY, maxX, maxY, still } = this.#bounds;
    const { first, hull } = this.#pairs;
    const { list } = this.#touches;
    for (let i = 0; i < count; i++) {
      list.count = 0;
      if (first[i] === first[i + 1]) continue;
      const left = x[i] - reach[i];
      const right = x[i] + reach[i];
      const bottom = y[i] - reach[i];
      const top = y[i] + reach[i];
      for (let n = first[i]; n < first[i + 1]; n++) {
        const h = hull[n];
        if (right < minX[h] || left > maxX[h] || top < minY[h] || bottom > maxY[h]) continue;
        if (still[h] === 1 && (inverseMass[i] === 0 || asleep[i] === 1)) continue;
        this.#touches.find(i, h);
      }
      for (let t = 0; t < list.count; t++) this.#add(particles, contacts, i, t);
    }
  }

  /** Adds a touch of particle i to the contacts. */
  #add(particles: ParticleArrays, contacts: ContactBuffer, i: number, t: number): void {
    const { inverseMass, asleep, restitution, friction, sensor } = particles;
    const { list } = this.#touches;
    const b = list.b[t];
    const e = list.edgeEnd[t] === NONE ? b : list.edgeEnd[t];
    if (inverseMass[i] + inverseMass[b] + inverseMass[e] === 0 || asleep[i] + asleep[b] + asleep[e] === 3) return;
    if (this.#table.slots.abroad[i] === 1 && (contacts.areLinked(i, b) || contacts.areLinked(i, e))) return;
    if (!mayTouch(particles, i, b) || !mayTouch(particles, i, e)) return;
    const nx = list.normalX[t];
    const ny = list.normalY[t];
    if (sensor[i] + sensor[b] + sensor[e] > 0) {
      if (list.penetration[t] > 0) contacts.addSensor(i, b, nx, ny);
      return;
    }
    const share = list.share[t];
    const rough = friction[b] + share * (friction[e] - friction[b]);
    contacts.push(
      i,
      b,
      nx,
      ny,
      list.penetration[t],
      Math.max(restitution[i], restitution[b] + share * (restitution[e] - restitution[b])),
      rough === friction[i] ? rough : Math.sqrt(rough * friction[i]),
    );
    if (e !== b) contacts.makeEdge(e, share);
  }
}
