import { type ContactBuffer, NO_EDGE } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';

/** Where on an edge a contact lies, 0 at the second particle; 0 also where there is no edge. */
export function shareOf({ edgeEnd, edgeShare }: ContactBuffer, r: number): number {
  return edgeEnd[r] === NO_EDGE ? 0 : edgeShare[r];
}

/**
 * The speed at which the two of a contact part. Unit: m/s.
 * @param second - Slots of the second particles.
 */
export function partingSpeed(
  contacts: ContactBuffer,
  second: Int32Array,
  { vx, vy }: ParticleArrays,
  r: number,
): number {
  const i = contacts.a[r];
  const j = second[r];
  const t = shareOf(contacts, r);
  const k = t === 0 ? j : contacts.edgeEnd[r];
  const ux = vx[i] - vx[j] - t * (vx[k] - vx[j]);
  const uy = vy[i] - vy[j] - t * (vy[k] - vy[j]);
  return ux * contacts.normalX[r] + uy * contacts.normalY[r];
}

/** Adds to velocities what an impulse does to the first of a contact, and the opposite to the second. Reads inverseMass. */
export function push(
  contacts: ContactBuffer,
  second: Int32Array,
  r: number,
  px: number,
  py: number,
  inverseMass: Float64Array,
  vx: Float64Array,
  vy: Float64Array,
): void {
  const i = contacts.a[r];
  const j = second[r];
  const t = shareOf(contacts, r);
  const wj = inverseMass[j] * (1 - t);
  vx[i] += px * inverseMass[i];
  vy[i] += py * inverseMass[i];
  vx[j] -= px * wj;
  vy[j] -= py * wj;
  if (t === 0) return;
  const k = contacts.edgeEnd[r];
  vx[k] -= px * inverseMass[k] * t;
  vy[k] -= py * inverseMass[k] * t;
}
