import { type ContactBuffer, SCENERY } from '../../contacts/contact-buffer.ts';
import type { ContactTable } from './contact-table.ts';
import { type LeastTree, leastLeaf, setLeaf } from './least-tree.ts';

/** What counts as none: a closing speed in m/s, a penetration in m. */
export const EPSILON = 1e-9;

/**
 * What one of the two phases works on. The number of a contact is (u_a - u_b)·n less its penetration: the least is the most
 * severe. For velocities u is the velocity and the penetration 0; for penetrations u is how far the phase has moved things.
 */
export interface Phase {
  /** u of each slot, x and y in turn; scenery, after all others, has 0. */
  readonly u: Float64Array;
  /** Of each slot, scenery included. Unit: 1/kg. */
  readonly inverseMass: Float64Array;
  /** Of each contact. */
  readonly penetration: Float64Array;
  /** A contact whose number is no less than minus this comes out at 0. */
  readonly resting: Float64Array;
  /** Any other comes out at minus its number times this. */
  readonly restitution: Float64Array;
  /** Sum of what went along the normal, times mass. */
  readonly impulse: Float64Array;
}

/**
 * Resolves, one by one, the most severe contact: its number is brought up to where it should be by a change of u along the
 * normal, shared in inverse proportion to mass; then the numbers of the contacts that share its particles are found anew.
 * Ends when none is left. Reads the phase and the contacts. Writes u and impulse.
 *
 * The kernel stays whole: velocities and penetrations are the same loop, which is where all the time of the resolver goes.
 * @param limit - Most contacts to resolve.
 * @returns How many were resolved.
 */
export function resolveMostSevereFirst(
  { count, a, b, normalX, normalY }: ContactBuffer,
  { u, inverseMass, penetration, resting, restitution, impulse }: Phase,
  table: ContactTable,
  tree: LeastTree,
  limit: number,
): number {
  const { first, contact, other, normalX: entryX, normalY: entryY } = table;
  const scenery = u.length / 2 - 1;
  tree.resize(count);
  const { nodes, leaves } = tree;
  for (let c = 0; c < count; c++) {
    const i = a[c];
    const j = b[c] === SCENERY ? scenery : b[c];
    if (inverseMass[i] + inverseMass[j] === 0) continue;
    nodes[leaves + c] =
      (u[i * 2] - u[j * 2]) * normalX[c] + (u[i * 2 + 1] - u[j * 2 + 1]) * normalY[c] - penetration[c];
  }
  tree.build();

  for (let iteration = 0; iteration < limit; iteration++) {
    const value = nodes[1];
    if (!(value < -EPSILON)) return iteration;
    const c = leastLeaf(nodes, leaves) - leaves;
    const i = a[c];
    const j = b[c] === SCENERY ? scenery : b[c];
    const after = -value <= resting[c] ? 0 : -restitution[c] * value;
    const J = (after - value) / (inverseMass[i] + inverseMass[j]);
    impulse[c] += J;
    let x = u[i * 2] + J * inverseMass[i] * normalX[c];
    let y = u[i * 2 + 1] + J * inverseMass[i] * normalY[c];
    u[i * 2] = x;
    u[i * 2 + 1] = y;
    if (j !== scenery) {
      u[j * 2] -= J * inverseMass[j] * normalX[c];
      u[j * 2 + 1] -= J * inverseMass[j] * normalY[c];
    }
    for (let t = first[i]; t < first[i + 1]; t++) {
      const o = other[t] * 2;
      const next = (x - u[o]) * entryX[t] + (y - u[o + 1]) * entryY[t] - penetration[contact[t]];
      setLeaf(nodes, leaves + contact[t], next);
    }
    if (j === scenery) continue;
    x = u[j * 2];
    y = u[j * 2 + 1];
    for (let t = first[j]; t < first[j + 1]; t++) {
      if (other[t] === i) continue; // found anew above
      const o = other[t] * 2;
      const next = (x - u[o]) * entryX[t] + (y - u[o + 1]) * entryY[t] - penetration[contact[t]];
      setLeaf(nodes, leaves + contact[t], next);
    }
  }
  return limit;
}
