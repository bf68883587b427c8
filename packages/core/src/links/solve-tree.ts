import type { ParticleArrays } from '../particles/particle-arrays.ts';

// Where the numbers of a link stand in `rows`. They stand in this file so that the compiler can count on them.
/** Numbers a link. */
export const ROW = 9;
/** The length to keep. Unit: m. */
export const LENGTH = 0;
/** Inverse mass of the node; 0 where nothing moves it. Unit: 1/kg. */
export const INVERSE_MASS = 1;
/** Tension that is added, but for what comes from the parent. */
export const OWN = 2;
/** What an impulse on the parent along x adds to it. */
export const PER_X = 3;
/** What an impulse on the parent along y adds to it. */
export const PER_Y = 4;
/** From the node to its parent, the line along which the link pulls: x. Unit: m. */
export const ALONG_X = 5;
/** The same: y. Unit: m. */
export const ALONG_Y = 6;
/** Tension in this small step: impulse over length, positive pulls. Unit: N·s/m. */
export const TENSION = 7;
/** Its sum over the small steps so far. Unit: N·s/m. */
export const TOTAL = 8;
/** In the row of the root, which has no link: energy of motion that the links added. Unit: J. */
export const GAIN = 7;

// Where the numbers of a node stand in `nodes`.
/** Numbers a node. */
export const NODE = 8;
/** How its velocity follows an impulse, as a matrix xx, xy, yx, yy, while the links below it are kept. Unit: 1/kg. */
export const MOBILITY = 0;
/** What the links below have changed its velocity by, x and y; later the impulse that it has got from links. */
export const CHANGE = 4;
/** Where it is, x and y, if it is a fixed point. Unit: m. */
export const POINT = 6;

/** Share of its length that a link may be off; beyond it, it is brought back in several small steps. */
export const CORRECTION = 0.1;
const TOO_LONG = (1 + CORRECTION) * (1 + CORRECTION);
const TOO_SHORT = (1 - CORRECTION) * (1 - CORRECTION);
/** A link that turns by more than 60° in a small step is none for this method: the square of the cosine. */
const FAR = 0.25;
/** Mobility that the links below leave to a link, as a share of what it is alone: less is rounding. */
const HELD = 1e-9;
/** One that turns by more than some 15° wants a second pass. */
const WIDE = 0.93;
/** A cable that pulls counts as taut up to this share short of its length. */
export const NEAR = 0.02;
/** One that did not pull is taut but for rounding. */
export const ROUNDING = 1e-9;

/** What came of it: it cannot be done this way. */
export const FAILED = 0;
/** It is done. */
export const DONE = 1;
/** It is done in a first approximation. */
export const ROUGH = 2;

/** A link of one length. */
export const ROD = 0;
/** A link of a greatest length. */
export const CABLE = 1;
/** A link of a greatest and a least length. */
export const RANGE = 2;

/**
 * Trees of links, one row for each node, depth-first: a parent before its children, and an only child right after its parent.
 * The link of a row joins its node to its parent's. An end that nothing moves, a fixed point or an infinite mass, has a row
 * of its own for each link that hangs on it, since nothing passes through it.
 */
export class TreeTable {
  count = 0;
  /** Slot of the particle, or -1 for a fixed point. */
  slot: Int32Array = new Int32Array(0);
  /** Row of the parent, or -1 for a root, which has no link. */
  parent: Int32Array = new Int32Array(0);
  /** Number of the link, or -1 for a root. */
  link: Int32Array = new Int32Array(0);
  /** How many children a node has, 0, 1 or 2: more are counted as two. */
  children: Uint8Array = new Uint8Array(0);
  /** 1 for the last child of its parent: the first to be eliminated. */
  isLast: Uint8Array = new Uint8Array(0);
  /** `ROD`, `CABLE` or `RANGE`. */
  kind: Uint8Array = new Uint8Array(0);
  /** Numbers of links and of nodes. */
  rows: Float64Array = new Float64Array(0);
  nodes: Float64Array = new Float64Array(0);

  /** Forgets all rows and makes room for so many. */
  clear(room: number): void {
    this.count = 0;
    if (room <= this.slot.length) return;
    this.slot = new Int32Array(room);
    this.parent = new Int32Array(room);
    this.link = new Int32Array(room);
    this.children = new Uint8Array(room);
    this.isLast = new Uint8Array(room);
    this.kind = new Uint8Array(room);
    this.rows = new Float64Array(room * ROW);
    this.nodes = new Float64Array(room * NODE);
  }
}

/**
 * From the leaves to the root: eliminates one link after the other, each with one division. Reads places and velocities of the
 * particles. Writes what `substitute` needs. Knows rods and cables that neither give nor damp nor jerk; `solve-stiff-tree.ts`
 * knows the rest.
 *
 * An impulse λe on child c, -λe on parent p must make s · (u_p - u_c) = g, with u the changes of velocity, e the link at the
 * start of the small step, s at its end. Of the links below, c keeps its mobility W_c (the inverse of Featherstone's
 * articulated inertia) and the change u_c that they made, so that
 *
 *   λ = (s·(u_p - u_c) - g + k·J) / D,   D = s·(W_c + W_p)e,   u_p -= W_p e λ,   W_p -= (W_p e)(sᵀW_p) / D,
 *
 * J being the impulses that p gets from the links that come later. Along a chain W_c is 1/m less one product, and this is the
 * elimination of a tridiagonal matrix (D. Baraff, Linear-time dynamics using Lagrange multipliers, 1996).
 *
 * Pulling along e while the length holds at the end is SHAKE (J.-P. Ryckaert et al., 1977): it keeps the energy.
 */
// biome-ignore lint/complexity/noExcessiveLinesPerFunction: numbers that go from function to function cost a box each
export function eliminate(t: TreeTable, from: number, to: number, particles: ParticleArrays, h: number): number {
  const { slot, parent, children, isLast, kind, rows, nodes } = t;
  const { x, y, vx, vy } = particles;
  let result = DONE;
  let cx = 0; // the child
  let cy = 0;
  let cvx = 0;
  let cvy = 0;
  let belowSx = 0; // s, e, 1/D and λ of the link below it
  let belowSy = 0;
  let belowEx = 0;
  let belowEy = 0;
  let perD = 0;
  let tension = 0;
  let known = -1;
  for (let k = to - 1; k > from; k--) {
    const p = parent[k];
    if (k !== known) {
      const c = slot[k];
      cx = c < 0 ? nodes[k * NODE + POINT] : x[c];
      cy = c < 0 ? nodes[k * NODE + POINT + 1] : y[c];
      cvx = c < 0 ? 0 : vx[c];
      cvy = c < 0 ? 0 : vy[c];
    }
    const q = slot[p];
    const px = q < 0 ? nodes[p * NODE + POINT] : x[q];
    const py = q < 0 ? nodes[p * NODE + POINT + 1] : y[q];
    const pvx = q < 0 ? 0 : vx[q];
    const pvy = q < 0 ? 0 : vy[q];
    const i = k * ROW;
    const ex = px - cx;
    const ey = py - cy;
    const sx = ex + h * (pvx - cvx);
    const sy = ey + h * (pvy - cvy);
    const length = rows[i + LENGTH];
    const ee = ex * ex + ey * ey;
    const ss = sx * sx + sy * sy;
    const se = sx * ex + sy * ey;
    const s = Math.sqrt(ss);
    const slack = kind[k] === CABLE && s < length * (1 - (rows[i + TENSION] > 0 ? NEAR : ROUNDING));
    const g = ((length - s) * s) / h;
    const w = rows[i + INVERSE_MASS];
    let own = w * se; // s·W_c e
    let mean = w * ee; // e·W_c e
    let gap = -g; // s·(u_p - u_c) - g
    if (children[k] === 1) {
      const m = w * (sx * belowEx + sy * belowEy);
      const less = w * (belowSx * ex + belowSy * ey) * perD;
      own -= m * less;
      mean -= w * (ex * belowEx + ey * belowEy) * less;
      gap += m * tension;
    } else if (children[k] > 1) {
      const n = k * NODE;
      const ax = nodes[n] * ex + nodes[n + 1] * ey;
      const ay = nodes[n + 2] * ex + nodes[n + 3] * ey;
      own = sx * ax + sy * ay;
      mean = ex * ax + ey * ay;
      gap -= sx * nodes[n + CHANGE] + sy * nodes[n + CHANGE + 1];
    }
    const wp = rows[p * ROW + INVERSE_MASS];
    if (!slack) {
      const d = own + wp * se;
      mean += wp * ee;
      if (se <= 0 || se * se < FAR * ss * ee || !(d > 0.3 * mean && d > HELD * (w + wp) * ee)) return FAILED;
      if (d < 0.7 * mean) result = ROUGH;
      if (ee > TOO_LONG * length * length || ee < TOO_SHORT * length * length) return FAILED;
      if (se * se < WIDE * ss * ee) result = ROUGH;
    }
    if (children[p] === 1) {
      perD = slack ? 0 : 1 / (own + wp * se);
      tension = gap * perD;
      rows[i + PER_X] = wp * sx * perD;
      rows[i + PER_Y] = wp * sy * perD;
    } else {
      const n = p * NODE;
      if (isLast[k] === 1) {
        nodes[n] = nodes[n + 3] = wp;
        nodes[n + 1] = nodes[n + 2] = nodes[n + CHANGE] = nodes[n + CHANGE + 1] = 0;
      }
      const ax = nodes[n] * ex + nodes[n + 1] * ey;
      const ay = nodes[n + 2] * ex + nodes[n + 3] * ey;
      const d = own + sx * ax + sy * ay;
      if (!(slack || d > HELD * (w + wp) * ee)) return FAILED; // the links before it hold it already
      perD = slack ? 0 : 1 / d;
      tension = (gap + sx * nodes[n + CHANGE] + sy * nodes[n + CHANGE + 1]) * perD;
      const kx = (sx * nodes[n] + sy * nodes[n + 2]) * perD;
      const ky = (sx * nodes[n + 1] + sy * nodes[n + 3]) * perD;
      rows[i + PER_X] = kx;
      rows[i + PER_Y] = ky;
      nodes[n] -= ax * kx;
      nodes[n + 1] -= ax * ky;
      nodes[n + 2] -= ay * kx;
      nodes[n + 3] -= ay * ky;
      nodes[n + CHANGE] -= ax * tension;
      nodes[n + CHANGE + 1] -= ay * tension;
    }
    rows[i + OWN] = tension;
    rows[i + ALONG_X] = ex;
    rows[i + ALONG_Y] = ey;
    belowSx = sx;
    belowSy = sy;
    belowEx = ex;
    belowEy = ey;
    cx = px;
    cy = py;
    cvx = pvx;
    cvy = pvy;
    known = p;
  }
  return result;
}

/** What `substitute` found: a tension that swings its ends too swiftly for `eliminate`. */
export const SWIFT = 1;
/** And a cable that pushes. */
export const PUSHES = 2;

/**
 * From the root to the leaves: finds the tensions, and gives the particles their velocities.
 * @param kept - 1 if the tensions come on top of those that are there, 0 if they are the first of the small step.
 */
export function substitute(
  t: TreeTable,
  from: number,
  to: number,
  particles: ParticleArrays,
  h: number,
  kept: number,
): number {
  const { slot, parent, children, kind, rows, nodes } = t;
  const { vx, vy } = particles;
  let found = 0;
  let gain = 0;
  let jx = 0; // impulse on the parent so far
  let jy = 0;
  nodes[from * NODE + CHANGE] = nodes[from * NODE + CHANGE + 1] = 0;
  for (let k = from + 1; k < to; k++) {
    const i = k * ROW;
    const p = parent[k];
    const n = p * NODE + CHANGE;
    const several = children[p] > 1;
    if (several) {
      jx = nodes[n];
      jy = nodes[n + 1];
    }
    const more = rows[i + OWN] + rows[i + PER_X] * jx + rows[i + PER_Y] * jy;
    const ix = more * rows[i + ALONG_X];
    const iy = more * rows[i + ALONG_Y];
    const wp = rows[p * ROW + INVERSE_MASS];
    jx -= ix;
    jy -= iy;
    if (several) {
      nodes[n] = jx;
      nodes[n + 1] = jy;
      jx = -ix;
      jy = -iy;
    }
    if (wp > 0) {
      const s = slot[p];
      gain += jx * (vx[s] + 0.5 * wp * jx) + jy * (vy[s] + 0.5 * wp * jy);
      vx[s] += wp * jx;
      vy[s] += wp * jy;
    }
    const w = rows[i + INVERSE_MASS];
    if (children[k] !== 1) {
      if (w > 0) {
        const s = slot[k];
        gain += ix * (vx[s] + 0.5 * w * ix) + iy * (vy[s] + 0.5 * w * iy);
        vx[s] += w * ix;
        vy[s] += w * iy;
      }
      nodes[k * NODE + CHANGE] = ix;
      nodes[k * NODE + CHANGE + 1] = iy;
    }
    jx = ix;
    jy = iy;
    const tension = kept * rows[i + TENSION] + more;
    rows[i + OWN] = more;
    rows[i + PER_X] = rows[i + TENSION];
    rows[i + TENSION] = tension;
    rows[i + TOTAL] += more;
    if (h * tension * (w + wp) > 1) found |= SWIFT;
    if (tension < 0 && kind[k] === CABLE) found |= PUSHES;
  }
  rows[from * ROW + GAIN] = gain;
  return found;
}

/** Undoes the last `substitute`. */
export function undo(t: TreeTable, from: number, to: number, { vx, vy }: ParticleArrays): void {
  const { slot, parent, rows } = t;
  for (let k = from + 1; k < to; k++) {
    const i = k * ROW;
    const more = rows[i + OWN];
    const c = slot[k];
    const p = slot[parent[k]];
    const w = rows[i + INVERSE_MASS];
    const wp = rows[parent[k] * ROW + INVERSE_MASS];
    if (w > 0) {
      vx[c] -= w * more * rows[i + ALONG_X];
      vy[c] -= w * more * rows[i + ALONG_Y];
    }
    if (wp > 0) {
      vx[p] += wp * more * rows[i + ALONG_X];
      vy[p] += wp * more * rows[i + ALONG_Y];
    }
    rows[i + TENSION] = rows[i + PER_X];
    rows[i + TOTAL] -= more;
  }
}
