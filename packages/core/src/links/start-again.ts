import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { INVERSE_MASS, NODE, POINT, ROW, TENSION, TOTAL, type TreeTable } from './solve-tree.ts';

/**
 * Gives the links of a tree the tension again that they had a small step before, along where they point now. Reads places.
 * Writes velocities and tensions.
 * @param share - How much of it: the ratio of the small steps' durations.
 */
export function startAgain(
  t: TreeTable,
  from: number,
  to: number,
  { x, y, vx, vy }: ParticleArrays,
  share: number,
): void {
  const { slot, parent, rows, nodes } = t;
  for (let k = from + 1; k < to; k++) {
    const i = k * ROW;
    const n = k * NODE + POINT;
    const m = parent[k] * NODE + POINT;
    const c = slot[k];
    const p = slot[parent[k]];
    const tension = rows[i + TENSION] * share;
    rows[i + TENSION] = tension;
    rows[i + TOTAL] += tension;
    const jx = tension * ((p < 0 ? nodes[m] : x[p]) - (c < 0 ? nodes[n] : x[c]));
    const jy = tension * ((p < 0 ? nodes[m + 1] : y[p]) - (c < 0 ? nodes[n + 1] : y[c]));
    const w = rows[i + INVERSE_MASS];
    const wp = rows[parent[k] * ROW + INVERSE_MASS];
    if (w > 0) {
      vx[c] += jx * w;
      vy[c] += jy * w;
    }
    if (wp > 0) {
      vx[p] -= jx * wp;
      vy[p] -= jy * wp;
    }
  }
}
