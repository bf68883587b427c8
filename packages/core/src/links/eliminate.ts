import { aim, ROD } from './aim.ts';
import type { ForestTable } from './forest-table.ts';

/** Share of its length that a link is brought back by at most in one small step. */
const CORRECTION = 0.1;

/** Ends nearer than this share of the length are at one place. */
const NOWHERE = 1e-6;

/** The least part of what a link would resist along e that it must resist along s: below it the two differ too much. */
const ALIGNED = 0.3;

/** Up to here the sideways swing that a tension makes is stable by itself: the square of its frequency times the small step. */
const SWIFT = 2;

/**
 * From the leaves to the roots: finds for each node how its change of velocity follows from that of its parent. Reads places and
 * velocities of the rows. Writes the effective masses, and what `substitute` needs.
 *
 * The link of child c and parent p, tension λ, is solved together with the child:
 * M u_c = j + λ e + κ q qᵀ (u_p - u_c),   s · (u_p - u_c) = g + ε λ.
 * s is the link as it would be at the end of the small step, e as it is at its start (or in between: see below), q across e.
 * That leaves u_c = y + T u_p and λ = k + K · u_p, and to the parent a matrix more and an impulse more (Featherstone's
 * articulated bodies; Baraff, Linear-time dynamics using Lagrange multipliers, 1996).
 *
 * Pulling along e at the start while the length holds at the end is SHAKE (Ryckaert et al., 1977): it keeps the energy. A tension
 * that would swing the ends sideways faster than small steps can follow is taken as it turns with the link (κ, and e nearer to
 * s): that is stable, and damps what is too fast to be seen.
 * @param calm - Least share of the way from start to end at which e is taken: 1 makes all matrices symmetric and positive.
 * @returns Whether every link could be solved.
 */
// biome-ignore lint/complexity/noExcessiveLinesPerFunction: numbers that pass from function to function are boxed
export function eliminate(t: ForestTable, from: number, to: number, h: number, calm: number, again: boolean): boolean {
  const { parent, moves, side, mass, inverseMass, maxLength, compliance, damping, x, y, vx, vy } = t;
  const { mxx, mxy, myx, myy, jx, jy, ux, uy, txx, txy, tyx, tyy, own, perX, perY, start, tension } = t;
  for (let k = from; k < to; k++) {
    mxx[k] = myy[k] = mass[k];
    mxy[k] = myx[k] = jx[k] = jy[k] = 0;
  }
  for (let k = to - 1; k >= from; k--) {
    const p = parent[k];
    let a = mxx[k];
    let b = mxy[k];
    let c = myx[k];
    let d = myy[k];
    let bx = jx[k];
    let by = jy[k];
    if (p < 0) {
      const inverse = moves[k] / (a * d - b * c);
      ux[k] = (d * bx - b * by) * inverse;
      uy[k] = (a * by - c * bx) * inverse;
      continue;
    }
    const dx = x[p] - x[k];
    const dy = y[p] - y[k];
    const gx = h * (vx[p] - vx[k]);
    const gy = h * (vy[p] - vy[k]);
    const dd = dx * dx + dy * dy;
    let sx = dx + gx;
    let sy = dy + gy;
    let r = Math.sqrt(sx * sx + sy * sy);
    let goal = side[k] === ROD ? maxLength[k] : aim(t, k, dd, r, again);
    if (dd > (1 + CORRECTION) * (1 + CORRECTION) * goal * goal) goal = Math.sqrt(dd) - CORRECTION * goal;
    else if (dd < (1 - CORRECTION) * (1 - CORRECTION) * goal * goal) goal = Math.sqrt(dd) + CORRECTION * goal;
    let g = ((goal - r) * r) / h;
    const turn = sx * dx + sy * dy;
    let blend = Math.max(damping[k], calm);
    const swift = 2 * h * tension[k] * inverseMass[k];
    if (swift > SWIFT && blend < 1 - SWIFT / swift) blend = 1 - SWIFT / swift;
    if (turn <= 0 || 4 * turn * turn < r * r * dd) blend = 1;
    let ex = dx + blend * gx;
    let ey = dy + blend * gy;
    if (r < NOWHERE * goal) {
      sx = ex = 0; // ends on one place define no direction: any will do
      sy = ey = goal;
      g = ((goal - r) * goal) / h;
      r = goal;
    }
    const active = side[k] !== 0;
    let kappa = 0;
    if (swift > SWIFT && active) {
      kappa = (h * blend * tension[k]) / dd;
      const across = (((kappa * start[k]) / tension[k]) * (dx * gy - dy * gx)) / h;
      bx -= dy * across;
      by += dx * across;
      jx[p] += dy * across;
      jy[p] -= dx * across;
      a += kappa * dy * dy;
      b -= kappa * dy * dx;
      c -= kappa * dx * dy;
      d += kappa * dx * dx;
    }
    const inverse = 1 / (a * d - b * c);
    const wx = (d * ex - b * ey) * inverse;
    const wy = (a * ey - c * ex) * inverse;
    const ox = (d * bx - b * by) * inverse;
    const oy = (a * by - c * bx) * inverse;
    const give = (compliance[k] * r * goal) / (h * h);
    const pivot = sx * wx + sy * wy;
    const soft = ex * wx + ey * wy;
    if (active && !(pivot > ALIGNED * soft && soft > 0)) return false;
    const stiffness = active ? 1 / (pivot + give) : 0;
    const k0 = active ? -stiffness * (g + give * start[k] + sx * ox + sy * oy) : -start[k];
    let kx = stiffness * sx;
    let ky = stiffness * sy;
    const yx = ox + wx * k0;
    const yy = oy + wy * k0;
    let ax = 0;
    let ay = 0;
    if (kappa > 0) {
      const qx = (-d * dy - b * dx) * inverse;
      const qy = (a * dx + c * dy) * inverse;
      const sq = kappa * (sx * qx + sy * qy) * stiffness;
      kx += sq * dy;
      ky -= sq * dx;
      txx[k] = wx * kx - kappa * qx * dy;
      txy[k] = wx * ky + kappa * qx * dx;
      tyx[k] = wy * kx - kappa * qy * dy;
      tyy[k] = wy * ky + kappa * qy * dx;
      ax = kappa * (-dy + dy * txx[k] - dx * tyx[k]);
      ay = kappa * (dx + dy * txy[k] - dx * tyy[k]);
      const back = kappa * (dx * yy - dy * yx);
      jx[p] -= dy * back;
      jy[p] += dx * back;
    } else {
      txx[k] = wx * kx;
      txy[k] = wx * ky;
      tyx[k] = wy * kx;
      tyy[k] = wy * ky;
    }
    own[k] = k0;
    perX[k] = kx;
    perY[k] = ky;
    ux[k] = yx;
    uy[k] = yy;
    mxx[p] += ex * kx - dy * ax;
    mxy[p] += ex * ky - dy * ay;
    myx[p] += ey * kx + dx * ax;
    myy[p] += ey * ky + dx * ay;
    jx[p] -= ex * k0;
    jy[p] -= ey * k0;
  }
  return true;
}
