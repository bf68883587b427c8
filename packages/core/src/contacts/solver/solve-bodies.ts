import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { type ContactBuffer, shareOf } from '../contact-buffer.ts';
import type { ContactRows } from './contact-rows.ts';
import type { RigidMotion } from './rigid-motion.ts';
import type { Softness } from './softness.ts';
import { FASTEST_PUSH, OVER_RELAXATION } from './solve-contacts.ts';

/** The columns of the rows of bodies: see `BodyRows`. */
export interface BodyColumns {
  readonly count: number;
  readonly row: Int32Array;
  readonly bodyA: Int32Array;
  readonly bodyB: Int32Array;
  readonly tangentMass: Float64Array;
}

/**
 * `solveContacts` where one of a row or both belong to a rigid body: the impulse moves the body as a whole, so that no rod has to pass it on.
 * Reads the rows, x, y, inverseMass. Writes the motion of the bodies, vx, vy of what belongs to none, the impulses of the rows; adds to those of
 * the contacts.
 */
// biome-ignore lint/complexity/noExcessiveLinesPerFunction: numbers that go from function to function cost a box each
export function solveBodies(
  { count, row, bodyA, bodyB, tangentMass }: BodyColumns,
  contacts: ContactBuffer,
  { second, offset, mass, lasting, closing, normal, tangent, fallX, fallY }: ContactRows,
  bodies: RigidMotion,
  { x, y, vx, vy, inverseMass }: ParticleArrays,
  { biasRate, massScale, impulseScale }: Softness,
  h: number,
  calm: number,
): void {
  const { a, edgeEnd, normalX, normalY, friction, surfaceSpeed, impulse, tangentImpulse } = contacts;
  const { x: bodyX, y: bodyY, vx: bodyVx, vy: bodyVy, spin, inverseMass: perMass, inverseInertia } = bodies;
  const perStep = 1 / h;
  const kept = 1 - impulseScale;
  for (let r = 0; r < count; r++) {
    const c = row[r];
    const A = bodyA[r];
    const B = bodyB[r];
    const i = a[c];
    const j = second[c];
    const t = shareOf(contacts, c);
    const k = t === 0 ? j : edgeEnd[c];
    const nx = normalX[c];
    const ny = normalY[c];
    const bx = x[j] + t * (x[k] - x[j]);
    const by = y[j] + t * (y[k] - y[j]);
    const gap = offset[c] + (x[i] - bx) * nx + (y[i] - by) * ny;
    const ax = A < 0 ? 0 : x[i] - bodyX[A];
    const ay = A < 0 ? 0 : y[i] - bodyY[A];
    const ex = B < 0 ? 0 : bx - bodyX[B];
    const ey = B < 0 ? 0 : by - bodyY[B];
    const ux =
      (A < 0 ? vx[i] : bodyVx[A] - spin[A] * ay) - (B < 0 ? vx[j] + t * (vx[k] - vx[j]) : bodyVx[B] - spin[B] * ey);
    const uy =
      (A < 0 ? vy[i] : bodyVy[A] + spin[A] * ax) - (B < 0 ? vy[j] + t * (vy[k] - vy[j]) : bodyVy[B] + spin[B] * ex);
    const before = normal[c];
    const speed = ux * nx + uy * ny;
    const response = before > 0 && speed < calm && speed > -calm ? OVER_RELAXATION * mass[c] : mass[c];
    const soft = gap <= 0 && lasting[c] === 1;
    const rate = gap > 0 ? gap * perStep : Math.max(gap * biasRate, -FASTEST_PUSH);
    const wanted = (soft ? before * kept : before) - response * (soft ? massScale : 1) * (speed + rate);
    const after = Math.max(wanted, 0);
    if (before === 0 && after > 0) {
      const falls = (A < 0 && inverseMass[i] === 0 ? 0 : 1) - (B < 0 && inverseMass[j] === 0 ? 0 : 1);
      closing[c] = Math.min(closing[c], speed - falls * (fallX * nx + fallY * ny));
    }
    normal[c] = after;
    impulse[c] += after;
    let px = (after - before) * nx;
    let py = (after - before) * ny;
    const mu = friction[c];
    if (mu !== 0) {
      const held = tangent[c];
      const most = mu * after;
      const sliding = ux * ny - uy * nx - surfaceSpeed[c];
      const grip = Math.max(-most, Math.min(most, held - tangentMass[r] * sliding));
      tangent[c] = grip;
      tangentImpulse[c] += grip;
      px += (grip - held) * ny;
      py -= (grip - held) * nx;
    }
    if (A < 0) {
      vx[i] += px * inverseMass[i];
      vy[i] += py * inverseMass[i];
    } else {
      bodyVx[A] += px * perMass[A];
      bodyVy[A] += py * perMass[A];
      spin[A] += (ax * py - ay * px) * inverseInertia[A];
    }
    if (B < 0) {
      const wj = inverseMass[j] * (1 - t);
      const wk = inverseMass[k] * t;
      vx[j] -= px * wj;
      vy[j] -= py * wj;
      vx[k] -= px * wk;
      vy[k] -= py * wk;
    } else {
      bodyVx[B] -= px * perMass[B];
      bodyVy[B] -= py * perMass[B];
      spin[B] -= (ex * py - ey * px) * inverseInertia[B];
    }
  }
}

/**
 * Begins a small step with what the contacts of bodies did in the last one, at the places where they are now. Reads the rows, x, y, inverseMass.
 * Writes the motion of the bodies, and vx, vy of what belongs to none.
 */
export function repeatOnBodies(
  { count, row, bodyA, bodyB }: BodyColumns,
  contacts: ContactBuffer,
  { second, normal, tangent }: ContactRows,
  { x: bodyX, y: bodyY, vx: bodyVx, vy: bodyVy, spin, inverseMass: perMass, inverseInertia }: RigidMotion,
  { x, y, vx, vy, inverseMass }: ParticleArrays,
): void {
  const { a, edgeEnd, normalX, normalY } = contacts;
  for (let r = 0; r < count; r++) {
    const c = row[r];
    if (normal[c] === 0) continue;
    const A = bodyA[r];
    const B = bodyB[r];
    const i = a[c];
    const j = second[c];
    const t = shareOf(contacts, c);
    const k = t === 0 ? j : edgeEnd[c];
    const px = normal[c] * normalX[c] + tangent[c] * normalY[c];
    const py = normal[c] * normalY[c] - tangent[c] * normalX[c];
    if (A < 0) {
      vx[i] += px * inverseMass[i];
      vy[i] += py * inverseMass[i];
    } else {
      bodyVx[A] += px * perMass[A];
      bodyVy[A] += py * perMass[A];
      spin[A] += ((x[i] - bodyX[A]) * py - (y[i] - bodyY[A]) * px) * inverseInertia[A];
    }
    if (B < 0) {
      const wj = inverseMass[j] * (1 - t);
      const wk = inverseMass[k] * t;
      vx[j] -= px * wj;
      vy[j] -= py * wj;
      vx[k] -= px * wk;
      vy[k] -= py * wk;
    } else {
      const ex = x[j] + t * (x[k] - x[j]) - bodyX[B];
      const ey = y[j] + t * (y[k] - y[j]) - bodyY[B];
      bodyVx[B] -= px * perMass[B];
      bodyVy[B] -= py * perMass[B];
      spin[B] -= (ex * py - ey * px) * inverseInertia[B];
    }
  }
}
