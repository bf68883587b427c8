import type { LinkGraph } from './link-graph.ts';

/** Links dealt out to forests, so that none has a loop. */
export interface SpanningForests {
  /** Number of the forest of each link: as much as can be is in forest 0. */
  readonly forest: Int32Array;
  /** How many forests there are. */
  readonly count: number;
  /** The movable particles that have links, nearest to what holds them first. */
  readonly slots: Int32Array;
  /** For each slot one that all slots of its connected part share. */
  readonly part: Int32Array;
}

/**
 * Deals links out to as few forests as a greedy search finds: first those along which the search went, then what is left, in the
 * order in which it was found (Kruskal 1956). Links to ends that cannot move close no loop.
 */
export function spanningForests(graph: LinkGraph): SpanningForests {
  const { near, far, slots: slotCount } = graph;
  const { slots, order } = search(graph);
  const forest = new Int32Array(near.length);
  const sets = new Int32Array(slotCount);
  const part = new Int32Array(slotCount);
  let left = order.length;
  let count = 0;
  do {
    for (let s = 0; s < slotCount; s++) sets[s] = s;
    let kept = 0;
    for (let o = 0; o < left; o++) {
      const link = order[o];
      const a = find(sets, near[link]);
      const b = find(sets, far[link]);
      sets[Math.max(a, b)] = Math.min(a, b);
      if (a === b) order[kept++] = link;
      else forest[link] = count;
    }
    if (count === 0) for (let s = 0; s < slotCount; s++) part[s] = find(sets, s);
    left = kept;
    count++;
  } while (left > 0);
  return { forest, count, slots, part };
}

/**
 * The slots as a search meets them, and the links between them: those that it went along, then the others. It is breadth-first
 * from the ends that cannot move, so that what hangs there is held by short ways; what nothing holds is searched depth-first,
 * which finds two chains in a box with its diagonals.
 */
function search({ near, far, first, links, slots: slotCount }: LinkGraph): { slots: Int32Array; order: Int32Array } {
  const slots = new Int32Array(slotCount);
  const seen = new Uint8Array(slotCount);
  const used = new Uint8Array(near.length);
  const next = first.slice();
  const others: number[] = [];
  const order = new Int32Array(near.length);
  let found = 0;
  let along = 0;
  const meet = (slot: number): void => {
    seen[slot] = 1;
    slots[found++] = slot;
  };
  /** Goes along the next link of a slot that is still unused. Returns the new slot, -1 if it was none, -2 at the end. */
  const advance = (slot: number): number => {
    while (next[slot] < first[slot + 1]) {
      const link = links[next[slot]++];
      if (used[link] === 1 || far[link] < 0) continue;
      used[link] = 1;
      const other = near[link] === slot ? far[link] : near[link];
      if (seen[other] === 0) {
        order[along++] = link;
        meet(other);
        return other;
      }
      others.push(link);
    }
    return -1;
  };
  for (let l = 0; l < near.length; l++) if (far[l] < 0 && near[l] >= 0 && seen[near[l]] === 0) meet(near[l]);
  for (let done = 0; done < found; done++) while (advance(slots[done]) >= 0);
  const path: number[] = [];
  for (let slot = 0; slot < slotCount; slot++) {
    if (seen[slot] === 1 || first[slot + 1] === first[slot]) continue;
    meet(slot);
    path.push(slot);
    while (path.length > 0) {
      const other = advance(path[path.length - 1]);
      if (other >= 0) path.push(other);
      else path.pop();
    }
  }
  order.set(others, along);
  return { slots: slots.subarray(0, found), order: order.subarray(0, along + others.length) };
}

/** The representative of a set, with paths halved on the way (R. Tarjan 1975). */
function find(sets: Int32Array, slot: number): number {
  while (sets[slot] !== slot) {
    sets[slot] = sets[sets[slot]];
    slot = sets[slot];
  }
  return slot;
}
