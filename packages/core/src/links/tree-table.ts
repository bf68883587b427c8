// Numbers that go from function to function would cost a box each: these stand in `shared`.
/** Duration of the piece that is being solved. Unit: s. */
export const PIECE = 0;
/** How much of the way from start to end of a piece the direction is taken in which links pull, 0 to 1. */
export const CALM = 1;
/** Share of its length by which a link that is farther off is brought back. */
export const MOST_BACK = 2;
/** How hasty what was solved last is: the square of by how much the piece is too long. */
export const HASTE = 3;
/** Energy of motion. Unit: J. */
export const ENERGY = 4;

/** Numbers a row in `rows`. */
export const ROW = 17;
/** The length to aim at. Unit: m. */
export const GOAL = 0;
/** How far the link gives. Unit: m/N. */
export const GIVE = 1;
/** How much it calms what swings on it, 0 to 1. */
export const DAMPING = 2;
/** Tension, but for what comes from the parent. */
export const OWN = 3;
/** What an impulse on the parent along x adds to it; for an only child, what the tension of the parent's own link does. */
export const PER_X = 4;
/** What an impulse on the parent along y adds to it. */
export const PER_Y = 5;
/** From the node to its parent, the line along which the link pulls: x. Unit: m. */
export const ALONG_X = 6;
/** The same: y. Unit: m. */
export const ALONG_Y = 7;
/** Tension when the tree was solved last: impulse over length, positive pulls. Unit: N·s/m. */
export const TENSION = 8;
/** Its sum over the small step so far. Unit: N·s/m. */
export const SUM = 9;
/** Its sum over the small steps before. Unit: N·s/m. */
export const TOTAL = 10;
/** How the node's velocity follows an impulse, as a matrix xx, xy, yx, yy, while the links below it are kept. Unit: 1/kg. */
export const MOBILITY = 11;
/** What the links below have changed its velocity by, x and y; later the impulse that it has got from links. */
export const CHANGE = 15;

/** Numbers a node in `nodes`. */
export const NODE = 6;
/** Where it is: x. Unit: m. */
export const X = 0;
/** The same: y. Unit: m. */
export const Y = 1;
/** Its velocity: x. Unit: m/s. */
export const VX = 2;
/** The same: y. Unit: m/s. */
export const VY = 3;
/** Inverse mass; 0 where nothing moves it. Unit: 1/kg. */
export const INVERSE_MASS = 4;
/** Mass; 0 where nothing moves it. Unit: kg. */
export const MASS = 5;

/**
 * Trees of links, one row for each node of a tree, depth-first: a parent before its children, and an only child right after its parent.
 * The link of a row joins its node to its parent's. Trees that links hold together share nodes. An end that nothing moves, a fixed
 * point or an infinite mass, is a node of its own for each link that hangs on it, since nothing passes through it.
 */
export class TreeTable {
  /** How many rows and nodes there are. */
  rowCount = 0;
  nodeCount = 0;
  /** The node of each row. */
  node: Int32Array = new Int32Array(0);
  /** Row of the parent, or -1 for a root, which has no link. */
  parent: Int32Array = new Int32Array(0);
  /** Number of the link, or -1 for a root. */
  link: Int32Array = new Int32Array(0);
  /** How many children a row has, 0, 1 or 2: more are counted as two. */
  children: Uint8Array = new Uint8Array(0);
  /** 1 for the last child of its parent: the first to be eliminated. */
  isLast: Uint8Array = new Uint8Array(0);
  /** At which limit the link is: 1 the greatest, -1 the least, 0 neither; 2 both, a rod. */
  side: Int8Array = new Int8Array(0);
  /** 1 where the link was at a limit or next to it: it jerks no more. */
  taut: Uint8Array = new Uint8Array(0);
  minLength: Float64Array = new Float64Array(0);
  maxLength: Float64Array = new Float64Array(0);
  restitution: Float64Array = new Float64Array(0);
  /** The other numbers of links, all in one array, which is quicker than several. */
  rows: Float64Array = new Float64Array(0);
  /** The particle of each node, or -1 for a fixed point. */
  slot: Int32Array = new Int32Array(0);
  /** Numbers of nodes. */
  nodes: Float64Array = new Float64Array(0);

  /** What the functions that work on the table tell each other. */
  readonly shared: Float64Array = new Float64Array(5);

  /** Forgets everything and makes room for so many rows and nodes. */
  clear(room: number): void {
    this.rowCount = this.nodeCount = 0;
    this.taut.fill(0);
    this.maxLength.fill(0); // no link has this length: all will be read
    if (room <= this.node.length) return;
    this.node = new Int32Array(room);
    this.parent = new Int32Array(room);
    this.link = new Int32Array(room);
    this.children = new Uint8Array(room);
    this.isLast = new Uint8Array(room);
    this.side = new Int8Array(room);
    this.taut = new Uint8Array(room);
    this.minLength = new Float64Array(room);
    this.maxLength = new Float64Array(room);
    this.restitution = new Float64Array(room);
    this.rows = new Float64Array(room * ROW);
    this.slot = new Int32Array(room);
    this.nodes = new Float64Array(room * NODE);
  }
}
