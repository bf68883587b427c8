import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import { growColumns } from '../math/columns.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { EdgeTable } from './edge-table.ts';
import { EARLY_SHARE } from './shape-contacts.ts';

/** Between points, without a radius, a touch is found when the gap is below this share of the edge: a little early, too. */
export const THIN_SHARE = 1e-3;

/** Where the edges are, and where the particles and the hulls may be during the step. */
export class EdgeBounds {
  /** How far each particle reaches: its radius, a little more, and its way. Unit: m. */
  reach: Float64Array = new Float64Array(0);
  /** The way along each edge, and how long it is. Unit: m. */
  readonly along: Record<'x' | 'y' | 'length', Float64Array> = {
    x: new Float64Array(0),
    y: new Float64Array(0),
    length: new Float64Array(0),
  };
  /** The box around each hull and the reach of its corners. Unit: m. */
  minX: Float64Array = new Float64Array(0);
  minY: Float64Array = new Float64Array(0);
  maxX: Float64Array = new Float64Array(0);
  maxY: Float64Array = new Float64Array(0);
  /** Which way a ring goes round: 1 counter-clockwise, -1 clockwise. */
  turn: Int8Array = new Int8Array(0);
  /** How far the farthest-reaching corner reaches. Unit: m. */
  widest: Float64Array = new Float64Array(0);
  /** 1 where a ring is convex. */
  convex: Uint8Array = new Uint8Array(0);
  /** 1 where no corner of the hull can move. */
  still: Uint8Array = new Uint8Array(0);

  /**
   * Reads x, y, vx, vy, radius, inverseMass, asleep. Writes the bounds.
   * @param dt - Duration of the step. Unit: s.
   */
  update(particles: ParticleArrays, table: EdgeTable, { margin }: ContactBuffer, dt: number): void {
    const { count, vx, vy, radius } = particles;
    if (this.reach.length < count) this.reach = new Float64Array(count * 2);
    if (this.minX.length < table.hullCount) this.#reserve(table.hullCount * 2);
    if (this.along.x.length < table.edgeCount) growColumns(this.along, table.edgeCount * 2);
    const { reach } = this;
    for (let i = 0; i < count; i++) {
      reach[i] = radius[i] * (1 + EARLY_SHARE) + margin + (Math.abs(vx[i]) + Math.abs(vy[i])) * dt;
    }
    this.#layOut(particles, table);
    for (let h = 0; h < table.hullCount; h++) this.#around(particles, table, h);
  }

  #layOut({ x, y }: ParticleArrays, { edgeCount, edges }: EdgeTable): void {
    const { start, end } = edges;
    const along = this.along;
    for (let k = 0; k < edgeCount; k++) {
      const ex = x[end[k]] - x[start[k]];
      const ey = y[end[k]] - y[start[k]];
      along.x[k] = ex;
      along.y[k] = ey;
      along.length[k] = Math.sqrt(ex * ex + ey * ey);
    }
  }

  #around({ x, y, inverseMass, asleep }: ParticleArrays, { hulls, edges }: EdgeTable, h: number): void {
    const { reach } = this;
    const { start, end } = edges;
    const last = hulls.first[h + 1];
    const ring = hulls.ring[h] === 1;
    let minX = Infinity;
    let minY = Infinity;
    let maxX = -Infinity;
    let maxY = -Infinity;
    let widest = 0;
    let area = 0;
    let still = 1;
    for (let k = hulls.first[h]; k < last; k++) {
      const a = start[k];
      const b = end[k];
      for (let s = a; ; s = b) {
        const r = reach[s];
        if (r > widest) widest = r;
        if (x[s] - r < minX) minX = x[s] - r;
        if (x[s] + r > maxX) maxX = x[s] + r;
        if (y[s] - r < minY) minY = y[s] - r;
        if (y[s] + r > maxY) maxY = y[s] + r;
        if (inverseMass[s] !== 0 && asleep[s] === 0) still = 0;
        if (ring || s === b) break;
      }
      area += x[a] * y[b] - x[b] * y[a];
    }
    const early = THIN_SHARE * (maxX - minX + maxY - minY);
    this.minX[h] = minX - early;
    this.minY[h] = minY - early;
    this.maxX[h] = maxX + early;
    this.maxY[h] = maxY + early;
    this.widest[h] = widest;
    this.turn[h] = area < 0 ? -1 : 1;
    this.convex[h] = ring && isConvex(this.along, hulls.first[h], last, this.turn[h]) ? 1 : 0;
    this.still[h] = still;
  }

  #reserve(count: number): void {
    this.minX = new Float64Array(count);
    this.minY = new Float64Array(count);
    this.maxX = new Float64Array(count);
    this.maxY = new Float64Array(count);
    this.turn = new Int8Array(count);
    this.widest = new Float64Array(count);
    this.convex = new Uint8Array(count);
    this.still = new Uint8Array(count);
  }
}

/** Whether a ring turns the same way at each of its corners. */
function isConvex({ x, y }: EdgeBounds['along'], first: number, last: number, turn: number): boolean {
  let before = last - 1;
  for (let k = first; k < last; k++) {
    if (turn * (x[before] * y[k] - y[before] * x[k]) < 0) return false;
    before = k;
  }
  return true;
}
