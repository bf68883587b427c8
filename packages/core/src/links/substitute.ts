import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForestTable } from './forest-table.ts';

/** Brings places and velocities of the particles into the rows. */
export function gather(t: ForestTable, from: number, to: number, particles: ParticleArrays): void {
  const { slot, x, y, vx, vy } = t;
  const { x: px, y: py, vx: pvx, vy: pvy } = particles;
  for (let k = from; k < to; k++) {
    const s = slot[k];
    if (s < 0) continue;
    x[k] = px[s];
    y[k] = py[s];
    vx[k] = pvx[s];
    vy[k] = pvy[s];
  }
}

/** From the roots to the leaves: finds tensions and changes of velocity, and gives the particles their new ones. */
export function substitute(t: ForestTable, from: number, to: number, particles: ParticleArrays): void {
  const { slot, parent, moves, vx, vy, ux, uy, txx, txy, tyx, tyy, own, perX, perY, start, tension } = t;
  const { vx: pvx, vy: pvy } = particles;
  for (let k = from; k < to; k++) {
    const p = parent[k];
    if (p >= 0) {
      const px = ux[p];
      const py = uy[p];
      tension[k] = start[k] + own[k] + perX[k] * px + perY[k] * py;
      ux[k] += txx[k] * px + txy[k] * py;
      uy[k] += tyx[k] * px + tyy[k] * py;
    }
    if (moves[k] === 0) continue;
    pvx[slot[k]] = vx[k] + ux[k];
    pvy[slot[k]] = vy[k] + uy[k];
  }
}
