import { DiscContacts } from '../../collision/disc-contacts.ts';
import { type ContactBuffer, SCENERY } from '../../contacts/contact-buffer.ts';
import type { ContactSources } from '../../contacts/contact-sources.ts';
import type { ParticleStore } from '../../particles/particle-store.ts';
import type { Simulation } from '../../world/simulation.ts';
import { Complementarity } from './complementarity.ts';
import type { Flight } from './flight.ts';
import { Places } from './places.ts';
import { slackOf } from './slack.ts';
import type { Touches } from './touches.ts';

/** Two closer than this share of the radius touch as the step ends: links may press them together. */
const TOUCHING = 1e-6;

/** What counts as still and as separated. Unit: m/s, m. */
const STILL = 1e-13;
const SEPARATED = 1e-15;

/** A contact rests, as under severity, up to the closing speed of two steps' acceleration, and a little for rounding. */
const RESTING_SLACK = 2.02;

/** Touches as the step ends: those that are, those that were earlier in the step, and pairs that are only near. */
type Which = 'now' | 'earlier' | 'near';

/**
 * What is put right as a step ends: links and a game's own contacts, in velocity and position, together with what touches; and
 * what overlaps. All at once, not one after the other, so that a structure of rods holds together.
 */
export class Corrections {
  readonly #flight: Flight;
  readonly #touches: Touches;
  readonly #places = new Places();
  readonly #complementarity = new Complementarity();
  /** Of each touch: its index among the contacts, or -1. */
  #contact = new Int32Array(0);
  /** Of each contact. */
  #list = new Int32Array(0);
  #bias = new Float64Array(0);
  #pushes = new Float64Array(0);
  readonly #velocity: { x: Float64Array; y: Float64Array } = { x: new Float64Array(0), y: new Float64Array(0) };
  #shifts = { x: new Float64Array(0), y: new Float64Array(0) };

  constructor(flight: Flight, touches: Touches) {
    this.#flight = flight;
    this.#touches = touches;
  }

  /**
   * Lists first the contacts of links and of a game's own generators, then what touches, then what touched earlier in the
   * step; puts right the first two.
   * @param crowded - Whether slow touches had to wait for the end of the step.
   * Reads the touches. Writes the contacts, x, y, vx, vy.
   */
  apply({ particles, sources, contacts }: Simulation, dt: number, crowded: boolean): void {
    this.#measure(particles, sources);
    contacts.clear(particles.count, sources.linkedPairs());
    gatherOthers(particles, sources, contacts, dt);
    const others = contacts.count;
    this.#report(particles, sources, contacts, 'now');
    const together = contacts.count;
    this.#report(particles, sources, contacts, 'earlier');
    const { count, leftOut } = contacts;
    if (crowded) this.#report(particles, sources, contacts, 'near');
    this.#reserve(contacts.count);
    if (others > 0 || crowded) this.#still(particles, contacts, together, dt, crowded);
    this.#separate(particles, contacts, others);
    contacts.count = count;
    contacts.leftOut = leftOut;
    for (let t = 0; t < this.#touches.count; t++) {
      const c = this.#contact[t];
      if (c >= 0) contacts.impulse[c] += this.#touches.impulse[t];
    }
  }

  /** Finds the gap of each touch, and the normal between two discs, at the end of the step. */
  #measure(particles: ParticleStore, sources: ContactSources): void {
    const touches = this.#touches;
    const { count, a, b, gap, source, normalX, normalY } = touches;
    const { x, y, radius } = particles;
    if (this.#contact.length < count) this.#contact = new Int32Array(a.length);
    this.#contact.fill(-1, 0, count);
    for (let t = 0; t < count; t++) {
      const i = a[t];
      touches.measure(t, particles);
      if (b[t] !== SCENERY) continue;
      const shape = sources.shapes.list[source[t] - sources.links.length];
      gap[t] = this.#places.gapAt(shape, x[i], y[i], radius[i], normalX[t], normalY[t]);
    }
  }

  /** Lists one kind of touches. Reads the gaps. Adds contacts. */
  #report(
    { radius, restitution }: ParticleStore,
    sources: ContactSources,
    contacts: ContactBuffer,
    which: Which,
  ): void {
    const touches = this.#touches;
    const { count, a, b, gap, source, impulse } = touches;
    const normalX = which === 'earlier' ? touches.hitX : touches.normalX;
    const normalY = which === 'earlier' ? touches.hitY : touches.normalY;
    for (let t = 0; t < count; t++) {
      const i = a[t];
      const j = b[t];
      const reach = TOUCHING * (j === SCENERY ? radius[i] : Math.min(radius[i], radius[j]));
      const is = gap[t] <= reach ? 'now' : impulse[t] === 0 ? 'near' : 'earlier';
      if (is !== which) continue;
      const other = j === SCENERY ? sources.shapes.list[source[t] - sources.links.length].restitution : restitution[j];
      contacts.currentSource = source[t];
      const c = contacts.count;
      contacts.push(i, j, normalX[t], normalY[t], -gap[t], Math.max(restitution[i], other));
      if (contacts.count > c && which !== 'near') this.#contact[t] = c;
    }
  }

  /** Each contact that closes opens as its restitution says, or is still where it rests. Writes vx, vy and impulses. */
  #still(
    { vx, vy, inverseMass }: ParticleStore,
    contacts: ContactBuffer,
    count: number,
    dt: number,
    crowded: boolean,
  ): void {
    const { a, b, normalX, normalY, restitution, impulse } = contacts;
    const { freeX, freeY } = this.#flight;
    for (let c = 0; c < count; c++) {
      const i = a[c];
      const j = b[c];
      const nx = normalX[c];
      const ny = normalY[c];
      let velocity = vx[i] * nx + vy[i] * ny;
      let slowest = Math.max(0, -(freeX[i] * nx + freeY[i] * ny));
      if (j !== SCENERY) {
        velocity -= vx[j] * nx + vy[j] * ny;
        slowest += Math.max(0, freeX[j] * nx + freeY[j] * ny);
      }
      if (crowded) slowest = Math.max(slowest, this.#flight.stepSpeed(i) / dt);
      this.#bias[c] = -velocity > slowest * dt * RESTING_SLACK ? restitution[c] * velocity : 0;
    }
    this.#velocity.x = vx;
    this.#velocity.y = vy;
    this.#complementarity.solve(contacts, this.#list, count, inverseMass, this.#velocity, impulse, this.#bias, STILL);
  }

  /** Moves apart what overlaps by more than rounding, and holds links to their lengths. Writes x, y. */
  #separate(
    { count, capacity, x, y, inverseMass, radius }: ParticleStore,
    contacts: ContactBuffer,
    others: number,
  ): void {
    const { a, b, penetration } = contacts;
    let overlaps = others > 0;
    for (let c = 0; c < contacts.count; c++) {
      const smaller = b[c] === SCENERY ? radius[a[c]] : Math.min(radius[a[c]], radius[b[c]]);
      this.#bias[c] = -penetration[c];
      this.#pushes[c] = 0;
      overlaps ||= penetration[c] > slackOf(smaller) / 2;
    }
    if (!overlaps) return;
    if (this.#shifts.x.length === capacity) {
      this.#shifts.x.fill(0);
      this.#shifts.y.fill(0);
    } else {
      this.#shifts = { x: new Float64Array(capacity), y: new Float64Array(capacity) };
    }
    const shifts = this.#shifts;
    const pushes = this.#pushes;
    this.#complementarity.solve(
      contacts,
      this.#list,
      contacts.count,
      inverseMass,
      shifts,
      pushes,
      this.#bias,
      SEPARATED,
    );
    for (let i = 0; i < count; i++) {
      x[i] += shifts.x[i];
      y[i] += shifts.y[i];
    }
  }

  #reserve(contactCount: number): void {
    if (this.#list.length >= contactCount) return;
    this.#list = new Int32Array(contactCount * 2);
    this.#bias = new Float64Array(contactCount * 2);
    this.#pushes = new Float64Array(contactCount * 2);
    for (let c = 0; c < contactCount * 2; c++) this.#list[c] = c;
  }
}

/** Finds the contacts of links and of a game's own generators: of all that is not settled on the way; and what sensors find. */
function gatherOthers(particles: ParticleStore, sources: ContactSources, contacts: ContactBuffer, dt: number): void {
  const { links } = sources;
  const generators = sources.generators.list;
  for (let l = 0; l < links.length; l++) {
    contacts.currentSource = l;
    links[l].addContacts(particles, contacts, dt);
  }
  sources.findSensors(contacts, dt);
  contacts.takesEdges = false;
  for (let g = 0; g < generators.length; g++) {
    if (generators[g] instanceof DiscContacts) continue;
    contacts.currentSource = links.length + sources.shapes.list.length + g;
    generators[g].addContacts(particles, contacts, dt);
  }
}
