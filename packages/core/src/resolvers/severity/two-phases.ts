import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { ContactTable } from './contact-table.ts';
import { EdgeEntries } from './edge-entries.ts';
import { LeastTree } from './least-tree.ts';
import { resolveMostSevereFirst } from './most-severe-first.ts';
import type { Phase } from './phase.ts';

/** Velocities, then penetrations, each by its own severity. Keeps what the two need from step to step. */
export class TwoPhases {
  /** For each contact the closing speed up to which it rests: to be written between `begin` and `resolve`. Unit: m/s. */
  resting: Float64Array = new Float64Array(0);
  readonly #table = new ContactTable();
  readonly #edges = new EdgeEntries();
  readonly #tree = new LeastTree();
  /** For each contact what a phase does without: no penetration; rest at any speed; an impulse that nobody reads. */
  #none = new Float64Array(0);
  #always = new Float64Array(0);
  #unread = new Float64Array(0);
  /** For each slot, and one more for scenery: what a phase works on, x and y in turn, and the inverse mass. */
  #u = new Float64Array(0);
  #inverseMass = new Float64Array(0);

  /** Makes room. Reads a, b, normal, inverseMass. */
  begin(contacts: ContactBuffer, { count, inverseMass }: ParticleArrays): void {
    if (this.resting.length < contacts.count) this.#reserve(contacts.count * 2);
    if (this.#inverseMass.length !== count + 1) {
      this.#u = new Float64Array(count * 2 + 2);
      this.#inverseMass = new Float64Array(count + 1);
    }
    for (let i = 0; i < count; i++) this.#inverseMass[i] = inverseMass[i];
    this.#table.build(contacts, this.#inverseMass, count);
    this.#edges.build(contacts, this.#inverseMass, count);
  }

  /**
   * Runs both phases. Reads the contacts. Writes vx, vy, then x, y, and the contacts' impulse.
   * @param limit - Most contacts to resolve in each.
   */
  resolve(contacts: ContactBuffer, { count, x, y, vx, vy }: ParticleArrays, limit: number): void {
    const u = this.#u;
    for (let i = 0; i < count; i++) {
      u[i * 2] = vx[i];
      u[i * 2 + 1] = vy[i];
    }
    this.#run(contacts, this.#none, this.resting, contacts.impulse, limit);
    for (let i = 0; i < count; i++) {
      vx[i] = u[i * 2];
      vy[i] = u[i * 2 + 1];
    }
    u.fill(0);
    this.#run(contacts, contacts.penetration, this.#always, this.#unread, limit);
    for (let i = 0; i < count; i++) {
      x[i] += u[i * 2];
      y[i] += u[i * 2 + 1];
    }
  }

  #run(
    contacts: ContactBuffer,
    penetration: Float64Array,
    resting: Float64Array,
    impulse: Float64Array,
    limit: number,
  ): void {
    const { restitution } = contacts;
    const phase: Phase = { u: this.#u, inverseMass: this.#inverseMass, penetration, resting, restitution, impulse };
    resolveMostSevereFirst(contacts, phase, this.#table, this.#edges, this.#tree, limit);
  }

  #reserve(contactCount: number): void {
    this.resting = new Float64Array(contactCount);
    this.#none = new Float64Array(contactCount);
    this.#always = new Float64Array(contactCount).fill(Infinity);
    this.#unread = new Float64Array(contactCount);
  }
}
