import { GOAL, NODE, PIECE, ROW, TENSION, type TreeTable, VX, VY, X, Y } from './tree-table.ts';

/** A cable that pulls counts as taut up to this share short of its length. */
const NEAR = 0.02;
/** One that did not pull is taut but for rounding. */
const ROUNDING = 1e-9;
/** A cable jerks again once it was shorter than its length by more than this share. */
const LOOSE = 0.001;

/**
 * Decides at which of its limits each link of a tree is that has two, and for which length it aims: one that jerks is let spring back.
 * Reads the nodes, the limits, the tensions. Writes `side`, `taut` and the goals.
 */
export function aimLinks(t: TreeTable, from: number, to: number): void {
  const h = t.shared[PIECE];
  const { minLength, maxLength, restitution, side, taut, rows } = t;
  for (let k = from + 1; k < to; k++) {
    if (side[k] === 2) continue;
    const min = minLength[k];
    const max = maxLength[k];
    const length = distance(t, k, 0);
    const next = distance(t, k, h);
    const before = rows[k * ROW + TENSION];
    const springs = taut[k] === 0 ? restitution[k] : 0;
    let aim = max;
    side[k] = 0;
    if (next > max * (1 - (before > 0 ? NEAR : ROUNDING))) {
      side[k] = 1;
      if (springs > 0) aim = Math.min(max, length - springs * (next - length));
    } else if (next < min * (1 + (before < 0 ? NEAR : ROUNDING))) {
      side[k] = -1;
      aim = springs > 0 ? Math.max(min, length + springs * (length - next)) : min;
    }
    taut[k] = next > (1 - LOOSE) * max || next < (1 + LOOSE) * min ? 1 : 0;
    rows[k * ROW + GOAL] = aim;
  }
}

/** Frees the links that push where they can only pull, or pull where they can only push. Returns whether there are any. */
export function freeLinks({ side, rows }: TreeTable, from: number, to: number): boolean {
  let any = false;
  for (let k = from + 1; k < to; k++) {
    if (side[k] === 2 || side[k] * rows[k * ROW + TENSION] >= 0) continue;
    side[k] = 0;
    any = true;
  }
  return any;
}

/** Length of the link of a row in `h` seconds. */
function distance({ node, parent, nodes }: TreeTable, k: number, h: number): number {
  const i = node[k] * NODE;
  const j = node[parent[k]] * NODE;
  const dx = nodes[j + X] - nodes[i + X] + h * (nodes[j + VX] - nodes[i + VX]);
  const dy = nodes[j + Y] - nodes[i + Y] + h * (nodes[j + VY] - nodes[i + VY]);
  return Math.sqrt(dx * dx + dy * dy);
}
