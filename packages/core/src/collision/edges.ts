import type { Vec2 } from '../math/vec2.ts';

/** The straight edges from each point of a shape to the next, as arrays, and the box around them. */
export class Edges {
  readonly count: number;
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

  constructor(points: readonly Readonly<Vec2>[], closed: boolean) {
    const count = closed ? points.length : points.length - 1;
    this.count = count;
    this.x = Float64Array.from(points, ({ x }) => x);
    this.y = Float64Array.from(points, ({ y }) => y);
    this.ux = new Float64Array(count);
    this.uy = new Float64Array(count);
    this.length = new Float64Array(count);
    for (let e = 0; e < count; e++) {
      const end = (e + 1) % points.length;
      const dx = this.x[end] - this.x[e];
      const dy = this.y[end] - this.y[e];
      const length = Math.sqrt(dx * dx + dy * dy);
      this.ux[e] = dx / length;
      this.uy[e] = dy / length;
      this.length[e] = length;
    }
    this.minX = this.x.reduce((a, b) => Math.min(a, b));
    this.minY = this.y.reduce((a, b) => Math.min(a, b));
    this.maxX = this.x.reduce((a, b) => Math.max(a, b));
    this.maxY = this.y.reduce((a, b) => Math.max(a, b));
  }
}
