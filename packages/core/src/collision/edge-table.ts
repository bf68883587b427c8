import type { Link } from '../links/link.ts';
import { growColumns } from '../math/columns.ts';
import { particleOf } from '../particles/end.ts';
import type { EdgeSource, Outline } from './edge-source.ts';

/** No edge, no hull, no owner. */
export const NONE = -1;

/**
 * The edges that collide, sorted into hulls: a ring of edges around a body, or a single edge that is open on both sides. Which
 * edges a particle is an end of, and to whom it belongs. It changes only when a particle, body or link comes or goes.
 */
export class EdgeTable {
  edgeCount = 0;
  hullCount = 0;
  /** Slots of the ends of each edge. */
  readonly edges: { start: Int32Array; end: Int32Array } = { start: new Int32Array(64), end: new Int32Array(64) };
  /** Of each hull its first edge, where the last is that of the next hull; whether it is a ring; whose it is. */
  readonly hulls: { first: Int32Array; ring: Uint8Array; owner: Int32Array } = {
    first: new Int32Array(64),
    ring: new Uint8Array(64),
    owner: new Int32Array(64),
  };
  /**
   * Of each slot: whose it is; the ring that it is a corner of; the first edge that it is an end of; where its neighbours
   * along edges begin; whether a link joins it to a particle of somebody else.
   */
  readonly slots: {
    owner: Int32Array;
    ring: Int32Array;
    home: Int32Array;
    firstNeighbour: Int32Array;
    abroad: Uint8Array;
  } = {
    owner: new Int32Array(64),
    ring: new Int32Array(64),
    home: new Int32Array(64),
    firstNeighbour: new Int32Array(65),
    abroad: new Uint8Array(64),
  };
  /** The other ends of the edges of each slot. */
  neighbour: Int32Array = new Int32Array(0);
  #owners = 0;

  /**
   * Finds all edges anew.
   * @param groups - Links that collide on their own, in groups that do not collide within.
   */
  build({ bodies, links }: EdgeSource, groups: readonly ReadonlySet<Link>[], slotCount: number): void {
    if (this.slots.owner.length < slotCount) {
      growColumns(this.slots, slotCount * 2 + 1);
    }
    this.slots.owner.fill(NONE);
    this.slots.ring.fill(NONE);
    this.slots.home.fill(NONE);
    this.edgeCount = 0;
    this.hullCount = 0;
    this.#owners = 0;
    this.#addBodies(bodies, links);
    for (const group of groups) {
      this.#addLinks(links.filter((link) => group.has(link)));
      this.#owners++;
    }
    this.#joinNeighbours(slotCount);
    this.#findAbroad(links);
  }

  #addBodies(bodies: readonly Outline[], links: readonly Link[]): void {
    const left = bodies.every(({ closed }) => closed) ? undefined : new Set(links);
    for (const body of bodies) {
      const { particles } = body;
      for (const { slot } of particles) this.slots.owner[slot] = this.#owners;
      if (body.closed) this.#addRing(particles);
      else if (left !== undefined) this.#addLinks(body.linksAmong(left));
      this.#owners++;
    }
  }

  /** Two particles make one open edge. */
  #addRing(particles: readonly { readonly slot: number }[]): void {
    const { length } = particles;
    if (length < 2) return;
    const first = this.edgeCount;
    for (let p = 0; p < length; p++) {
      const { slot } = particles[p];
      this.#addEdge(slot, particles[p + 1 === length ? 0 : p + 1].slot);
      if (length === 2) break;
      this.slots.ring[slot] = this.hullCount;
    }
    this.#addHull(first, length > 2);
  }

  #addLinks(links: readonly Link[]): void {
    for (const { a, b } of links) {
      const start = particleOf(a);
      const end = particleOf(b);
      if (start === undefined || end === undefined) continue;
      const first = this.edgeCount;
      this.#addEdge(start.slot, end.slot);
      this.#addHull(first, false);
      for (const { slot } of [start, end]) {
        if (this.slots.owner[slot] === NONE) this.slots.owner[slot] = this.#owners;
      }
    }
  }

  #addEdge(start: number, end: number): void {
    const { edges } = this;
    if (this.edgeCount === edges.start.length) growColumns(edges, this.edgeCount * 2);
    edges.start[this.edgeCount] = start;
    edges.end[this.edgeCount] = end;
    for (const slot of [start, end]) {
      if (this.slots.home[slot] === NONE) this.slots.home[slot] = this.edgeCount;
    }
    this.edgeCount++;
  }

  #addHull(first: number, ring: boolean): void {
    const { hulls } = this;
    if (this.hullCount + 1 === hulls.first.length) growColumns(hulls, this.hullCount * 4);
    hulls.first[this.hullCount] = first;
    hulls.ring[this.hullCount] = ring ? 1 : 0;
    hulls.owner[this.hullCount] = this.#owners;
    this.hullCount++;
    hulls.first[this.hullCount] = this.edgeCount;
  }

  #joinNeighbours(slotCount: number): void {
    const { start, end } = this.edges;
    const { firstNeighbour } = this.slots;
    if (this.neighbour.length < this.edgeCount * 2) this.neighbour = new Int32Array(this.edgeCount * 4);
    firstNeighbour.fill(0);
    for (let k = 0; k < this.edgeCount; k++) {
      firstNeighbour[start[k]]++;
      firstNeighbour[end[k]]++;
    }
    for (let s = 0, sum = 0; s <= slotCount; s++) {
      sum += firstNeighbour[s];
      firstNeighbour[s] = sum;
    }
    for (let k = this.edgeCount - 1; k >= 0; k--) {
      this.neighbour[--firstNeighbour[end[k]]] = start[k];
      this.neighbour[--firstNeighbour[start[k]]] = end[k];
    }
  }

  #findAbroad(links: readonly Link[]): void {
    const { owner, abroad } = this.slots;
    abroad.fill(0);
    for (const { a, b } of links) {
      const first = particleOf(a);
      const second = particleOf(b);
      if (first === undefined || second === undefined) continue;
      if (owner[first.slot] !== NONE && owner[first.slot] === owner[second.slot]) continue;
      abroad[first.slot] = 1;
      abroad[second.slot] = 1;
    }
  }
}
