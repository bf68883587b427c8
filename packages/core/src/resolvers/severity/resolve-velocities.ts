import { type ContactBuffer, SCENERY } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { ContactTable } from './contact-table.ts';
import type { Tournament } from './tournament.ts';

/** A closing speed below this counts as none. Unit: m/s. */
export const SPEED_EPSILON = 1e-9;

/**
 * A contact rests when it closes no faster than the acceleration of a step and of the one before can make it: found a step
 * late, as it may be, a thing at rest closes with twice the speed that one step builds. The last hundredth is for rounding.
 */
const RESTING_SLACK = 2.02;

/**
 * Resolves, one by one, the contact that closes fastest: its separating velocity v_s becomes -c·v_s, or 0 where it rests;
 * then those of the contacts that share its particles are found anew. Ends when none closes any more.
 * Reads a, b, normal, restitution, inverseMass, resting. Writes vx, vy and the contacts' impulse.
 * @param resting - For each contact the closing speed up to which it rests: see `findRestingSpeeds`.
 * @param limit - Most contacts to resolve.
 * @returns How many contacts were resolved.
 */
export function resolveVelocities(
  contacts: ContactBuffer,
  particles: ParticleArrays,
  resting: Float64Array,
  table: ContactTable,
  tournament: Tournament,
  limit: number,
): number {
  const { count, a, b, normalX, normalY, restitution, impulse } = contacts;
  const { vx, vy, inverseMass } = particles;
  tournament.resize(count);
  const { keys } = tournament;
  for (let c = 0; c < count; c++) keys[c] = separatingVelocity(contacts, particles, c);
  tournament.start();

  let iterations = 0;
  for (; iterations < limit; iterations++) {
    const c = tournament.winner;
    const velocity = keys[c];
    if (!(velocity < -SPEED_EPSILON)) break;
    const i = a[c];
    const j = b[c];
    const wi = inverseMass[i];
    const wj = j === SCENERY ? 0 : inverseMass[j];
    const after = -velocity <= resting[c] ? 0 : -restitution[c] * velocity;
    const J = (after - velocity) / (wi + wj);
    impulse[c] += J;
    vx[i] += J * wi * normalX[c];
    vy[i] += J * wi * normalY[c];
    if (j !== SCENERY) {
      vx[j] -= J * wj * normalX[c];
      vy[j] -= J * wj * normalY[c];
      refresh(contacts, particles, table, tournament, j);
    }
    refresh(contacts, particles, table, tournament, i);
  }
  return iterations;
}

/**
 * The closing speed up to which a contact rests: what the acceleration of its two particles in this step, each towards the
 * other, can build. The acceleration is the total one, as the step found it. (Each on its own, not their difference: so
 * the upper of two that fell together rests on the lower that has just been stopped.)
 * Reads vx, vy, normal and the velocities before the forces acted. Writes resting.
 */
export function findRestingSpeeds(
  { count, a, b, normalX, normalY }: ContactBuffer,
  { vx, vy }: ParticleArrays,
  before: { readonly vx: Float64Array; readonly vy: Float64Array },
  resting: Float64Array,
): void {
  for (let c = 0; c < count; c++) {
    const i = a[c];
    const j = b[c];
    let speed = Math.max(0, -((vx[i] - before.vx[i]) * normalX[c] + (vy[i] - before.vy[i]) * normalY[c]));
    if (j !== SCENERY) speed += Math.max(0, (vx[j] - before.vx[j]) * normalX[c] + (vy[j] - before.vy[j]) * normalY[c]);
    resting[c] = speed * RESTING_SLACK;
  }
}

/** (v_a - v_b)·n, or Infinity where neither can move. Unit: m/s. */
export function separatingVelocity(contacts: ContactBuffer, particles: ParticleArrays, c: number): number {
  const { vx, vy, inverseMass } = particles;
  const i = contacts.a[c];
  const j = contacts.b[c];
  const nx = contacts.normalX[c];
  const ny = contacts.normalY[c];
  if (j === SCENERY) return inverseMass[i] === 0 ? Infinity : vx[i] * nx + vy[i] * ny;
  if (inverseMass[i] + inverseMass[j] === 0) return Infinity;
  return (vx[i] - vx[j]) * nx + (vy[i] - vy[j]) * ny;
}

function refresh(
  contacts: ContactBuffer,
  particles: ParticleArrays,
  table: ContactTable,
  tournament: Tournament,
  slot: number,
): void {
  const end = table.first[slot + 1];
  for (let t = table.first[slot]; t < end; t++) {
    const c = table.contacts[t];
    tournament.keys[c] = separatingVelocity(contacts, particles, c);
    tournament.update(c);
  }
}
