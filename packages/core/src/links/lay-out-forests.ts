import { particleOf } from '../particles/end.ts';
import type { Group } from './group-solver.ts';
import type { Link } from './link.ts';
import type { LinkGraph } from './link-graph.ts';
import type { SpanningForests } from './spanning-forests.ts';
import { NODE, type TreeTable, X, Y } from './tree-table.ts';

/** Writes the rows of all trees: group by group, and in each forest by forest. A group is what links hold together. */
export function layOutForests(
  table: TreeTable,
  links: readonly Link[],
  graph: LinkGraph,
  forests: SpanningForests,
): Group[] {
  const writer = new RowWriter(table, links, graph, forests.forest);
  return Array.from(groupsOf(forests), (members) => {
    const trees: number[] = [];
    const from = table.nodeCount;
    for (let f = 0; f < forests.count; f++) writer.addForest(members, f, trees);
    trees.push(table.rowCount);
    return { trees, from, to: table.nodeCount };
  });
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
  /** The node of a slot, or -1. */
  readonly #node: Int32Array;
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
    this.#node = new Int32Array(graph.slots).fill(-1);
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
        trees.push(this.#table.rowCount);
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
      this.#addBranch(slot, this.#table.rowCount - 1, link, forest);
      return;
    }
    this.#addBranch(slot, -1, -1, forest);
  }

  /** A slot and all that hangs on it, depth-first. */
  #addBranch(slot: number, parent: number, link: number, forest: number): void {
    const { near, far } = this.#graph;
    const { slot: slotOf, node: nodeOf } = this.#table;
    const waiting = this.#waiting;
    this.#await(slot, this.#addSlot(slot, parent, link), forest);
    while (waiting.length > 0) {
      const row = waiting.pop() as number;
      const next = waiting.pop() as number;
      const above = slotOf[nodeOf[row]];
      if (far[next] < 0) this.#addHolder(next, above, row);
      else {
        const other = near[next] === above ? far[next] : near[next];
        this.#await(other, this.#addSlot(other, row, next), forest);
      }
    }
  }

  /** Notes the links that hang on a row. */
  #await(slot: number, row: number, forest: number): void {
    const { first, links } = this.#graph;
    this.#met[slot] = forest;
    for (let i = first[slot + 1] - 1; i >= first[slot]; i--) {
      if (this.#forest[links[i]] === forest && links[i] !== this.#table.link[row]) this.#waiting.push(links[i], row);
    }
  }

  /** The end of a link that cannot move, across from a slot. */
  #addHolder(link: number, slot: number, parent: number): void {
    const { a, b } = this.#links[link];
    const end = particleOf(a)?.slot === slot ? b : a;
    const node = this.#addNode(particleOf(end)?.slot ?? -1);
    this.#table.nodes[node * NODE + X] = end.x;
    this.#table.nodes[node * NODE + Y] = end.y;
    this.#addRow(node, parent, parent < 0 ? -1 : link);
  }

  #addSlot(slot: number, parent: number, link: number): number {
    if (this.#node[slot] < 0) this.#node[slot] = this.#addNode(slot);
    return this.#addRow(this.#node[slot], parent, link);
  }

  #addNode(slot: number): number {
    this.#table.slot[this.#table.nodeCount] = slot;
    return this.#table.nodeCount++;
  }

  #addRow(node: number, parent: number, link: number): number {
    const table = this.#table;
    const row = table.rowCount++;
    table.node[row] = node;
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
