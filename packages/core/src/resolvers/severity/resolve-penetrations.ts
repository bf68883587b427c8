import { type ContactBuffer, SCENERY } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { ContactTable } from './contact-table.ts';
import type { Tournament } from './tournament.ts';

/** A penetration below this counts as none. Unit: m. */
export const DEPTH_EPSILON = 1e-9;

/** How far the phase has moved each particle. Unit: m. */
export interface Shifts {
  x: Float64Array;
  y: Float64Array;
}

/**
 * Resolves, one by one, the deepest contact: its particles move apart along the normal, in inverse proportion to their
 * masses; then the depths of the contacts that share them are found anew. Ends when none is left.
 * Reads a, b, normal, penetration, inverseMass. Writes x, y and the shifts.
 * @param shifts - As long as the particles, all 0.
 * @param limit - Most contacts to resolve.
 * @returns How many contacts were resolved.
 */
export function resolvePenetrations(
  contacts: ContactBuffer,
  particles: ParticleArrays,
  shifts: Shifts,
  table: ContactTable,
  tournament: Tournament,
  limit: number,
): number {
  const { count, a, b, normalX, normalY } = contacts;
  const { inverseMass } = particles;
  tournament.resize(count);
  const { keys } = tournament;
  for (let c = 0; c < count; c++) keys[c] = -depth(contacts, particles, shifts, c);
  tournament.start();

  let iterations = 0;
  for (; iterations < limit; iterations++) {
    const c = tournament.winner;
    const penetration = -keys[c];
    if (!(penetration > DEPTH_EPSILON)) break;
    const i = a[c];
    const j = b[c];
    const wi = inverseMass[i];
    const wj = j === SCENERY ? 0 : inverseMass[j];
    const move = penetration / (wi + wj);
    shifts.x[i] += move * wi * normalX[c];
    shifts.y[i] += move * wi * normalY[c];
    if (j !== SCENERY) {
      shifts.x[j] -= move * wj * normalX[c];
      shifts.y[j] -= move * wj * normalY[c];
      refresh(contacts, particles, shifts, table, tournament, j);
    }
    refresh(contacts, particles, shifts, table, tournament, i);
  }
  applyShifts(particles, shifts);
  return iterations;
}

/** How deep a contact is after the shifts so far, or -Infinity where neither can move. Unit: m. */
export function depth(contacts: ContactBuffer, { inverseMass }: ParticleArrays, shifts: Shifts, c: number): number {
  const i = contacts.a[c];
  const j = contacts.b[c];
  const nx = contacts.normalX[c];
  const ny = contacts.normalY[c];
  if (inverseMass[i] + (j === SCENERY ? 0 : inverseMass[j]) === 0) return -Infinity;
  const ofFirst = shifts.x[i] * nx + shifts.y[i] * ny;
  const ofSecond = j === SCENERY ? 0 : shifts.x[j] * nx + shifts.y[j] * ny;
  return contacts.penetration[c] - (ofFirst - ofSecond);
}

function refresh(
  contacts: ContactBuffer,
  particles: ParticleArrays,
  shifts: Shifts,
  table: ContactTable,
  tournament: Tournament,
  slot: number,
): void {
  const end = table.first[slot + 1];
  for (let t = table.first[slot]; t < end; t++) {
    const c = table.contacts[t];
    tournament.keys[c] = -depth(contacts, particles, shifts, c);
    tournament.update(c);
  }
}

function applyShifts({ count, x, y }: ParticleArrays, shifts: Shifts): void {
  for (let i = 0; i < count; i++) {
    x[i] += shifts.x[i];
    y[i] += shifts.y[i];
  }
}
