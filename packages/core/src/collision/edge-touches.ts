import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { type EdgeBounds, THIN_SHARE } from './edge-bounds.ts';
import { EdgeSides } from './edge-sides.ts';
import { type EdgeTable, NONE } from './edge-table.ts';
import { TouchList } from './edge-touch-list.ts';
import { EARLY_SHARE } from './shape-contacts.ts';
import { timeOfTouch } from './swept-discs.ts';

/** How far beyond the ends of an edge a point may touch it, as a share of the edge: two equal boxes have corner on corner. */
const ROUNDING = 1e-6;

/** A convex ring and a particle are out of each other's reach. */
const APART = -1;

/**
 * Where a particle touches the edges of a hull. An edge is as thick as the thinner of its ends; beyond an end it is round, and there a
 * particle touches the end's disc. What will touch within the time that the contacts look ahead is taken as it will then be, and
 * its gap is measured along the normal of that moment.
 */
export class EdgeTouches {
  readonly list: TouchList = new TouchList();
  readonly #table: EdgeTable;
  readonly #bounds: EdgeBounds;
  readonly #sides: EdgeSides;
  #particles!: ParticleArrays;
  /** Edges of a ring, each in front of which the particle is. */
  #facing = new Int32Array(16);
  #lookAhead = 0;
  #margin = 0;

  constructor(table: EdgeTable, bounds: EdgeBounds) {
    this.#table = table;
    this.#bounds = bounds;
    this.#sides = new EdgeSides(table, bounds);
  }

  /** Begins a step. */
  begin(particles: ParticleArrays, { lookAhead, margin }: ContactBuffer, dt: number): void {
    this.#particles = particles;
    this.#lookAhead = lookAhead;
    this.#sides.begin(particles, dt - lookAhead);
    this.#margin = margin;
    if (this.#facing.length < this.#table.edgeCount) this.#facing = new Int32Array(this.#table.edgeCount * 2);
  }

  /** Lists where a particle touches a hull. Reads x, y, vx, vy, radius. */
  find(p: number, h: number): void {
    const { first, ring } = this.#table.hulls;
    if (ring[h] === 0) {
      this.#touch(p, first[h], this.#sides.sideOf(p, first[h]), NONE);
      return;
    }
    const front = this.#faces(p, h);
    if (front === APART) return;
    const out = this.#sides.wayOut(p, h, front === 0 && this.#bounds.convex[h] === 1);
    if (out !== NONE) {
      this.#push(p, out, this.#bounds.turn[h]);
      return;
    }
    for (let f = 0; f < front; f++) {
      const next = this.#facing[f + 1 < front ? f + 1 : 0];
      this.#touch(p, this.#facing[f], this.#bounds.turn[h], this.#table.edges.start[next]);
    }
  }

  /**
   * Finds the edges of a ring in front of which a particle is. Most pairs end here: where one of them parts a convex ring from the
   * particle, out of reach. Writes `facing`. Returns how many there are, or `APART`.
   */
  #faces(p: number, h: number): number {
    const { x, y } = this.#particles;
    const { start } = this.#table.edges;
    const along = this.#bounds.along;
    const facing = this.#facing;
    const last = this.#table.hulls.first[h + 1];
    const side = this.#bounds.turn[h];
    const convex = this.#bounds.convex[h] === 1;
    const limit = this.#bounds.reach[p] + this.#bounds.widest[h];
    const px = x[p];
    const py = y[p];
    let count = 0;
    for (let k = this.#table.hulls.first[h]; k < last; k++) {
      const b = start[k];
      const area = side * ((px - x[b]) * along.y[k] - (py - y[b]) * along.x[k]);
      if (!(area >= 0)) continue;
      if (convex && area > limit * along.length[k]) return APART;
      facing[count++] = k;
    }
    return count;
  }

  /**
   * Lists where a particle touches an edge, between its ends and at these.
   * @param side - 1 where the particle belongs to the right of the edge, -1 to the left.
   * @param seen - An end that is looked at on another edge.
   */
  #touch(p: number, k: number, side: number, seen: number): void {
    const { x, y } = this.#particles;
    const { reach, along } = this.#bounds;
    const b = this.#table.edges.start[k];
    const e = this.#table.edges.end[k];
    const length = along.length[k];
    const beside = (x[p] - x[b]) * along.x[k] + (y[p] - y[b]) * along.y[k];
    if (p !== b && p !== e) this.#touchEdge(p, k, side);
    if (beside <= (reach[p] + reach[b]) * length) this.#touchEnd(p, b);
    if (e !== seen && length * length - beside <= (reach[p] + reach[e]) * length) this.#touchEnd(p, e);
  }

  /** Lists a touch between the ends of an edge. */
  #touchEdge(p: number, k: number, side: number): void {
    const { x, y, radius } = this.#particles;
    const { along } = this.#bounds;
    const b = this.#table.edges.start[k];
    const e = this.#table.edges.end[k];
    const ex = along.x[k];
    const ey = along.y[k];
    const length = along.length[k];
    const px = x[p] - x[b];
    const py = y[p] - y[b];
    const area = side * (px * ey - py * ex);
    if (length === 0) return;
    if (area < 0) {
      this.#push(p, k, side);
      return;
    }
    const gap = area / length;
    const sum = radius[p] + Math.min(radius[b], radius[e]);
    if (!(gap < this.#nearOf(sum, length))) {
      if (this.#lookAhead > 0) this.#touchLater(p, k, side);
      return;
    }
    const share = (px * ex + py * ey) / (ex * ex + ey * ey);
    const beyond = sum === 0 ? ROUNDING : 0; // points have no discs that touch beyond the ends
    if (!(share > -beyond && share < 1 + beyond)) return;
    const { list } = this;
    const t = list.add(b, e);
    if (t === NONE) return;
    list.share[t] = share;
    list.normalX[t] = (side * ey) / length;
    list.normalY[t] = (-side * ex) / length;
    list.penetration[t] = sum - gap;
  }

  /** From which gap on a touch is found that is not yet one. Unit: m. */
  #nearOf(sum: number, length: number): number {
    return (sum === 0 ? THIN_SHARE * length : sum * (1 + EARLY_SHARE)) + this.#margin;
  }

  /** Lists a touch between the ends of an edge within the time looked ahead, as if the gap closed evenly. */
  #touchLater(p: number, k: number, side: number): void {
    const { x, y, vx, vy, radius } = this.#particles;
    const { along } = this.#bounds;
    const b = this.#table.edges.start[k];
    const e = this.#table.edges.end[k];
    const ahead = this.#lookAhead;
    const ex = along.x[k];
    const ey = along.y[k];
    const px = x[p] - x[b];
    const py = y[p] - y[b];
    const fx = ex + (vx[e] - vx[b]) * ahead;
    const fy = ey + (vy[e] - vy[b]) * ahead;
    const qx = px + (vx[p] - vx[b]) * ahead;
    const qy = py + (vy[p] - vy[b]) * ahead;
    const gap = (side * (px * ey - py * ex)) / along.length[k];
    const then = (side * (qx * fy - qy * fx)) / Math.sqrt(fx * fx + fy * fy);
    const sum = radius[p] + Math.min(radius[b], radius[e]);
    if (!(then < this.#nearOf(sum, along.length[k]))) return;
    const time = Math.min(1, (gap - sum) / (gap - then));
    const tx = ex + (fx - ex) * time;
    const ty = ey + (fy - ey) * time;
    const reach = Math.sqrt(tx * tx + ty * ty);
    const share = ((px + (qx - px) * time) * tx + (py + (qy - py) * time) * ty) / (reach * reach);
    if (!(share >= 0 && share <= 1)) return;
    const { list } = this;
    const t = list.add(b, e);
    if (t === NONE) return;
    const nx = (side * ty) / reach;
    const ny = (-side * tx) / reach;
    list.share[t] = share;
    list.normalX[t] = nx;
    list.normalY[t] = ny;
    list.penetration[t] = sum - (px - share * ex) * nx - (py - share * ey) * ny;
  }

  /** Lists a touch of the disc of an end, where the particle is beyond that end for each of its edges, and it for the particle's. */
  #touchEnd(p: number, q: number): void {
    const { x, y, vx, vy, radius } = this.#particles;
    const dx = x[p] - x[q];
    const dy = y[p] - y[q];
    const reach = this.#bounds.reach[p] + this.#bounds.reach[q];
    const square = dx * dx + dy * dy;
    const sum = radius[p] + radius[q];
    if (square > reach * reach || sum === 0 || p === q) return;
    if (p > q && this.#table.slots.home[p] !== NONE) return; // found from the lower of the two
    const near = sum * (1 + EARLY_SHARE) + this.#margin;
    let nx = 0;
    let ny = 1; // concentric discs define no direction: any will do
    let time = 0;
    if (square < near * near) {
      const distance = Math.sqrt(square);
      if (distance > 0) {
        nx = dx / distance;
        ny = dy / distance;
      }
    } else {
      if (this.#lookAhead === 0) return;
      const ux = (vx[p] - vx[q]) * this.#lookAhead;
      const uy = (vy[p] - vy[q]) * this.#lookAhead;
      time = timeOfTouch(dx, dy, ux, uy, sum + this.#margin);
      if (!(time <= 1)) return;
      const tx = dx + ux * time;
      const ty = dy + uy * time;
      const distance = Math.sqrt(tx * tx + ty * ty);
      nx = tx / distance;
      ny = ty / distance;
    }
    if (!this.#isBeyond(p, q, time) || !this.#isBeyond(q, p, time)) return;
    const { list } = this;
    const t = list.add(q, NONE);
    if (t === NONE) return;
    list.share[t] = 0;
    list.normalX[t] = nx;
    list.normalY[t] = ny;
    list.penetration[t] = sum - dx * nx - dy * ny;
  }

  /** Whether a particle is beyond an end for each of its edges, but for those that are thinner than the end itself. */
  #isBeyond(p: number, q: number, time: number): boolean {
    const { x, y, vx, vy, radius } = this.#particles;
    const { neighbour } = this.#table;
    const { firstNeighbour } = this.#table.slots;
    const t = time * this.#lookAhead;
    for (let n = firstNeighbour[q]; n < firstNeighbour[q + 1]; n++) {
      const o = neighbour[n];
      if (radius[o] < radius[q]) continue;
      const dx = x[p] - x[q] + (vx[p] - vx[q]) * t;
      const dy = y[p] - y[q] + (vy[p] - vy[q]) * t;
      const ex = x[o] - x[q] + (vx[o] - vx[q]) * t;
      const ey = y[o] - y[q] + (vy[o] - vy[q]) * t;
      if (dx * ex + dy * ey > 0) return false;
    }
    return true;
  }

  /** Lists a touch with an edge that the particle is behind. */
  #push(p: number, k: number, side: number): void {
    const { x, y, radius } = this.#particles;
    const b = this.#table.edges.start[k];
    const e = this.#table.edges.end[k];
    const ex = x[e] - x[b];
    const ey = y[e] - y[b];
    const px = x[p] - x[b];
    const py = y[p] - y[b];
    const square = ex * ex + ey * ey;
    if (square === 0) return;
    const length = Math.sqrt(square);
    const share = Math.max(0, Math.min(1, (px * ex + py * ey) / square));
    const nx = (side * ey) / length;
    const ny = (-side * ex) / length;
    const { list } = this;
    const t = list.add(b, e);
    if (t === NONE) return;
    list.share[t] = share;
    list.normalX[t] = nx;
    list.normalY[t] = ny;
    list.penetration[t] = radius[p] + Math.min(radius[b], radius[e]) - px * nx - py * ny;
  }
}
