import { particleOf } from '../particles/end.ts';
import type { ForestTable } from './forest-table.ts';
import type { Link } from './link.ts';
import type { LinkGraph } from './link-graph.ts';
import type { SpanningForests } from './spanning-forests.ts';

/** Where in the table the forests stand. */
export interface ForestLayout {
  /** First row of each range, and the end of the last: a range holds one forest of one group. */
  readonly ranges: readonly number[];
  /** First range of each group, and the end of the last: a group is what links hold together. */
  readonly groups: readonly number[];
}

/** Writes the rows of all trees: group by group, forest by forest, breadth-first from the roots. */
export function layOutForests(
  table: ForestTable,
  links: readonly Link[],
  graph: LinkGraph,
  forests: SpanningForests,
): ForestLayout {
  const ranges: number[] = [];
  const groups: number[] = [];
  const writer = new RowWriter(table, links, graph, forests.forest);
  for (const members of groupsOf(forests)) {
    groups.push(ranges.length);
    for (let f = 0; f < forests.count; f++) {
      const from = table.count;
      writer.addForest(members, f);
      if (table.count > from) ranges.push(from);
    }
  }
  groups.push(ranges.length);
  ranges.push(table.count);
  return { ranges, groups };
}

/** The slots of each connected part; parts and slots in the order of the search. */
function groupsOf({ slots, part }: SpanningForests): Iterable<number[]> {
  const groups = new Map<number, number[]>();
  for (const slot of slots) {
    const group = groups.get(part[slot]);
    if (group === undefined) groups.set(part[slot], [slot]);
    else group.push(slot);
  }
  return groups.values();
}

class RowWriter {
  readonly #table: ForestTable;
  readonly #links: readonly Link[];
  readonly #graph: LinkGraph;
  readonly #forest: Int32Array;
  /** The last forest in which a slot was met. */
  readonly #met: Int32Array;
  readonly #stack: number[] = [];

  constructor(table: ForestTable, links: readonly Link[], graph: LinkGraph, forest: Int32Array) {
    this.#table = table;
    this.#links = links;
    this.#graph = graph;
    this.#forest = forest;
    this.#met = new Int32Array(graph.slots).fill(-1);
    table.count = 0;
    table.reserve(2 * links.length + graph.slots);
  }

  /** All trees that a forest has among the members of a group. */
  addForest(members: readonly number[], forest: number): void {
    const table = this.#table;
    const from = table.count;
    for (const member of members) {
      if (this.#met[member] < forest && this.#meetTree(member, forest)) this.#addRoot(member, forest);
    }
    for (let row = from; row < table.count; row++) this.#addChildren(row, forest);
  }

  /** Marks what hangs together with a slot in a forest. Returns whether there is any link. */
  #meetTree(member: number, forest: number): boolean {
    const { near, far, first, links } = this.#graph;
    const stack = this.#stack;
    let any = false;
    stack.push(member);
    for (let slot = stack.pop(); slot !== undefined; slot = stack.pop()) {
      this.#met[slot] = forest;
      for (let i = first[slot]; i < first[slot + 1]; i++) {
        const link = links[i];
        if (this.#forest[link] !== forest) continue;
        any = true;
        const other = near[link] === slot ? far[link] : near[link];
        if (other >= 0 && this.#met[other] < forest) stack.push(other);
      }
    }
    return any;
  }

  /** The root of a tree: the end that holds the first slot, where there is one, or else that slot. */
  #addRoot(slot: number, forest: number): void {
    const { far, first, links } = this.#graph;
    for (let i = first[slot]; i < first[slot + 1]; i++) {
      const link = links[i];
      if (far[link] >= 0 || this.#forest[link] !== forest) continue;
      this.#addHolder(link, slot, -1);
      this.#add(slot, this.#table.count - 1, link);
      this.#table.link[this.#table.count - 2] = -1;
      return;
    }
    this.#add(slot, -1, -1);
  }

  #addChildren(row: number, forest: number): void {
    const { near, far, first, links } = this.#graph;
    const slot = this.#table.slot[row];
    if (this.#table.moves[row] === 0) return;
    for (let i = first[slot]; i < first[slot + 1]; i++) {
      const link = links[i];
      if (link === this.#table.link[row] || this.#forest[link] !== forest) continue;
      if (far[link] < 0) this.#addHolder(link, slot, row);
      else this.#add(near[link] === slot ? far[link] : near[link], row, link);
    }
  }

  /** The end of a link that cannot move, across from a slot. */
  #addHolder(link: number, slot: number, parent: number): void {
    const { a, b } = this.#links[link];
    const end = particleOf(a)?.slot === slot ? b : a;
    const row = this.#add(particleOf(end)?.slot ?? -1, parent, link);
    this.#table.moves[row] = 0;
    this.#table.x[row] = end.x;
    this.#table.y[row] = end.y;
    this.#table.vx[row] = this.#table.vy[row] = 0;
  }

  #add(slot: number, parent: number, link: number): number {
    const table = this.#table;
    const row = table.count++;
    table.slot[row] = slot;
    table.parent[row] = parent;
    table.link[row] = link;
    table.moves[row] = 1;
    table.tension[row] = 0;
    return row;
  }
}
