import { describe, requireOptions } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import { Edges } from './edges.ts';
import { checkedPoints } from './points.ts';
import { findCrossing, signedArea } from './polygon-checks.ts';
import type { Shape } from './shape.ts';
import { Surface, type SurfaceOptions } from './surface.ts';
import type { SurfaceReport } from './surface-report.ts';
import type { Sweep } from './sweep.ts';

/** How an immovable polygon is made. */
export interface PolygonOptions extends SurfaceOptions {
  /** Its corners in order, either way round, at least three; the edges must not cross. Unit: m. */
  points: readonly Readonly<Vec2>[];
}

/** A point this far behind an edge that rounding does not find inside still counts as on it. Unit: m. */
const ON_EDGE = 1e-9;

/**
 * An immovable, solid polygon, convex or not. Each edge that a disc touches is one contact, so that a notch holds a disc
 * from two sides; corners count where they stick out. A particle whose centre is inside is pushed out by the nearest way.
 */
export class Polygon extends Surface implements Shape {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** Its corners, counter-clockwise. Unit: m. */
  readonly points: readonly Readonly<Vec2>[];
  readonly #edges: Edges;

  constructor(options: PolygonOptions) {
    requireOptions('Polygon', 'options', options, '{ points: [{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0, y: 1 }] }');
    super('Polygon', options);
    const points = checkedPoints('Polygon', options.points, 3, true);
    const crossing = findCrossing(points);
    if (crossing !== undefined) {
      const [e, f] = crossing;
      throw new RangeError(
        `Polygon: edges must not meet except at their common corner; those from points ${e} and ${f} do. ` +
          'Split it into polygons that do not cross themselves.',
      );
    }
    const area = signedArea(points);
    if (!(Math.abs(area) > 0 && Math.abs(area) < Infinity)) {
      throw new RangeError(`Polygon: points must enclose an area; got ${describe(Math.abs(area))} m².`);
    }
    this.points = area > 0 ? points : Object.freeze([...points].reverse());
    this.#edges = new Edges(this.points, true);
    this.minX = this.#edges.minX;
    this.minY = this.#edges.minY;
    this.maxX = this.#edges.maxX;
    this.maxY = this.#edges.maxY;
  }

  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void {
    if (this.#contains(x, y)) this.#addNearest(x, y, reach, surface);
    else this.#addTouched(x, y, reach, surface);
  }

  sweep(sweep: Sweep): void {
    this.#edges.tell(sweep, 0, 'right');
  }

  /** By the number of edges that a ray to the right crosses. */
  #contains(px: number, py: number): boolean {
    if (px < this.minX || px > this.maxX || py < this.minY || py > this.maxY) return false;
    const { count, x, y, tree } = this.#edges;
    const found = tree.find(px, py, Infinity, py);
    let inside = false;
    for (let f = 0; f < found; f++) {
      const before = tree.found[f]; // the edge from here to the next corner
      const e = before + 1 === count ? 0 : before + 1;
      if (y[e] > py === y[before] > py) continue;
      if (px < x[e] + ((x[before] - x[e]) * (py - y[e])) / (y[before] - y[e])) inside = !inside;
    }
    return inside;
  }

  /** From outside: each edge that the point stands over, in front, and each corner that sticks out towards it. */
  #addTouched(px: number, py: number, reach: number, surface: SurfaceReport): void {
    const { x, y, ux, uy, length, tree } = this.#edges;
    const around = reach + ON_EDGE;
    const found = tree.find(px - around, py - around, px + around, py + around);
    for (let f = 0; f < found; f++) {
      const e = tree.found[f];
      const dx = px - x[e];
      const dy = py - y[e];
      const along = dx * ux[e] + dy * uy[e];
      if (along < 0) {
        const before = this.#edges.before(e);
        const sticksOut = ux[before] * uy[e] - uy[before] * ux[e] > 0;
        if (sticksOut && this.#edges.isPastBefore(e, px, py)) this.#addCorner(dx, dy, e, reach, surface);
      } else if (along < length[e]) {
        const front = uy[e] * dx - ux[e] * dy;
        if (front > -ON_EDGE && front < reach) surface.add(front, uy[e], -ux[e]);
      }
    }
  }

  /** From inside: the nearest place of the surface, which is looked for within `around`, then twice as far, and so on. */
  #addNearest(px: number, py: number, around: number, surface: SurfaceReport): void {
    const { x, y, ux, uy, length, tree } = this.#edges;
    const found = tree.find(px - around, py - around, px + around, py + around);
    let nearest = Infinity;
    let nx = 0;
    let ny = 0;
    for (let f = 0; f < found; f++) {
      const e = tree.found[f];
      const along = (px - x[e]) * ux[e] + (py - y[e]) * uy[e];
      const clamped = Math.min(Math.max(0, along), length[e]);
      const dx = x[e] + ux[e] * clamped - px;
      const dy = y[e] + uy[e] * clamped - py;
      const distance = Math.sqrt(dx * dx + dy * dy);
      if (!(distance < nearest)) continue;
      nearest = distance;
      const isCorner = clamped !== along && distance > 0;
      nx = isCorner ? dx / distance : uy[e];
      ny = isCorner ? dy / distance : -ux[e];
    }
    if (nearest <= around) surface.add(-nearest, nx, ny);
    else this.#addNearest(px, py, Math.max(around * 2, length[0]), surface);
  }

  #addCorner(dx: number, dy: number, edge: number, reach: number, surface: SurfaceReport): void {
    const distance = Math.sqrt(dx * dx + dy * dy);
    if (!(distance < reach)) return;
    if (distance === 0) surface.add(distance, this.#edges.uy[edge], -this.#edges.ux[edge]);
    else surface.add(distance, dx / distance, dy / distance);
  }
}
