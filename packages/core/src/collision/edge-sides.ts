import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { EdgeBounds } from './edge-bounds.ts';
import { type EdgeTable, NONE } from './edge-table.ts';

/**
 * On which side of an edge a particle belongs.
 *
 * A ring has an outside. What is inside leaves by the edge by which it came in during this step, else by that which parts the two
 * bodies soonest, as a separating axis does: by the edge that is nearest to a corner, two equal boxes one on the other would be
 * pushed sideways. An open edge has two sides: a particle stays on that where it was as the step began, but for the corner of
 * a body that sticks through.
 */
export class EdgeSides {
  readonly #table: EdgeTable;
  readonly #bounds: EdgeBounds;
  #particles!: ParticleArrays;
  #back = 0;

  constructor(table: EdgeTable, bounds: EdgeBounds) {
    this.#table = table;
    this.#bounds = bounds;
  }

  /**
   * Begins a step.
   * @param back - How long ago the step began. Unit: s.
   */
  begin(particles: ParticleArrays, back: number): void {
    this.#particles = particles;
    this.#back = back;
  }

  /**
   * The edge by which a particle leaves a ring that it is in, or went through in this step; `NONE` where it is outside.
   * @param inside - Whether it is known to be inside; in a ring that is not convex that is found here.
   */
  wayOut(p: number, h: number, inside: boolean): number {
    const through = this.#back > 0 ? this.#entered(p, h) : NONE;
    if (through !== NONE) return through;
    return inside || (this.#bounds.convex[h] === 0 && this.#isInside(p, h)) ? this.#shortestWayOut(p, h) : NONE;
  }

  /** Whether a particle's centre is inside a ring: whether a ray from it crosses an odd number of edges. */
  #isInside(p: number, h: number): boolean {
    const { x, y } = this.#particles;
    const { first } = this.#table.hulls;
    const { start, end } = this.#table.edges;
    const px = x[p];
    const py = y[p];
    let inside = false;
    for (let k = first[h]; k < first[h + 1]; k++) {
      const b = start[k];
      const e = end[k];
      if (y[b] > py === y[e] > py) continue;
      if (px < x[b] + ((py - y[b]) / (y[e] - y[b])) * (x[e] - x[b])) inside = !inside;
    }
    return inside;
  }

  /** The edge of a ring by which a particle came in during this step, the first if there are more. */
  #entered(p: number, h: number): number {
    const { first } = this.#table.hulls;
    const side = this.#bounds.turn[h];
    let through = NONE;
    let earliest = Infinity;
    for (let k = first[h]; k < first[h + 1]; k++) {
      const time = this.#crossing(p, k, side);
      if (time < earliest) {
        earliest = time;
        through = k;
      }
    }
    return through;
  }

  /**
   * When during this step the particle went through an edge, as a share of the way; Infinity if it did not.
   * @param side - From which side: 1 from its right, -1 from its left.
   */
  #crossing(p: number, k: number, side: number): number {
    const { x, y, vx, vy } = this.#particles;
    const b = this.#table.edges.start[k];
    const e = this.#table.edges.end[k];
    const ex = x[e] - x[b];
    const ey = y[e] - y[b];
    const px = x[p] - x[b];
    const py = y[p] - y[b];
    const now = side * (px * ey - py * ex);
    if (!(now < 0)) return Infinity;
    const fx = ex - (vx[e] - vx[b]) * this.#back;
    const fy = ey - (vy[e] - vy[b]) * this.#back;
    const qx = px - (vx[p] - vx[b]) * this.#back;
    const qy = py - (vy[p] - vy[b]) * this.#back;
    const before = side * (qx * fy - qy * fx);
    if (before < 0) return Infinity;
    const time = before / (before - now);
    const tx = fx + (ex - fx) * time;
    const ty = fy + (ey - fy) * time;
    const along = (qx + (px - qx) * time) * tx + (qy + (py - qy) * time) * ty;
    return along >= 0 && along <= tx * tx + ty * ty ? time : Infinity;
  }

  /** The edge by which a particle inside a ring, with all of its own ring, has the shortest way out. */
  #shortestWayOut(p: number, h: number): number {
    const { x, y } = this.#particles;
    const { first } = this.#table.hulls;
    const { start, end } = this.#table.edges;
    const own = this.#table.slots.ring[p];
    const side = this.#bounds.turn[h];
    let best = first[h];
    let least = -Infinity;
    for (let k = first[h]; k < first[h + 1]; k++) {
      const b = start[k];
      const ex = x[end[k]] - x[b];
      const ey = y[end[k]] - y[b];
      const area = (s: number) => side * ((x[s] - x[b]) * ey - (y[s] - y[b]) * ex);
      let deepest = area(p);
      if (deepest > 0) continue; // in front of it, though inside: a notch of the ring
      if (own !== NONE) for (let v = first[own]; v < first[own + 1]; v++) deepest = Math.min(deepest, area(start[v]));
      const depth = deepest / Math.sqrt(ex * ex + ey * ey);
      if (depth > least) {
        least = depth;
        best = k;
      }
    }
    return best;
  }

  /** On which side of an open edge a particle belongs: 1 to its right, -1 to its left. */
  sideOf(p: number, k: number): number {
    const { x, y } = this.#particles;
    const b = this.#table.edges.start[k];
    const e = this.#table.edges.end[k];
    const ex = x[e] - x[b];
    const ey = y[e] - y[b];
    const side = (x[p] - x[b]) * ey - (y[p] - y[b]) * ex < 0 ? -1 : 1;
    if (this.#table.slots.ring[p] !== NONE && this.#isPoked(p, k)) return -side;
    return this.#back > 0 && this.#crossing(p, k, -side) < Infinity ? -side : side;
  }

  /** Whether a corner of a ring sticks through an open edge: both of its own edges cross that one. */
  #isPoked(p: number, k: number): boolean {
    const { neighbour } = this.#table;
    const { firstNeighbour } = this.#table.slots;
    for (let n = firstNeighbour[p]; n < firstNeighbour[p + 1]; n++)
      if (!this.#crosses(p, neighbour[n], k)) return false;
    return true;
  }

  /** Whether the way from one particle to another crosses an edge. */
  #crosses(p: number, o: number, k: number): boolean {
    const { x, y } = this.#particles;
    const b = this.#table.edges.start[k];
    const e = this.#table.edges.end[k];
    const ex = x[e] - x[b];
    const ey = y[e] - y[b];
    const px = x[p] - x[b];
    const py = y[p] - y[b];
    const ox = x[o] - x[b];
    const oy = y[o] - y[b];
    const from = px * ey - py * ex;
    const to = ox * ey - oy * ex;
    if (from < 0 === to < 0) return false;
    const time = from / (from - to);
    const along = (px + (ox - px) * time) * ex + (py + (oy - py) * time) * ey;
    return along > 0 && along < ex * ex + ey * ey;
  }
}
