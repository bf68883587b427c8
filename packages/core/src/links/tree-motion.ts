import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { INVERSE_MASS, LENGTH, ROW, TENSION, TOTAL, type TreeTable } from './solve-tree.ts';

const NUMBERS = 4;

/** Remembers the velocities and tensions of a tree, so that an attempt to solve it can be undone. */
export class TreeMotion {
  #saved = new Float64Array(0);

  save({ slot, rows }: TreeTable, from: number, to: number, { vx, vy }: ParticleArrays): void {
    if (this.#saved.length < (to - from) * NUMBERS) this.#saved = new Float64Array((to - from) * NUMBERS * 2);
    const saved = this.#saved;
    for (let k = from, at = 0; k < to; k++, at += NUMBERS) {
      const s = slot[k];
      if (s >= 0) {
        saved[at] = vx[s];
        saved[at + 1] = vy[s];
      }
      saved[at + 2] = rows[k * ROW + TENSION];
      saved[at + 3] = rows[k * ROW + TOTAL];
    }
  }

  restore({ slot, rows }: TreeTable, from: number, to: number, { vx, vy }: ParticleArrays): void {
    const saved = this.#saved;
    for (let k = from, at = 0; k < to; k++, at += NUMBERS) {
      const s = slot[k];
      if (rows[k * ROW + INVERSE_MASS] > 0) {
        vx[s] = saved[at];
        vy[s] = saved[at + 1];
      }
      rows[k * ROW + TENSION] = saved[at + 2];
      rows[k * ROW + TOTAL] = saved[at + 3];
    }
  }
}

/** The energy of motion of a tree. Unit: J. */
export function kineticEnergy({ slot, rows }: TreeTable, from: number, to: number, { vx, vy }: ParticleArrays): number {
  let sum = 0;
  for (let k = from; k < to; k++) {
    const s = slot[k];
    const w = rows[k * ROW + INVERSE_MASS];
    if (w > 0) sum += (vx[s] * vx[s] + vy[s] * vy[s]) / w;
  }
  return sum / 2;
}

/** Slows a tree down to an energy of motion that its links cannot have meant to exceed. */
export function slowTo(most: number, t: TreeTable, from: number, to: number, particles: ParticleArrays): void {
  const energy = kineticEnergy(t, from, to, particles);
  if (!(energy > most)) return;
  const share = Math.sqrt(most / energy);
  for (let k = from; k < to; k++) {
    if (t.rows[k * ROW + INVERSE_MASS] === 0) continue;
    particles.vx[t.slot[k]] *= share;
    particles.vy[t.slot[k]] *= share;
  }
}

/** The energy of motion at which links that are far off are brought back. Unit: J. */
export function energyOfCorrection({ rows }: TreeTable, from: number, to: number, speed: number): number {
  let sum = 0;
  for (let k = from + 1; k < to; k++) {
    const w = rows[k * ROW + INVERSE_MASS];
    if (w > 0) sum += (rows[k * ROW + LENGTH] * speed * rows[k * ROW + LENGTH] * speed) / w;
  }
  return sum / 2;
}
