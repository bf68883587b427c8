import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { type ContactBuffer, shareOf } from '../contact-buffer.ts';
import type { ContactRows } from './contact-rows.ts';
import type { RigidMotion } from './rigid-motion.ts';

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

/**
 * Adds to velocities what an impulse does to the first of a contact, and the opposite to the second. Reads x, y, inverseMass.
 * @param bodies - The rigid bodies, some of which the two may belong to.
 */
export function push(
  contacts: ContactBuffer,
  { second, ofBody }: ContactRows,
  bodies: RigidMotion | undefined,
  r: number,
  px: number,
  py: number,
  particles: ParticleArrays,
  vx: Float64Array,
  vy: Float64Array,
): void {
  const { x, y, inverseMass } = particles;
  const i = contacts.a[r];
  const j = second[r];
  const t = shareOf(contacts, r);
  const k = t === 0 ? j : contacts.edgeEnd[r];
  const hasBody = bodies !== undefined && ofBody[r] === 1;
  const A = hasBody ? bodies.bodyOf(i) : -1;
  const B = hasBody ? bodies.bodyOf(j) : -1;
  if (hasBody && A >= 0) bodies.push(A, px, py, x[i], y[i], particles, vx, vy);
  else {
    vx[i] += px * inverseMass[i];
    vy[i] += py * inverseMass[i];
  }
  if (hasBody && B >= 0)
    bodies.push(B, -px, -py, x[j] + t * (x[k] - x[j]), y[j] + t * (y[k] - y[j]), particles, vx, vy);
  else {
    const wj = inverseMass[j] * (1 - t);
    const wk = inverseMass[k] * t;
    vx[j] -= px * wj;
    vy[j] -= py * wj;
    vx[k] -= px * wk;
    vy[k] -= py * wk;
  }
}
