import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { GIVE, INVERSE_MASS, NODE, ROW, type TreeTable, X, Y } from './tree-table.ts';

/** What counts as no deviation, as a share of twice the length. */
const NONE = 1e-9;

/**
 * Brings the ends of links that do not give within their limits by position alone, one link after the other. Contacts are solved
 * after the links and push ends off their lengths. Brought back by velocity alone, that comes again as speed for the contacts to
 * stop: a rod that stands on the floor trembles for ever, and a column of three or more builds it up. What no contact touches is at its
 * length already and stays as it is. Reads the limits and inverse masses. Writes x, y.
 */
export function straighten(t: TreeTable, from: number, to: number, { x, y }: ParticleArrays): void {
  const { node, slot, parent, rows, nodes, minLength, maxLength } = t;
  for (let k = from; k < to; k++) {
    if (parent[k] < 0 || rows[k * ROW + GIVE] > 0) continue;
    const m = node[k];
    const n = node[parent[k]];
    const i = slot[m];
    const j = slot[n];
    const wi = nodes[m * NODE + INVERSE_MASS];
    const wj = nodes[n * NODE + INVERSE_MASS];
    if (wi + wj === 0) continue;
    const dx = (j < 0 ? nodes[n * NODE + X] : x[j]) - (i < 0 ? nodes[m * NODE + X] : x[i]);
    const dy = (j < 0 ? nodes[n * NODE + Y] : y[j]) - (i < 0 ? nodes[m * NODE + Y] : y[i]);
    const square = dx * dx + dy * dy;
    const wanted = Math.max(minLength[k] * minLength[k], Math.min(maxLength[k] * maxLength[k], square));
    const over = square - wanted;
    if (Math.abs(over) <= NONE * square) continue;
    const share = over / ((square + wanted) * (wi + wj)); // 1 - wanted length / length, to first order
    if (wi > 0) {
      x[i] += dx * share * wi;
      y[i] += dy * share * wi;
    }
    if (wj > 0) {
      x[j] -= dx * share * wj;
      y[j] -= dy * share * wj;
    }
  }
}
