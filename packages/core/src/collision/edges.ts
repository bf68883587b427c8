import type { Vec2 } from '../math/vec2.ts';
import { BoxTree } from './box-tree.ts';
import type { Sweep } from './sweep.ts';

/** Which sides of edges are solid: both, the left alone, or the right alone, as of a polygon whose corners go counter-clockwise. */
export type SolidSides = 'both' | 'left' | 'right';

/** The straight edges from each point of a shape to the next, as arrays, the box around them, and a tree to find those in a place. */
export class Edges {
  readonly count: number;
  /** Whether the last point is joined to the first. */
  readonly closed: boolean;
  /** Where each edge begins. An open chain has one more point, at which the last edge ends. Unit: m. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** Unit vector along each edge. */
  readonly ux: Float64Array;
  readonly uy: Float64Array;
  /** Unit: m. */
  readonly length: Float64Array;
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** Finds edges by the boxes around them. */
  readonly tree: BoxTree;

  constructor(points: readonly Readonly<Vec2>[], closed: boolean) {
    const count = closed ? points.length : points.length - 1;
    this.count = count;
    this.closed = closed;
    this.x = Float64Array.from(points, ({ x }) => x);
    this.y = Float64Array.from(points, ({ y }) => y);
    this.ux = new Float64Array(count);
    this.uy = new Float64Array(count);
    this.length = new Float64Array(count);
    const boxes = new Float64Array(count * 4);
    for (let e = 0; e < count; e++) {
      const end = (e + 1) % points.length;
      const dx = this.x[end] - this.x[e];
      const dy = this.y[end] - this.y[e];
      const length = Math.sqrt(dx * dx + dy * dy);
      this.ux[e] = dx / length;
      this.uy[e] = dy / length;
      this.length[e] = length;
      boxes[e * 4] = Math.min(this.x[e], this.x[end]);
      boxes[e * 4 + 1] = Math.min(this.y[e], this.y[end]);
      boxes[e * 4 + 2] = Math.max(this.x[e], this.x[end]);
      boxes[e * 4 + 3] = Math.max(this.y[e], this.y[end]);
    }
    this.tree = new BoxTree(boxes);
    this.minX = this.x.reduce((a, b) => Math.min(a, b));
    this.minY = this.y.reduce((a, b) => Math.min(a, b));
    this.maxX = this.x.reduce((a, b) => Math.max(a, b));
    this.maxY = this.y.reduce((a, b) => Math.max(a, b));
  }

  /** The edge that ends where one begins, or -1. */
  before(edge: number): number {
    return edge > 0 ? edge - 1 : this.closed ? this.count - 1 : -1;
  }

  /** Whether a place lies past the end of the edge before one, where a corner may count. */
  isPastBefore(edge: number, px: number, py: number): boolean {
    const b = this.before(edge);
    return b < 0 || (px - this.x[b]) * this.ux[b] + (py - this.y[b]) * this.uy[b] >= this.length[b];
  }

  /** Tells a disc on its way of the edges near it, which are thick by twice `half`, and of the corners between them. */
  tell(sweep: Sweep, half: number, sides: SolidSides): void {
    const { count, x, y, ux, uy, length, tree } = this;
    const reach = sweep.radius + sweep.slack + half;
    const endX = sweep.x + sweep.dx;
    const endY = sweep.y + sweep.dy;
    const found = tree.find(
      Math.min(sweep.x, endX) - reach,
      Math.min(sweep.y, endY) - reach,
      Math.max(sweep.x, endX) + reach,
      Math.max(sweep.y, endY) + reach,
    );
    for (let f = 0; f < found; f++) {
      const e = tree.found[f];
      const dx = sweep.x - x[e];
      const dy = sweep.y - y[e];
      const across = ux[e] * dy - uy[e] * dx; // positive to the left
      if (sides === 'left' && !isInFront(across - half, sweep)) continue;
      const side = sides === 'right' || (sides === 'both' && across < 0) ? -1 : 1;
      const along = dx * ux[e] + dy * uy[e];
      const alongWay = sweep.dx * ux[e] + sweep.dy * uy[e];
      sweep.flat(side * across - half, -side * uy[e], side * ux[e], along, alongWay, length[e]);
      const b = this.before(e);
      sweep.corner(x[e], y[e], half, b < 0 ? 0 : ux[b], b < 0 ? 0 : uy[b], ux[e], uy[e]);
      if (e === count - 1 && !this.closed) sweep.corner(x[count], y[count], half, ux[e], uy[e], 0, 0);
    }
  }
}

/** How deep a disc may be in what is solid from one side alone, as a share of its radius, and still have come from the front. */
export const FRONT_SHARE = 0.05;

/** Whether a disc on its way starts in front of a surface that is solid from there alone. */
function isInFront(distance: number, { radius, held }: Sweep): boolean {
  return distance >= (held ? 0 : radius * (1 - FRONT_SHARE));
}
