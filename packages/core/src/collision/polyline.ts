import { requireNonNegative, requireOptions, requireShare } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import { Edges } from './edges.ts';
import { checkedPoints } from './points.ts';
import type { Shape, SurfaceReport } from './shape.ts';

/** How a polyline is made. */
export interface PolylineOptions {
  /** Its points in order, at least two, each apart from the next. Unit: m. */
  points: readonly Readonly<Vec2>[];
  /** Whether the last point is joined to the first. @default false */
  closed?: boolean;
  /** Half of it lies on either side, and the corners are round. Unit: m. @default 0 */
  thickness?: number;
  /** Share of the closing speed that is given back, 0 to 1. @default 0 */
  restitution?: number;
}

/**
 * A chain of straight walls, solid from both sides: terrain, a bowl, a track. Each segment that a disc touches is one
 * contact, so that a groove holds a disc from two sides. A point of the chain counts only on the side on which it sticks
 * out, for discs that stand over neither of its segments: so a disc rolls over the points of a smooth chain without a bump.
 */
export class Polyline implements Shape {
  readonly restitution: number;
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** Its points in order. Unit: m. */
  readonly points: readonly Readonly<Vec2>[];
  /** Whether the last point is joined to the first. */
  readonly closed: boolean;
  /** Unit: m. */
  readonly thickness: number;
  readonly #edges: Edges;

  constructor(options: PolylineOptions) {
    requireOptions('Polyline', 'options', options, '{ points: [{ x: 0, y: 0 }, { x: 1, y: 0 }] }');
    const { closed = false, thickness = 0, restitution = 0 } = options;
    this.points = checkedPoints('Polyline', options.points, closed ? 3 : 2, closed);
    requireNonNegative('Polyline', 'thickness', thickness, 'metres');
    requireShare('Polyline', 'restitution', restitution);
    this.closed = closed;
    this.thickness = thickness;
    this.restitution = restitution;
    this.#edges = new Edges(this.points, closed);
    this.minX = this.#edges.minX - thickness / 2;
    this.minY = this.#edges.minY - thickness / 2;
    this.maxX = this.#edges.maxX + thickness / 2;
    this.maxY = this.#edges.maxY + thickness / 2;
  }

  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void {
    const { count, x: startX, y: startY, ux, uy, length } = this.#edges;
    const half = this.thickness / 2;
    const last = count - 1;
    // Whether the point lies past the end of the edge before: at a corner that sticks out it does, and before the next too.
    let past = !this.closed || (x - startX[last]) * ux[last] + (y - startY[last]) * uy[last] >= length[last];
    for (let e = 0; e < count; e++) {
      const dx = x - startX[e];
      const dy = y - startY[e];
      const along = dx * ux[e] + dy * uy[e];
      if (along < 0) {
        if (past) this.#addPoint(dx, dy, e, reach, surface);
        past = false;
        continue;
      }
      past = along >= length[e];
      if (past) continue;
      const across = ux[e] * dy - uy[e] * dx; // positive to the left
      if (Math.abs(across) - half >= reach) continue;
      if (across < 0) surface.add(-across - half, uy[e], -ux[e]);
      else surface.add(across - half, -uy[e], ux[e]);
    }
    if (past && !this.closed) this.#addPoint(x - startX[count], y - startY[count], last, reach, surface);
  }

  #addPoint(dx: number, dy: number, edge: number, reach: number, surface: SurfaceReport): void {
    const gap = Math.sqrt(dx * dx + dy * dy);
    const distance = gap - this.thickness / 2;
    if (!(distance < reach)) return;
    if (gap === 0) surface.add(distance, -this.#edges.uy[edge], this.#edges.ux[edge]);
    else surface.add(distance, dx / gap, dy / gap);
  }
}
