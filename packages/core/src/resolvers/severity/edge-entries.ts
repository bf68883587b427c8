import { type ContactBuffer, NO_EDGE } from '../../contacts/contact-buffer.ts';
import type { ContactTable } from './contact-table.ts';
import { type LeastTree, setLeaf } from './least-tree.ts';
import type { Phase } from './phase.ts';

/**
 * The contacts with edges, which take part in three particles: u of the place on the edge is (1 - t)·u_b + t·u_e, and what goes
 * along the normal is shared in the same way. Those of slot s are `contact[first[s]]` to `contact[first[s + 1] - 1]`.
 */
export class EdgeEntries {
  count = 0;
  first: Int32Array = new Int32Array(1);
  /** The contact's index. */
  contact: Int32Array = new Int32Array(0);

  /** Leaves out contacts of which none can move. Reads a, b, edge, inverseMass. Writes the entries. */
  build(contacts: ContactBuffer, inverseMass: Float64Array, slotCount: number): void {
    const { count, a, b, edgeEnd } = contacts;
    let found = 0;
    for (let c = 0; c < count; c++) if (edgeEnd[c] !== NO_EDGE && edgeWeight(c, contacts, inverseMass) > 0) found++;
    this.count = found;
    if (found === 0) return;
    if (this.first.length < slotCount + 2) this.first = new Int32Array(slotCount * 2 + 2);
    if (this.contact.length < found * 3) this.contact = new Int32Array(found * 6);
    const { first, contact } = this;
    first.fill(0, 0, slotCount + 2);
    for (let c = 0; c < count; c++) {
      if (edgeEnd[c] === NO_EDGE || edgeWeight(c, contacts, inverseMass) === 0) continue;
      first[a[c]]++;
      first[b[c]]++;
      first[edgeEnd[c]]++;
    }
    for (let s = 0, sum = 0; s <= slotCount + 1; s++) {
      sum += first[s];
      first[s] = sum;
    }
    for (let c = count - 1; c >= 0; c--) {
      if (edgeEnd[c] === NO_EDGE || edgeWeight(c, contacts, inverseMass) === 0) continue;
      contact[--first[a[c]]] = c;
      contact[--first[b[c]]] = c;
      contact[--first[edgeEnd[c]]] = c;
    }
  }
}

/** Finds the numbers of all contacts with edges. Writes leaves of a tree that is not built yet. */
export function numberEdges(
  contacts: ContactBuffer,
  phase: Phase,
  { first, contact }: EdgeEntries,
  tree: LeastTree,
): void {
  const last = first[phase.u.length / 2];
  for (let t = 0; t < last; t++) tree.nodes[tree.leaves + contact[t]] = edgeNumber(contact[t], contacts, phase);
}

/** Finds the numbers anew that a change of u of one slot changed. */
export function renewEdges(
  slot: number,
  contacts: ContactBuffer,
  phase: Phase,
  { first, contact }: EdgeEntries,
  { nodes, leaves }: LeastTree,
): void {
  for (let t = first[slot]; t < first[slot + 1]; t++) {
    setLeaf(nodes, leaves + contact[t], edgeNumber(contact[t], contacts, phase));
  }
}

/** Resolves one contact with an edge, and finds the numbers anew that this changed. Writes u and impulse. */
export function resolveEdge(
  c: number,
  contacts: ContactBuffer,
  phase: Phase,
  table: ContactTable,
  edges: EdgeEntries,
  tree: LeastTree,
): void {
  const { a, b, normalX, normalY, edgeEnd, edgeShare } = contacts;
  const { inverseMass, resting, restitution, impulse } = phase;
  const value = edgeNumber(c, contacts, phase);
  const after = -value <= resting[c] ? 0 : -restitution[c] * value;
  const J = (after - value) / edgeWeight(c, contacts, inverseMass);
  const share = edgeShare[c];
  const nx = normalX[c];
  const ny = normalY[c];
  impulse[c] += J;
  push(a[c], J, nx, ny, phase);
  push(b[c], (share - 1) * J, nx, ny, phase);
  push(edgeEnd[c], -share * J, nx, ny, phase);
  renew(a[c], contacts, phase, table, edges, tree);
  renew(b[c], contacts, phase, table, edges, tree);
  renew(edgeEnd[c], contacts, phase, table, edges, tree);
}

/** (u_a - u_edge)·n less the penetration. */
function edgeNumber(c: number, contacts: ContactBuffer, { u, penetration }: Phase): number {
  const i = contacts.a[c] * 2;
  const j = contacts.b[c] * 2;
  const k = contacts.edgeEnd[c] * 2;
  const share = contacts.edgeShare[c];
  const x = u[i] - (u[j] + share * (u[k] - u[j]));
  const y = u[i + 1] - (u[j + 1] + share * (u[k + 1] - u[j + 1]));
  return x * contacts.normalX[c] + y * contacts.normalY[c] - penetration[c];
}

/** How much the number changes for each unit of impulse: w_a + (1 - t)²·w_b + t²·w_e. */
function edgeWeight(c: number, { a, b, edgeEnd, edgeShare }: ContactBuffer, inverseMass: Float64Array): number {
  const share = edgeShare[c];
  return inverseMass[a[c]] + (1 - share) * (1 - share) * inverseMass[b[c]] + share * share * inverseMass[edgeEnd[c]];
}

function push(slot: number, J: number, nx: number, ny: number, { u, inverseMass }: Phase): void {
  u[slot * 2] += J * inverseMass[slot] * nx;
  u[slot * 2 + 1] += J * inverseMass[slot] * ny;
}

/** Finds the numbers of all contacts of a slot anew. */
function renew(
  slot: number,
  contacts: ContactBuffer,
  phase: Phase,
  table: ContactTable,
  edges: EdgeEntries,
  tree: LeastTree,
): void {
  const { first, contact, other, normalX, normalY } = table;
  const { u, penetration } = phase;
  const x = u[slot * 2];
  const y = u[slot * 2 + 1];
  for (let t = first[slot]; t < first[slot + 1]; t++) {
    const o = other[t] * 2;
    const next = (x - u[o]) * normalX[t] + (y - u[o + 1]) * normalY[t] - penetration[contact[t]];
    setLeaf(tree.nodes, tree.leaves + contact[t], next);
  }
  renewEdges(slot, contacts, phase, edges, tree);
}
