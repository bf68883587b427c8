import { growColumns } from '../math/columns.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';

const FIRST_CAPACITY = 4;

/** What is drawn for it: coils, or a cord. */
export type SpringKind = 'spring' | 'bungee';

/** The springs of one batch as typed arrays, one row each. A fixed point stands in the row, its slot is -1. */
export class SpringTable {
  readonly kind: SpringKind;
  count = 0;
  /** Whether rows are to be looked at before the next step: one was added, or taken out by hand. */
  dirty = false;
  slotA: Int32Array = new Int32Array(FIRST_CAPACITY);
  slotB: Int32Array = new Int32Array(FIRST_CAPACITY);
  generationA: Uint32Array = new Uint32Array(FIRST_CAPACITY);
  generationB: Uint32Array = new Uint32Array(FIRST_CAPACITY);
  fixedX: Float64Array = new Float64Array(FIRST_CAPACITY);
  fixedY: Float64Array = new Float64Array(FIRST_CAPACITY);
  restLength: Float64Array = new Float64Array(FIRST_CAPACITY);
  stiffness: Float64Array = new Float64Array(FIRST_CAPACITY);
  damping: Float64Array = new Float64Array(FIRST_CAPACITY);

  constructor(kind: SpringKind) {
    this.kind = kind;
  }

  /** A new row, of which everything is still to be written. */
  add(): number {
    if (this.count === this.slotA.length) growColumns(this, this.count * 2);
    this.dirty = true;
    return this.count++;
  }

  /** Copies what a spring is made of, but not its slots, to an earlier row. */
  move(from: number, to: number): void {
    this.fixedX[to] = this.fixedX[from];
    this.fixedY[to] = this.fixedY[from];
    this.restLength[to] = this.restLength[from];
    this.stiffness[to] = this.stiffness[from];
    this.damping[to] = this.damping[from];
  }
}

/** Whether some particle of a spring was removed since its slot was noted. Reads generations. */
export function lostParticle(table: SpringTable, { generation }: ParticleArrays): boolean {
  const { count, slotA, slotB, generationA, generationB } = table;
  for (let s = 0; s < count; s++) {
    const a = slotA[s];
    const b = slotB[s];
    if (a >= 0 && generation[a] !== generationA[s]) return true;
    if (b >= 0 && generation[b] !== generationB[s]) return true;
  }
  return false;
}

/**
 * The law of both kinds, along the line of the ends: T = k·extension + c·rate, positive where it pulls the ends together.
 * A bungee is slack at its rest length and below, and never pushes, not even by its damping.
 */
export function tension(kind: SpringKind, k: number, c: number, extension: number, rate: number): number {
  const pull = k * extension + c * rate;
  return kind === 'spring' || (extension > 0 && pull > 0) ? pull : 0;
}

/**
 * Each end is pulled towards the other by the tension. Coincident ends define no direction: no force.
 * Reads x, y, vx, vy and the table. Adds to fx, fy.
 */
export function applySprings(table: SpringTable, { x, y, vx, vy, fx, fy }: ParticleArrays): void {
  const { kind, count, slotA, slotB, fixedX, fixedY, restLength, stiffness, damping } = table;
  for (let s = 0; s < count; s++) {
    const a = slotA[s];
    const b = slotB[s];
    const dx = (b < 0 ? fixedX[s] : x[b]) - (a < 0 ? fixedX[s] : x[a]);
    const dy = (b < 0 ? fixedY[s] : y[b]) - (a < 0 ? fixedY[s] : y[a]);
    const length = Math.sqrt(dx * dx + dy * dy);
    if (length === 0) continue;
    const nx = dx / length;
    const ny = dy / length;
    const ux = (b < 0 ? 0 : vx[b]) - (a < 0 ? 0 : vx[a]);
    const uy = (b < 0 ? 0 : vy[b]) - (a < 0 ? 0 : vy[a]);
    const pull = tension(kind, stiffness[s], damping[s], length - restLength[s], nx * ux + ny * uy);
    if (a >= 0) {
      fx[a] += pull * nx;
      fy[a] += pull * ny;
    }
    if (b >= 0) {
      fx[b] -= pull * nx;
      fy[b] -= pull * ny;
    }
  }
}
