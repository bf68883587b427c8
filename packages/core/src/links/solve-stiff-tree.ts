import type { ParticleArrays } from '../particles/particle-arrays.ts';
import {
  ALONG_X,
  ALONG_Y,
  CHANGE,
  DONE,
  FAILED,
  GAIN,
  INVERSE_MASS,
  NODE,
  OWN,
  PER_X,
  PER_Y,
  POINT,
  PUSHES,
  ROUGH,
  ROW,
  SWIFT,
  TENSION,
  TOTAL,
  type TreeTable,
} from './solve-tree.ts';
import { ACROSS, type StiffTable } from './stiff-table.ts';

/** Ends nearer than this share of the length are at one place. */
const NOWHERE = 1e-6;
/** The least part of what a link would resist along e that it must resist along s: below it the two differ too much. */
const ALIGNED = 0.3;
/** What links below leave of the mobility of a link, if not rounding alone. */
const HELD = 1e-9;
/** Up to here the sideways swing that a tension makes is stable by itself: the square of its frequency times the small step. */
const SLOW = 2;
/** Beyond this a tension is that of a jerk, which will not last. */
const MOST_SWIFT = 1000;
/** A link that turns by more than 60° is taken at its end: the square of the cosine. One by 15° wants a second pass. */
const FAR = 0.25;
const WIDE = 0.93;

/**
 * `eliminate` for every kind of link. What is new: links at neither limit; compliance; links
 * that damp, or turn too far, pull along e nearer to s; and tensions that would swing the ends sideways faster than small steps
 * can follow turn with the link: a second unknown, the impulse μq across it, with μ = κ q·(u_p - u_c) (the geometric
 * stiffness; M. Tournier et al., Stable Constrained Dynamics, 2015). That is stable, and damps what is too fast to be seen.
 * @param calm - Least share of the way from start to end at which e is taken: at 1 all matrices are symmetric.
 */
// biome-ignore lint/complexity/noExcessiveLinesPerFunction: numbers that go from function to function cost a box each
export function eliminateStiff(
  t: TreeTable,
  stiff: StiffTable,
  from: number,
  to: number,
  particles: ParticleArrays,
  h: number,
  calm: number,
): number {
  const { slot, parent, rows, nodes } = t;
  const { side, goal, before, compliance, damping, across } = stiff;
  const { x, y, vx, vy } = particles;
  let result = DONE;
  for (let k = from; k < to; k++) {
    const n = k * NODE;
    nodes[n] = nodes[n + 3] = rows[k * ROW + INVERSE_MASS];
    nodes[n + 1] = nodes[n + 2] = nodes[n + CHANGE] = nodes[n + CHANGE + 1] = 0;
  }
  for (let k = to - 1; k > from; k--) {
    const i = k * ROW;
    const a = k * ACROSS;
    const n = k * NODE;
    const m = parent[k] * NODE;
    const c = slot[k];
    const p = slot[parent[k]];
    const dx = (p < 0 ? nodes[m + POINT] : x[p]) - (c < 0 ? nodes[n + POINT] : x[c]);
    const dy = (p < 0 ? nodes[m + POINT + 1] : y[p]) - (c < 0 ? nodes[n + POINT + 1] : y[c]);
    const gx = h * ((p < 0 ? 0 : vx[p]) - (c < 0 ? 0 : vx[c]));
    const gy = h * ((p < 0 ? 0 : vy[p]) - (c < 0 ? 0 : vy[c]));
    const dd = dx * dx + dy * dy;
    let sx = dx + gx;
    let sy = dy + gy;
    let s = Math.sqrt(sx * sx + sy * sy);
    const turn = sx * dx + sy * dy;
    const inverseMass = rows[i + INVERSE_MASS] + rows[parent[k] * ROW + INVERSE_MASS];
    const swift = Math.min(2 * h * before[k] * inverseMass, MOST_SWIFT);
    let blend = Math.max(damping[k], calm, swift > SLOW ? 1 - SLOW / swift : 0);
    if (turn <= 0 || turn * turn < FAR * s * s * dd) blend = 1;
    if (turn * turn < WIDE * s * s * dd) result = ROUGH;
    let ex = dx + blend * gx;
    let ey = dy + blend * gy;
    let g = ((goal[k] - s) * s) / h;
    if (s < NOWHERE * goal[k]) {
      sx = ex = 0; // ends on one place define no direction: any will do
      sy = ey = goal[k];
      g = ((goal[k] - s) * goal[k]) / h;
      s = goal[k];
    }
    const kappa = swift > SLOW && dd > 0 ? (blend * swift) / (2 * inverseMass * dd) : 0;
    const wxx = nodes[n] + nodes[m];
    const wxy = nodes[n + 1] + nodes[m + 1];
    const wyx = nodes[n + 2] + nodes[m + 2];
    const wyy = nodes[n + 3] + nodes[m + 3];
    const wex = wxx * ex + wxy * ey;
    const wey = wyx * ex + wyy * ey;
    const wqx = wxy * dx - wxx * dy;
    const wqy = wyy * dx - wyx * dy;
    const give = compliance[k] > 0 ? (compliance[k] * s * Math.sqrt(ex * ex + ey * ey)) / (h * h) : 0;
    const along = sx * wex + sy * wey;
    rows[i + ALONG_X] = ex;
    rows[i + ALONG_Y] = ey;
    if (side[k] === 0 || !(along + give > HELD * inverseMass * s * s)) {
      if (side[k] !== 0 && calm < 1 && !(along >= 0)) return FAILED;
      rows[i + OWN] = rows[i + PER_X] = rows[i + PER_Y] = 0;
      across[a] = across[a + 1] = across[a + 2] = 0;
    } else {
      if (!(along > ALIGNED * (ex * wex + ey * wey)) && calm < 1) return FAILED;
      const d11 = along + give;
      const d12 = sx * wqx + sy * wqy;
      const d21 = kappa * (dx * wey - dy * wex);
      const d22 = kappa * (dx * wqy - dy * wqx) + 1;
      const det = d11 * d22 - d12 * d21;
      if (!(det > 0) && calm < 1) return FAILED;
      const ux = nodes[m + CHANGE] - nodes[n + CHANGE];
      const uy = nodes[m + CHANGE + 1] - nodes[n + CHANGE + 1];
      const r1 = sx * ux + sy * uy - g - give * rows[i + TENSION];
      const r2 = kappa * (dx * uy - dy * ux);
      const ax = sx * nodes[m] + sy * nodes[m + 2];
      const ay = sx * nodes[m + 1] + sy * nodes[m + 3];
      const bx = kappa * (dx * nodes[m + 2] - dy * nodes[m]);
      const by = kappa * (dx * nodes[m + 3] - dy * nodes[m + 1]);
      rows[i + OWN] = (d22 * r1 - d12 * r2) / det;
      rows[i + PER_X] = (d22 * ax - d12 * bx) / det;
      rows[i + PER_Y] = (d22 * ay - d12 * by) / det;
      across[a] = (d11 * r2 - d21 * r1) / det;
      across[a + 1] = (d11 * bx - d21 * ax) / det;
      across[a + 2] = (d11 * by - d21 * ay) / det;
    }
    across[a + 3] = -dy;
    across[a + 4] = dx;
    const pex = nodes[m] * ex + nodes[m + 1] * ey;
    const pey = nodes[m + 2] * ex + nodes[m + 3] * ey;
    const pqx = nodes[m + 1] * dx - nodes[m] * dy;
    const pqy = nodes[m + 3] * dx - nodes[m + 2] * dy;
    nodes[m] -= pex * rows[i + PER_X] + pqx * across[a + 1];
    nodes[m + 1] -= pex * rows[i + PER_Y] + pqx * across[a + 2];
    nodes[m + 2] -= pey * rows[i + PER_X] + pqy * across[a + 1];
    nodes[m + 3] -= pey * rows[i + PER_Y] + pqy * across[a + 2];
    nodes[m + CHANGE] -= pex * rows[i + OWN] + pqx * across[a];
    nodes[m + CHANGE + 1] -= pey * rows[i + OWN] + pqy * across[a];
  }
  return result;
}

/** `substitute` for every kind of link: tensions come on top of those that are there. */
export function substituteStiff(
  t: TreeTable,
  stiff: StiffTable,
  from: number,
  to: number,
  particles: ParticleArrays,
  h: number,
): number {
  const { slot, parent, rows, nodes } = t;
  const { side, across } = stiff;
  const { vx, vy } = particles;
  let found = 0;
  let gain = 0;
  nodes[from * NODE + CHANGE] = nodes[from * NODE + CHANGE + 1] = 0;
  for (let k = from + 1; k < to; k++) {
    const i = k * ROW;
    const a = k * ACROSS;
    const p = parent[k];
    const n = k * NODE + CHANGE;
    const m = p * NODE + CHANGE;
    const jx = nodes[m];
    const jy = nodes[m + 1];
    const more = rows[i + OWN] + rows[i + PER_X] * jx + rows[i + PER_Y] * jy;
    const turn = across[a] + across[a + 1] * jx + across[a + 2] * jy;
    const ix = more * rows[i + ALONG_X] + turn * across[a + 3];
    const iy = more * rows[i + ALONG_Y] + turn * across[a + 4];
    nodes[m] = jx - ix;
    nodes[m + 1] = jy - iy;
    nodes[n] = ix;
    nodes[n + 1] = iy;
    const wp = rows[p * ROW + INVERSE_MASS];
    const w = rows[i + INVERSE_MASS];
    if (wp > 0) {
      const s = slot[p];
      gain -= ix * (vx[s] - 0.5 * wp * ix) + iy * (vy[s] - 0.5 * wp * iy);
      vx[s] -= wp * ix;
      vy[s] -= wp * iy;
    }
    if (w > 0) {
      const s = slot[k];
      gain += ix * (vx[s] + 0.5 * w * ix) + iy * (vy[s] + 0.5 * w * iy);
      vx[s] += w * ix;
      vy[s] += w * iy;
    }
    const tension = rows[i + TENSION] + more;
    rows[i + TENSION] = tension;
    rows[i + TOTAL] += more;
    if (h * tension * (w + wp) > 1) found |= SWIFT;
    if (side[k] < 2 && side[k] * tension < 0) found |= PUSHES;
  }
  rows[from * ROW + GAIN] = gain;
  return found;
}
