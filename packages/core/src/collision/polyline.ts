import { requireFlag, requireNonNegative, requireOptions } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import { Edges } from './edges.ts';
import { checkedPoints } from './points.ts';
import type { Shape } from './shape.ts';
import { Surface, type SurfaceOptions } from './surface.ts';
import type { SurfaceReport } from './surface-report.ts';
import type { Sweep } from './sweep.ts';

/** How a polyline is made. */
export interface PolylineOptions extends SurfaceOptions {
  /** Its points in order, at least two, each apart from the next. Unit: m. */
  points: readonly Readonly<Vec2>[];
  /** Whether the last point is joined to the first. @default false */
  closed?: boolean;
  /** Half of it lies on either side, and the corners are round. Unit: m. @default 0 */
  thickness?: number;
  /**
   * Whether it is solid from its left alone, seen from each point to the next, which is above where they go to the right: what comes
   * from the other side passes, and is held once it is through. @default false
   */
  oneSided?: boolean;
}

/**
 * A chain of straight walls, solid from both sides unless `oneSided`: terrain, a bowl, a track. Each segment that a disc touches is one
 * contact, so that a groove holds a disc from two sides. A point of the chain counts only on the side on which it sticks
 * out, for discs that stand over neither of its segments: so a disc rolls over the points of a smooth chain without a bump.
 */
export class Polyline extends Surface implements Shape {
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
  /** Whether it is solid from its left alone. */
  readonly oneSided: boolean;
  readonly #edges: Edges;

  constructor(options: PolylineOptions) {
    requireOptions('Polyline', 'options', options, '{ points: [{ x: 0, y: 0 }, { x: 1, y: 0 }] }');
    super('Polyline', options);
    const { closed = false, thickness = 0, oneSided = false } = options;
    this.points = checkedPoints('Polyline', options.points, closed ? 3 : 2, closed);
    requireNonNegative('Polyline', 'thickness', thickness, 'metres');
    requireFlag('Polyline', 'oneSided', oneSided);
    this.closed = closed;
    this.thickness = thickness;
    this.oneSided = oneSided;
    this.#edges = new Edges(this.points, closed);
    this.minX = this.#edges.minX - thickness / 2;
    this.minY = this.#edges.minY - thickness / 2;
    this.maxX = this.#edges.maxX + thickness / 2;
    this.maxY = this.#edges.maxY + thickness / 2;
  }

  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void {
    const { count, x: startX, y: startY, ux, uy, length, tree } = this.#edges;
    const half = this.thickness / 2;
    const around = reach + half;
    const found = tree.find(x - around, y - around, x + around, y + around);
    for (let f = 0; f < found; f++) {
      const e = tree.found[f];
      const dx = x - startX[e];
      const dy = y - startY[e];
      const along = dx * ux[e] + dy * uy[e];
      const across = ux[e] * dy - uy[e] * dx; // positive to the left
      if (this.oneSided && across < half) continue;
      if (along < 0) {
        if (this.#edges.isPastBefore(e, x, y)) this.#addPoint(dx, dy, e, reach, surface);
      } else if (along < length[e]) {
        if (Math.abs(across) - half >= reach) continue;
        if (across < 0) surface.add(-across - half, uy[e], -ux[e]);
        else surface.add(across - half, -uy[e], ux[e]);
      } else if (e === count - 1 && !this.closed) {
        this.#addPoint(x - startX[count], y - startY[count], e, reach, surface);
      }
    }
  }

  sweep(sweep: Sweep): void {
    this.#edges.tell(sweep, this.thickness / 2, this.oneSided ? 'left' : 'both');
  }

  #addPoint(dx: number, dy: number, edge: number, reach: number, surface: SurfaceReport): void {
    const gap = Math.sqrt(dx * dx + dy * dy);
    const distance = gap - this.thickness / 2;
    if (!(distance < reach)) return;
    if (gap === 0) surface.add(distance, -this.#edges.uy[edge], this.#edges.ux[edge]);
    else surface.add(distance, dx / gap, dy / gap);
  }
}
