import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { INVERSE_MASS, NODE, POINT, ROW, type TreeTable } from './solve-tree.ts';
import type { StiffTable } from './stiff-table.ts';

/** What counts as no deviation, as a share of twice the length. */
const NONE = 1e-9;

/**
 * Brings the ends of links that do not give within their limits by position alone, one link after the other. Contacts are solved
 * after the links and push ends off their lengths. Brought back by velocity alone, that comes again as speed for the contacts to
 * stop: a rod that stands on the floor trembles for ever, and a column of three or more builds it up. What no contact touches is at its
 * length already and stays as it is. Reads the limits and inverse masses. Writes x, y.
 */
export function straighten(
  { slot, parent, rows, nodes }: TreeTable,
  { minLength, maxLength, compliance }: StiffTable,
  from: number,
  to: number,
  { x, y }: ParticleArrays,
): void {
  for (let k = from + 1; k < to; k++) {
    const p = parent[k];
    const i = slot[k];
    const j = slot[p];
    const wi = rows[k * ROW + INVERSE_MASS];
    const wj = rows[p * ROW + INVERSE_MASS];
    if (compliance[k] > 0 || wi + wj === 0) continue;
    const dx = (j < 0 ? nodes[p * NODE + POINT] : x[j]) - (i < 0 ? nodes[k * NODE + POINT] : x[i]);
    const dy = (j < 0 ? nodes[p * NODE + POINT + 1] : y[j]) - (i < 0 ? nodes[k * NODE + POINT + 1] : y[i]);
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
