import { type ContactBuffer, NO_EDGE, SCENERY } from '../../contacts/contact-buffer.ts';
import type { ContactTable } from './contact-table.ts';
import { type EdgeEntries, numberEdges, renewEdges, resolveEdge } from './edge-entries.ts';
import { type LeastTree, leastLeaf, setLeaf } from './least-tree.ts';
import type { Phase } from './phase.ts';

/** What counts as none: a closing speed in m/s, a penetration in m. */
export const EPSILON = 1e-9;

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
  contacts: ContactBuffer,
  phase: Phase,
  table: ContactTable,
  edges: EdgeEntries,
  tree: LeastTree,
  limit: number,
): number {
  const { count, a, b, normalX, normalY, edgeEnd } = contacts;
  const { u, inverseMass, penetration, resting, restitution, impulse } = phase;
  const { first, contact, other, normalX: entryX, normalY: entryY } = table;
  const scenery = u.length / 2 - 1;
  tree.resize(count);
  const { nodes, leaves } = tree;
  for (let c = 0; c < count; c++) {
    const i = a[c];
    const j = b[c] === SCENERY ? scenery : b[c];
    if (edgeEnd[c] !== NO_EDGE || inverseMass[i] + inverseMass[j] === 0) continue;
    nodes[leaves + c] =
      (u[i * 2] - u[j * 2]) * normalX[c] + (u[i * 2 + 1] - u[j * 2 + 1]) * normalY[c] - penetration[c];
  }
  const hasEdges = edges.count > 0;
  if (hasEdges) numberEdges(contacts, phase, edges, tree);
  tree.build();

  for (let iteration = 0; iteration < limit; iteration++) {
    const value = nodes[1];
    if (!(value < -EPSILON)) return iteration;
    const c = leastLeaf(nodes, leaves) - leaves;
    if (hasEdges && edgeEnd[c] !== NO_EDGE) {
      resolveEdge(c, contacts, phase, table, edges, tree);
      continue;
    }
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
    if (hasEdges) {
      renewEdges(i, contacts, phase, edges, tree);
      renewEdges(j, contacts, phase, edges, tree);
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
