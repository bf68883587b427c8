import {
  ALONG_X,
  ALONG_Y,
  CALM,
  CHANGE,
  DAMPING,
  GIVE,
  GOAL,
  HASTE,
  INVERSE_MASS,
  MOBILITY,
  MOST_BACK,
  NODE,
  OWN,
  PER_X,
  PER_Y,
  PIECE,
  ROW,
  SUM,
  TENSION,
  type TreeTable,
  VX,
  VY,
  X,
  Y,
} from './tree-table.ts';

/** A link that turns by more than 60° is none for this method: the square of the cosine. */
const FAR = 0.25;
/** Mobility that the links below leave to a link, as a share of what it is alone: less is rounding. */
const HELD = 1e-9;
/** Ends nearer than this share of the length are at one place: the square. */
const NOWHERE = 1e-12;
/** Haste is 1 where a link turns by 0.2 radians at once: one over the square. */
const PER_TURN = 25;
/** And where a tension swings its ends by 0.7 radians. */
const PER_SWING = 2;

/**
 * From the leaves to the root: eliminates one link after the other, each with one division. Reads the nodes. Writes what
 * `substitute` needs, and how hasty the tree is. Returns whether something came of it: if all is calm, always.
 *
 * An impulse λe on child c, -λe on parent p must make s · (u_p - u_c) = g, with u the changes of velocity, e the link at the
 * start of the small step, s at its end. Of the links below, c keeps its mobility W_c (the inverse of Featherstone's
 * articulated inertia) and the change u_c that they made, so that
 *
 *   λ = (s·(u_p - u_c) - g + k·J) / D,   D = s·(W_c + W_p)e,   u_p -= W_p e λ,   W_p -= (W_p e)(sᵀW_p) / D,
 *
 * J being the impulses that p gets from the links that come later. Along a chain W_c is 1/m less one product, and this is the
 * elimination of a tridiagonal matrix (D. Baraff, Linear-time dynamics using Lagrange multipliers, 1996). What gives adds to D.
 *
 * Pulling along e while the length holds at the end is SHAKE (J.-P. Ryckaert et al., 1977): it keeps the energy. Pulling along s
 * damps, and all matrices are symmetric.
 * @param plain - Whether all are rods that neither give nor damp, and nothing is to be calmed.
 */
// biome-ignore lint/complexity/noExcessiveLinesPerFunction: numbers that go from function to function cost a box each
export function eliminate(t: TreeTable, from: number, to: number, plain: boolean): boolean {
  const { node, parent, children, isLast, side, rows, nodes, shared } = t;
  const h = shared[PIECE];
  const calm = shared[CALM];
  const most = shared[MOST_BACK];
  const tooLong = (1 + most) * (1 + most);
  const tooShort = (1 - most) * (1 - most);
  const perH = 1 / h;
  let haste = 0;
  let cx = 0; // the child
  let cy = 0;
  let cvx = 0;
  let cvy = 0;
  let w = 0;
  let belowSx = 0; // s, e, 1/D and λ of the link below it
  let belowSy = 0;
  let belowEx = 0;
  let belowEy = 0;
  let perD = 0;
  let tension = 0;
  let known = -1;
  let branches = 0;
  for (let k = to - 1; k > from; k--) {
    const i = k * ROW;
    const p = parent[k];
    if (k !== known) {
      const n = node[k] * NODE;
      cx = nodes[n + X];
      cy = nodes[n + Y];
      cvx = nodes[n + VX];
      cvy = nodes[n + VY];
      w = nodes[n + INVERSE_MASS];
      branches = children[k];
    }
    const n = node[p] * NODE;
    const px = nodes[n + X];
    const py = nodes[n + Y];
    const pvx = nodes[n + VX];
    const pvy = nodes[n + VY];
    const wp = nodes[n + INVERSE_MASS];
    const dx = px - cx;
    const dy = py - cy;
    const gx = h * (pvx - cvx);
    const gy = h * (pvy - cvy);
    let goal = rows[i + GOAL];
    let sx = dx + gx;
    let sy = dy + gy;
    let ex = dx;
    let ey = dy;
    let give = 0;
    let held = true;
    if (!plain) {
      const blend = Math.max(rows[i + DAMPING], calm);
      ex += blend * gx;
      ey += blend * gy;
      give = rows[i + GIVE];
      held = side[k] !== 0;
    }
    let ss = sx * sx + sy * sy;
    let gap = 0; // s·(u_p - u_c) - g
    if (held) {
      const square = goal * goal;
      const dd = dx * dx + dy * dy;
      const turn = dx * gy - dy * gx;
      if (turn * turn > haste * (square * square)) haste = (turn * turn) / (square * square);
      if (give === 0) {
        if (dd > tooLong * square) goal = Math.sqrt(dd) - most * goal;
        else if (dd < tooShort * square) goal = Math.sqrt(dd) + most * goal;
      }
      if (ss < NOWHERE * square) {
        sx = ex = 0; // ends on one place define no direction: any will do
        sy = ey = goal;
        gap = -goal * goal * perH;
        ss = goal * goal;
      } else {
        const s = Math.sqrt(ss);
        gap = (s - goal) * s * perH;
        const ahead = dx * sx + dy * sy;
        if (calm < 1 && (ahead <= 0 || ahead * ahead < FAR * ss * dd)) return false;
      }
    }
    const se = sx * ex + sy * ey;
    let own = (w + wp) * se; // D, as long as the parent has no other child
    if (branches === 1) {
      const m = w * (sx * belowEx + sy * belowEy);
      const less = w * (belowSx * ex + belowSy * ey) * perD;
      rows[i + ROW + PER_X] = less;
      own -= m * less;
      gap += m * tension;
    } else if (branches > 1) {
      const ax = rows[i + MOBILITY] * ex + rows[i + MOBILITY + 1] * ey;
      const ay = rows[i + MOBILITY + 2] * ex + rows[i + MOBILITY + 3] * ey;
      own = sx * ax + sy * ay + wp * se;
      gap -= sx * rows[i + CHANGE] + sy * rows[i + CHANGE + 1];
    }
    if (give > 0) own += (give * Math.sqrt(ss * (ex * ex + ey * ey))) / (h * h);
    const least = HELD * (w + wp) * ss; // or else other links hold it already
    branches = children[p];
    if (branches === 1) {
      if (calm < 1 && held && own < 0) return false;
      perD = held && own > least ? 1 / own : 0;
      tension = gap * perD;
    } else {
      const j = p * ROW;
      if (isLast[k] === 1) {
        rows[j + MOBILITY] = rows[j + MOBILITY + 3] = wp;
        rows[j + MOBILITY + 1] = rows[j + MOBILITY + 2] = rows[j + CHANGE] = rows[j + CHANGE + 1] = 0;
      }
      const ax = rows[j + MOBILITY] * ex + rows[j + MOBILITY + 1] * ey;
      const ay = rows[j + MOBILITY + 2] * ex + rows[j + MOBILITY + 3] * ey;
      const d = own - wp * se + sx * ax + sy * ay;
      perD = held && d > least ? 1 / d : 0;
      tension = (gap + sx * rows[j + CHANGE] + sy * rows[j + CHANGE + 1]) * perD;
      const kx = (sx * rows[j + MOBILITY] + sy * rows[j + MOBILITY + 2]) * perD;
      const ky = (sx * rows[j + MOBILITY + 1] + sy * rows[j + MOBILITY + 3]) * perD;
      rows[i + PER_X] = kx;
      rows[i + PER_Y] = ky;
      rows[j + MOBILITY] -= ax * kx;
      rows[j + MOBILITY + 1] -= ax * ky;
      rows[j + MOBILITY + 2] -= ay * kx;
      rows[j + MOBILITY + 3] -= ay * ky;
      rows[j + CHANGE] -= ax * tension;
      rows[j + CHANGE + 1] -= ay * tension;
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
    w = wp;
    known = p;
  }
  shared[HASTE] = Math.max(shared[HASTE], haste * PER_TURN);
  return true;
}

/** From the root to the leaves: finds the tensions, and gives the nodes their velocities. Tells how hasty the tree is. */
export function substitute({ node, parent, children, rows, nodes, shared }: TreeTable, from: number, to: number): void {
  let swing = 0;
  let jx = 0; // impulse on the parent so far
  let jy = 0;
  let tension = 0;
  let known = -1;
  let n = 0;
  let wp = 0;
  let branches = 0;
  rows[from * ROW + CHANGE] = rows[from * ROW + CHANGE + 1] = rows[(from + 1) * ROW + PER_X] = 0;
  for (let k = from + 1; k < to; k++) {
    const i = k * ROW;
    const p = parent[k];
    if (p !== known) {
      n = node[p] * NODE;
      wp = nodes[n + INVERSE_MASS];
      branches = children[p];
    }
    const c = node[k] * NODE;
    const w = nodes[c + INVERSE_MASS];
    const ex = rows[i + ALONG_X];
    const ey = rows[i + ALONG_Y];
    if (branches === 1) {
      tension = rows[i + OWN] + rows[i + PER_X] * tension;
      jx -= tension * ex;
      jy -= tension * ey;
      nodes[n + VX] += wp * jx;
      nodes[n + VY] += wp * jy;
    } else {
      const j = p * ROW;
      jx = rows[j + CHANGE];
      jy = rows[j + CHANGE + 1];
      tension = rows[i + OWN] + rows[i + PER_X] * jx + rows[i + PER_Y] * jy;
      rows[j + CHANGE] -= tension * ex;
      rows[j + CHANGE + 1] -= tension * ey;
      nodes[n + VX] -= wp * tension * ex;
      nodes[n + VY] -= wp * tension * ey;
    }
    jx = tension * ex;
    jy = tension * ey;
    branches = children[k];
    if (branches !== 1) {
      nodes[c + VX] += w * jx;
      nodes[c + VY] += w * jy;
      rows[i + CHANGE] = jx;
      rows[i + CHANGE + 1] = jy;
    }
    rows[i + TENSION] = tension;
    rows[i + SUM] += tension;
    const swings = Math.abs(tension) * (w + wp);
    if (swings > swing) swing = swings;
    known = k;
    n = c;
    wp = w;
  }
  shared[HASTE] = Math.max(shared[HASTE], swing * shared[PIECE] * PER_SWING);
}
