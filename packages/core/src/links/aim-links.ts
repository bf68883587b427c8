import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { CORRECTION, NEAR, NODE, POINT, ROUNDING, type TreeTable } from './solve-tree.ts';
import type { StiffTable } from './stiff-table.ts';

/** Share of what a link is off by that is mended at once where energy is to be taken out. */
const GENTLY = 0.1;

/** A cable jerks again once it was shorter than its length by more than this share. */
const LOOSE = 0.001;

/**
 * Decides at which of its limits each link of a tree is, and for which length it aims: a link that is far off is brought back in
 * several small steps, and one that jerks is let spring back. Reads places and velocities. Writes `side`, `taut` and `goal`.
 */
export function aimLinks(
  t: TreeTable,
  stiff: StiffTable,
  from: number,
  to: number,
  particles: ParticleArrays,
  h: number,
  calm: number,
): void {
  const { minLength, maxLength, compliance, restitution, side, taut, goal, before } = stiff;
  for (let k = from + 1; k < to; k++) {
    const min = minLength[k];
    const max = maxLength[k];
    const length = distance(t, k, particles, 0);
    let aim = max;
    if (min === max) side[k] = 2;
    else {
      const next = distance(t, k, particles, h);
      const springs = taut[k] === 0 ? restitution[k] : 0;
      side[k] = 0;
      if (next > max * (1 - (before[k] > 0 ? NEAR : ROUNDING))) {
        side[k] = 1;
        if (springs > 0) aim = Math.min(max, length - springs * (next - length));
      } else if (next < min * (1 + (before[k] < 0 ? NEAR : ROUNDING))) {
        side[k] = -1;
        aim = springs > 0 ? Math.max(min, length + springs * (length - next)) : min;
      }
      taut[k] = next > (1 - LOOSE) * max || next < (1 + LOOSE) * min ? 1 : 0;
    }
    if (compliance[k] === 0) {
      const off = aim - length;
      if (calm === 1 && (side[k] === 2 || side[k] * off < 0)) aim = length + GENTLY * off;
      if (length > (1 + CORRECTION) * aim) aim = length - CORRECTION * aim;
      else if (length < (1 - CORRECTION) * aim) aim = length + CORRECTION * aim;
    }
    goal[k] = aim;
  }
}

/** Length of the link of a row in `h` seconds. */
function distance({ slot, parent, nodes }: TreeTable, k: number, { x, y, vx, vy }: ParticleArrays, h: number): number {
  const c = slot[k];
  const p = slot[parent[k]];
  const n = k * NODE + POINT;
  const m = parent[k] * NODE + POINT;
  const dx = (p < 0 ? nodes[m] : x[p] + h * vx[p]) - (c < 0 ? nodes[n] : x[c] + h * vx[c]);
  const dy = (p < 0 ? nodes[m + 1] : y[p] + h * vy[p]) - (c < 0 ? nodes[n + 1] : y[c] + h * vy[c]);
  return Math.sqrt(dx * dx + dy * dy);
}
