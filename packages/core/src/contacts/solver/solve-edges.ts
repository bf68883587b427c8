import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { type ContactBuffer, NO_EDGE } from '../contact-buffer.ts';
import type { ContactRows } from './contact-rows.ts';
import type { Softness } from './softness.ts';
import { FASTEST_PUSH, OVER_RELAXATION } from './solve-contacts.ts';

/**
 * `solveContacts` where the second of a row may be a place on an edge, whose position and velocity are (1 - t) times those of one end and t
 * times those of the other. What it holds is shared between the ends in the same way, so that momentum and angular momentum are kept.
 * It stands alone so that contacts without edges need not pay for it.
 */
export function solveEdges(
  { a, edgeEnd, edgeShare, normalX, normalY, friction, surfaceSpeed, impulse, tangentImpulse }: ContactBuffer,
  { second, offset, mass, lasting, closing, normal, tangent, fallX, fallY }: ContactRows,
  start: number,
  end: number,
  { x, y, vx, vy, inverseMass }: ParticleArrays,
  discSoft: Softness,
  edgeSoft: Softness,
  h: number,
  calm: number,
): void {
  const perStep = 1 / h;
  for (let r = start; r < end; r++) {
    const i = a[r];
    const j = second[r];
    const isEdge = edgeEnd[r] !== NO_EDGE;
    const k = isEdge ? edgeEnd[r] : j;
    const t = isEdge ? edgeShare[r] : 0;
    const { biasRate, massScale, impulseScale } = isEdge ? edgeSoft : discSoft;
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
    const wanted = (soft ? before * (1 - impulseScale) : before) - response * (soft ? massScale : 1) * (speed + rate);
    const after = Math.max(wanted, 0);
    const wi = inverseMass[i];
    const wj = inverseMass[j] * (1 - t);
    const wk = inverseMass[k] * t;
    if (before === 0 && after > 0) {
      const falls = (wi === 0 ? 0 : 1) - (wj === 0 ? 0 : 1 - t) - (wk === 0 ? 0 : t);
      closing[r] = Math.min(closing[r], speed - falls * (fallX * nx + fallY * ny));
    }
    normal[r] = after;
    impulse[r] += after;
    let px = (after - before) * nx;
    let py = (after - before) * ny;
    const mu = friction[r];
    if (mu !== 0) {
      const held = tangent[r];
      const most = mu * after;
      const sliding = ux * ny - uy * nx - surfaceSpeed[r];
      const grip = Math.max(-most, Math.min(most, held - mass[r] * sliding));
      tangent[r] = grip;
      tangentImpulse[r] += grip;
      px += (grip - held) * ny;
      py -= (grip - held) * nx;
    }
    vx[i] += px * wi;
    vy[i] += py * wi;
    vx[j] -= px * wj;
    vy[j] -= py * wj;
    vx[k] -= px * wk;
    vy[k] -= py * wk;
  }
}
