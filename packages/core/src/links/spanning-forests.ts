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
 * Deals links out to as few forests as a greedy search finds: breadth-first from the ends that cannot move, so that what hangs
 * is held by short ways up; then what is left, in the order found (Kruskal 1956). Links to ends that cannot move close no loop.
 */
export function spanningForests(graph: LinkGraph): SpanningForests {
  const { near, far, slots: slotCount } = graph;
  const { slots, order } = searchOrder(graph);
  const forest = new Int32Array(near.length);
  let part = new Int32Array(0);
  let left = order.length;
  let count = near.length > 0 ? 1 : 0;
  for (let f = 0; f === 0 || left > 0; f++) {
    const sets = Int32Array.from({ length: slotCount }, (_, slot) => slot);
    let kept = 0;
    for (let o = 0; o < left; o++) {
      const link = order[o];
      const a = find(sets, near[link]);
      const b = find(sets, far[link]);
      if (a === b) order[kept++] = link;
      else {
        sets[Math.max(a, b)] = Math.min(a, b);
        forest[link] = f;
      }
    }
    left = kept;
    count = Math.max(count, f + 1);
    if (f === 0) part = sets;
  }
  for (let s = 0; s < slotCount; s++) part[s] = find(part, s);
  return { forest, count, slots, part };
}

/** The slots as a breadth-first search meets them, and the links between them: those that it went along, then the others. */
function searchOrder({ near, far, first, links, slots: slotCount }: LinkGraph): {
  slots: Int32Array;
  order: Int32Array;
} {
  const seen = new Uint8Array(slotCount);
  const used = new Uint8Array(near.length);
  const slots = new Int32Array(slotCount);
  const others: number[] = [];
  const order = new Int32Array(near.length);
  let found = 0;
  let done = 0;
  let along = 0;
  const meet = (slot: number): void => {
    if (seen[slot] === 1) return;
    seen[slot] = 1;
    slots[found++] = slot;
  };
  const search = (): void => {
    for (; done < found; done++) {
      const slot = slots[done];
      for (let i = first[slot]; i < first[slot + 1]; i++) {
        const link = links[i];
        if (used[link] === 1 || far[link] < 0) continue;
        used[link] = 1;
        const other = near[link] === slot ? far[link] : near[link];
        if (seen[other] === 1) others.push(link);
        else order[along++] = link;
        meet(other);
      }
    }
  };
  for (let l = 0; l < near.length; l++) if (near[l] >= 0 && far[l] < 0) meet(near[l]);
  search();
  for (let slot = 0; slot < slotCount; slot++) {
    if (first[slot + 1] > first[slot]) meet(slot);
    search();
  }
  order.set(others, along);
  return { slots: slots.subarray(0, found), order: order.subarray(0, along + others.length) };
}

function find(sets: Int32Array, slot: number): number {
  while (sets[slot] !== slot) {
    sets[slot] = sets[sets[slot]];
    slot = sets[slot];
  }
  return slot;
}
