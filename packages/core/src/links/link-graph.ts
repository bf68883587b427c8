import { particleOf } from '../particles/end.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { Link } from './link.ts';

/**
 * Which particles links join: the links of a slot s are `links[first[s]]` to `links[first[s + 1] - 1]`. Only particles that can
 * move are nodes; an end that cannot cuts the graph, since nothing passes through it.
 */
export interface LinkGraph {
  /** How many slots there are. */
  readonly slots: number;
  /** A movable end of each link, or -1 for a link that has none. */
  readonly near: Int32Array;
  /** The movable end at the other side, or -1 for an end that cannot move. */
  readonly far: Int32Array;
  readonly first: Int32Array;
  readonly links: Int32Array;
}

/** Reads the ends of links. Time grows with their number and that of the slots. */
export function linkGraph(links: readonly Link[], { count, inverseMass }: ParticleArrays): LinkGraph {
  const near = new Int32Array(links.length);
  const far = new Int32Array(links.length);
  const first = new Int32Array(count + 1);
  const movable = (slot: number | undefined): number => (slot !== undefined && inverseMass[slot] > 0 ? slot : -1);
  for (let l = 0; l < links.length; l++) {
    const a = movable(particleOf(links[l].a)?.slot);
    const b = movable(particleOf(links[l].b)?.slot);
    near[l] = a < 0 ? b : a;
    far[l] = a < 0 ? -1 : b;
    if (near[l] >= 0) first[near[l]]++;
    if (far[l] >= 0) first[far[l]]++;
  }
  for (let s = 0; s < count; s++) first[s + 1] += first[s];
  const sorted = new Int32Array(first[count]);
  for (let l = links.length - 1; l >= 0; l--) {
    if (far[l] >= 0) sorted[--first[far[l]]] = l;
    if (near[l] >= 0) sorted[--first[near[l]]] = l;
  }
  return { slots: count, near, far, first, links: sorted };
}
