import { particleOf } from '../particles/end.ts';
import type { Link } from './link.ts';
import type { LinkGraph } from './link-graph.ts';
import { NODE, POINT, type TreeTable } from './solve-tree.ts';
import type { SpanningForests } from './spanning-forests.ts';

/** Where in the table the trees stand. */
export interface ForestLayout {
  /** First row of each tree, and the end of the last. */
  readonly trees: readonly number[];
  /** First tree of each group, and the end of the last: a group is what links hold together. */
  readonly groups: readonly number[];
}

/** Writes the rows of all trees: group by group, and in each forest by forest. */
export function layOutForests(
  table: TreeTable,
  links: readonly Link[],
  graph: LinkGraph,
  forests: SpanningForests,
): ForestLayout {
  const trees: number[] = [];
  const groups: number[] = [];
  const writer = new RowWriter(table, links, graph, forests.forest);
  for (const members of groupsOf(forests)) {
    groups.push(trees.length);
    for (let f = 0; f < forests.count; f++) writer.addForest(members, f, trees);
  }
  groups.push(trees.length);
  trees.push(table.count);
  return { trees, groups };
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
  readonly #table: TreeTable;
  readonly #links: readonly Link[];
  readonly #graph: LinkGraph;
  readonly #forest: Int32Array;
  /** The last forest in which a slot was met. */
  readonly #met: Int32Array;
  /** The last child of a row. */
  readonly #lastChild: Int32Array;
  /** Rows to come, the next on top: link, then parent. */
  readonly #waiting: number[] = [];

  constructor(table: TreeTable, links: readonly Link[], graph: LinkGraph, forest: Int32Array) {
    const room = 2 * links.length + graph.slots;
    this.#table = table;
    this.#links = links;
    this.#graph = graph;
    this.#forest = forest;
    this.#met = new Int32Array(graph.slots).fill(-1);
    this.#lastChild = new Int32Array(room);
    table.clear(room);
  }

  /** All trees that a forest has among the members of a group. */
  addForest(members: readonly number[], forest: number, trees: number[]): void {
    const { first, links } = this.#graph;
    for (const member of members) {
      if (this.#met[member] === forest) continue;
      for (let i = first[member]; i < first[member + 1]; i++) {
        if (this.#forest[links[i]] !== forest) continue;
        trees.push(this.#table.count);
        this.#addTree(member, forest);
        break;
      }
    }
  }

  /** A tree, from the end that holds its first slot, where there is one, or else from that slot. */
  #addTree(slot: number, forest: number): void {
    const { far, first, links } = this.#graph;
    for (let i = first[slot]; i < first[slot + 1]; i++) {
      const link = links[i];
      if (far[link] >= 0 || this.#forest[link] !== forest) continue;
      this.#addHolder(link, slot, -1);
      this.#addBranch(slot, this.#table.count - 1, link, forest);
      return;
    }
    this.#addBranch(slot, -1, -1, forest);
  }

  /** A slot and all that hangs on it, depth-first. */
  #addBranch(slot: number, parent: number, link: number, forest: number): void {
    const { near, far } = this.#graph;
    const { slot: slotOf } = this.#table;
    const waiting = this.#waiting;
    this.#await(this.#add(slot, parent, link), forest);
    while (waiting.length > 0) {
      const row = waiting.pop() as number;
      const next = waiting.pop() as number;
      const above = slotOf[row];
      if (far[next] < 0) this.#addHolder(next, above, row);
      else this.#await(this.#add(near[next] === above ? far[next] : near[next], row, next), forest);
    }
  }

  /** Notes the links that hang on a row. */
  #await(row: number, forest: number): void {
    const { first, links } = this.#graph;
    const slot = this.#table.slot[row];
    this.#met[slot] = forest;
    for (let i = first[slot + 1] - 1; i >= first[slot]; i--) {
      if (this.#forest[links[i]] === forest && links[i] !== this.#table.link[row]) this.#waiting.push(links[i], row);
    }
  }

  /** The end of a link that cannot move, across from a slot. */
  #addHolder(link: number, slot: number, parent: number): void {
    const { a, b } = this.#links[link];
    const end = particleOf(a)?.slot === slot ? b : a;
    const row = this.#add(particleOf(end)?.slot ?? -1, parent, parent < 0 ? -1 : link);
    this.#table.nodes[row * NODE + POINT] = end.x;
    this.#table.nodes[row * NODE + POINT + 1] = end.y;
  }

  #add(slot: number, parent: number, link: number): number {
    const table = this.#table;
    const row = table.count++;
    table.slot[row] = slot;
    table.parent[row] = parent;
    table.link[row] = link;
    table.children[row] = 0;
    table.isLast[row] = 1;
    if (parent >= 0) {
      if (table.children[parent] > 0) table.isLast[this.#lastChild[parent]] = 0;
      table.children[parent] = Math.min(2, table.children[parent] + 1);
      this.#lastChild[parent] = row;
    }
    return row;
  }
}
