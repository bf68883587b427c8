import { NO_EDGE, SCENERY } from '../../contacts/contact-buffer.ts';
import { growColumns } from '../../math/columns.ts';
import { particleOf } from '../../particles/end.ts';
import type { Simulation } from '../../world/simulation.ts';

/** Islands: particles that touch or are linked, directly or by others. What nothing moves joins nothing. */
export class Islands {
  /** The way to the first particle of an island. */
  readonly #table = { parent: new Int32Array(0) };

  /** Joins what touches or is linked. Reads inverseMass, the contacts and links. */
  find({ particles, contacts, sources }: Simulation): void {
    const { count, inverseMass } = particles;
    if (this.#table.parent.length < count) growColumns(this.#table, particles.capacity);
    const { parent } = this.#table;
    const { a, b, edgeEnd, impulse, penetration, margin } = contacts;
    for (let i = 0; i < count; i++) parent[i] = i;
    for (let c = 0; c < contacts.count; c++) {
      if (b[c] === SCENERY || (impulse[c] === 0 && penetration[c] < -margin)) continue;
      this.#join(a[c], b[c], inverseMass);
      if (edgeEnd[c] !== NO_EDGE) this.#join(a[c], edgeEnd[c], inverseMass);
    }
    for (const link of sources.links) {
      const first = particleOf(link.a);
      const second = particleOf(link.b);
      if (first !== undefined && second !== undefined) this.#join(first.slot, second.slot, inverseMass);
    }
  }

  /** The first particle of the island of a slot: the same for all of it. */
  firstOf(i: number): number {
    const { parent } = this.#table;
    while (parent[i] !== i) {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }

  #join(i: number, j: number, inverseMass: Float64Array): void {
    if (inverseMass[i] === 0 || inverseMass[j] === 0) return;
    const first = this.firstOf(i);
    const second = this.firstOf(j);
    if (first < second) this.#table.parent[second] = first;
    else this.#table.parent[first] = second;
  }
}
