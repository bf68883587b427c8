import { growColumns } from '../math/columns.ts';

const numbers = (): Float64Array => new Float64Array(0);

/**
 * Trees of links, one row for each node, parents before their children: from the last row to the first is the order of
 * elimination, back again that of substitution. The link of a row joins its node to its parent's. An end that nothing moves,
 * a fixed point or an infinite mass, has a row for each link that hangs on it: it passes nothing on.
 */
export class ForestTable {
  count = 0;
  /** Slot of the particle, or -1 for a fixed point. */
  slot: Int32Array = new Int32Array(0);
  /** Row of the parent, or -1 for a root, which has no link. */
  parent: Int32Array = new Int32Array(0);
  /** Number of the link, or -1 for a root. */
  link: Int32Array = new Int32Array(0);
  /** 1 where the solver may move the node. */
  moves: Uint8Array = new Uint8Array(0);
  /** Which limit the link is at: 1 the greatest, -1 the smallest, 0 neither; 2 for a rod, which is at both. */
  side: Int8Array = new Int8Array(0);
  /** 1 where the link was at a limit or next to it: it jerks no more. */
  taut: Uint8Array = new Uint8Array(0);

  /** Mass of the node; one that does not move counts as very heavy. */
  mass: Float64Array = numbers();
  /** Sum of the inverse masses of the link's ends. */
  inverseMass: Float64Array = numbers();
  minLength: Float64Array = numbers();
  maxLength: Float64Array = numbers();
  compliance: Float64Array = numbers();
  damping: Float64Array = numbers();
  restitution: Float64Array = numbers();

  /** Where the node is as a small step begins, and its velocity so far. */
  x: Float64Array = numbers();
  y: Float64Array = numbers();
  vx: Float64Array = numbers();
  vy: Float64Array = numbers();
  /** Effective mass matrix of the node with all that hangs on it, and the impulse that comes from there. */
  mxx: Float64Array = numbers();
  mxy: Float64Array = numbers();
  myx: Float64Array = numbers();
  myy: Float64Array = numbers();
  jx: Float64Array = numbers();
  jy: Float64Array = numbers();
  /** Change of velocity u of the node: its own part, and the matrix that tells what the parent's u adds. */
  ux: Float64Array = numbers();
  uy: Float64Array = numbers();
  txx: Float64Array = numbers();
  txy: Float64Array = numbers();
  tyx: Float64Array = numbers();
  tyy: Float64Array = numbers();
  /** Tension: its own part, and what the parent's u adds. An impulse over the length of the link. */
  own: Float64Array = numbers();
  perX: Float64Array = numbers();
  perY: Float64Array = numbers();
  /** Tension that the link began the small step with, that it has, and their sum over the step. Unit: N·s/m. */
  start: Float64Array = numbers();
  tension: Float64Array = numbers();
  total: Float64Array = numbers();

  /** Makes room for so many rows, all of them empty. */
  reserve(rows: number): void {
    if (rows > this.slot.length) growColumns(this, rows * 2);
  }
}
