/**
 * Which of n numbers is the least, as a tree: the numbers are its leaves, and each node above is the least of its four
 * children. Reading the least costs nothing; finding where it stands costs the height, log₄ n; changing a number that
 * neither is nor becomes the least of its four, which is what most do, costs a look at one node. A node's four children
 * are neighbours in memory: `nodes[4 * k]` to `nodes[4 * k + 3]`, with the root at 1.
 */
export class LeastTree {
  nodes: Float64Array = new Float64Array(8);
  /** Where the leaves begin: the number of index i is `nodes[leaves + i]`. */
  leaves = 4;

  /** Makes room for `count` numbers, all Infinity; those are to be written to the leaves before `build`. */
  resize(count: number): void {
    let leaves = 4;
    while (leaves < count) leaves *= 4;
    if (leaves * 2 > this.nodes.length) this.nodes = new Float64Array(leaves * 2);
    this.leaves = leaves;
    this.nodes.fill(Infinity, leaves, leaves * 2);
  }

  /** Finds the least of each four, from the leaves up. */
  build(): void {
    const { nodes } = this;
    for (let level = this.leaves / 4; level >= 1; level /= 4) {
      for (let node = level; node < level * 2; node++) nodes[node] = leastOfFour(nodes, node * 4);
    }
  }
}

/** Changes the number at a leaf, and the nodes above it as far as they come out differently. */
export function setLeaf(nodes: Float64Array, leaf: number, value: number): void {
  let node = leaf;
  let old = nodes[node];
  nodes[node] = value;
  while (node > 1) {
    const parent = node >> 2;
    const least = nodes[parent];
    if (!(value < least)) {
      if (old !== least) return; // it was not the least, and is not now
      value = leastOfFour(nodes, parent << 2);
      if (value === least) return; // another is as small
    }
    nodes[parent] = value;
    old = least;
    node = parent;
  }
}

/** Where the least number stands; of equal ones the first. */
export function leastLeaf(nodes: Float64Array, leaves: number): number {
  const least = nodes[1];
  let node = 1;
  while (node < leaves) {
    node <<= 2;
    if (nodes[node] === least) continue;
    if (nodes[node + 1] === least) node += 1;
    else if (nodes[node + 2] === least) node += 2;
    else node += 3;
  }
  return node;
}

function leastOfFour(nodes: Float64Array, first: number): number {
  const a = nodes[first];
  const b = nodes[first + 1];
  const c = nodes[first + 2];
  const d = nodes[first + 3];
  const ab = Math.min(a, b);
  const cd = Math.min(c, d);
  return Math.min(ab, cd);
}
