import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { EdgeRows } from './edge-rows.ts';
import type { Softness } from './softness.ts';
import { FASTEST_PUSH, OVER_RELAXATION } from './solve-contacts.ts';

/**
 * One pass over contacts with edges: `solveContacts` for a particle and a place between two others.
 * Reads the rows, x, y, inverseMass. Writes vx, vy, and the impulses of the rows.
 * @param calm - Speed along the normal below which a contact is calm. Unit: m/s.
 */
export function solveEdges(
  {
    count,
    a,
    b,
    e,
    share,
    normalX,
    normalY,
    offset,
    mass,
    friction,
    lasting,
    closing,
    normal,
    tangent,
    contact,
  }: EdgeRows,
  { impulse, tangentImpulse }: ContactBuffer,
  { x, y, vx, vy, inverseMass }: ParticleArrays,
  { biasRate, massScale, impulseScale }: Softness,
  h: number,
  calm: number,
): void {
  const perStep = 1 / h;
  const kept = 1 - impulseScale;
  for (let r = 0; r < count; r++) {
    const i = a[r];
    const j = b[r];
    const k = e[r];
    const t = share[r];
    const nx = normalX[r];
    const ny = normalY[r];
    const ux = vx[i] - vx[j] - t * (vx[k] - vx[j]);
    const uy = vy[i] - vy[j] - t * (vy[k] - vy[j]);
    const dx = x[i] - x[j] - t * (x[k] - x[j]);
    const dy = y[i] - y[j] - t * (y[k] - y[j]);
    const gap = offset[r] + dx * nx + dy * ny;
    const before = normal[r];
    const speed = ux * nx + uy * ny;
    const response = before > 0 && speed < calm && speed > -calm ? OVER_RELAXATION * mass[r] : mass[r];
    const soft = gap <= 0 && lasting[r] === 1;
    const rate = gap > 0 ? gap * perStep : Math.max(gap * biasRate, -FASTEST_PUSH);
    const wanted = (soft ? before * kept : before) - response * (soft ? massScale : 1) * (speed + rate);
    const after = Math.max(wanted, 0);
    if (before === 0 && after > 0 && speed < closing[r]) closing[r] = speed;
    normal[r] = after;
    impulse[contact[r]] += after;
    let px = (after - before) * nx;
    let py = (after - before) * ny;
    const mu = friction[r];
    if (mu !== 0) {
      const held = tangent[r];
      const most = mu * after;
      const grip = Math.max(-most, Math.min(most, held - mass[r] * (ux * ny - uy * nx)));
      tangent[r] = grip;
      tangentImpulse[contact[r]] += grip;
      px += (grip - held) * ny;
      py -= (grip - held) * nx;
    }
    const wi = inverseMass[i];
    const wj = inverseMass[j] * (1 - t);
    const wk = inverseMass[k] * t;
    vx[i] += px * wi;
    vy[i] += py * wi;
    vx[j] -= px * wj;
    vy[j] -= py * wj;
    vx[k] -= px * wk;
    vy[k] -= py * wk;
  }
}

/** `giveBack` for contacts with edges. Reads the rows, inverseMass. Writes vx, vy, and the sums of the impulses. */
export function giveBackEdges(
  { count, a, b, e, share, normalX, normalY, mass, restitution, closing, contact }: EdgeRows,
  { impulse }: ContactBuffer,
  { vx, vy, inverseMass }: ParticleArrays,
  resting: number,
): void {
  for (let r = 0; r < count; r++) {
    if (restitution[r] === 0 || closing[r] >= -resting || impulse[contact[r]] === 0) continue;
    const i = a[r];
    const j = b[r];
    const k = e[r];
    const t = share[r];
    const ux = vx[i] - vx[j] - t * (vx[k] - vx[j]);
    const uy = vy[i] - vy[j] - t * (vy[k] - vy[j]);
    const speed = ux * normalX[r] + uy * normalY[r];
    const J = Math.min(restitution[r] * impulse[contact[r]], -mass[r] * (speed + restitution[r] * closing[r]));
    if (J <= 0) continue;
    const px = J * normalX[r];
    const py = J * normalY[r];
    const wj = inverseMass[j] * (1 - t);
    const wk = inverseMass[k] * t;
    impulse[contact[r]] += J;
    vx[i] += px * inverseMass[i];
    vy[i] += py * inverseMass[i];
    vx[j] -= px * wj;
    vy[j] -= py * wj;
    vx[k] -= px * wk;
    vy[k] -= py * wk;
  }
}
