import { requireNonNegative, requireOptions, requireShare } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import { checkedPoints } from './points.ts';
import type { Shape, SurfaceReport } from './shape.ts';

/** How a segment is made. */
export interface SegmentOptions {
  /** Where it begins. Unit: m. */
  a: Readonly<Vec2>;
  /** Where it ends; not where it begins. Unit: m. */
  b: Readonly<Vec2>;
  /** Half of it lies on either side, and the ends are round. Unit: m. @default 0 */
  thickness?: number;
  /** Share of the closing speed that is given back, 0 to 1. @default 0 */
  restitution?: number;
}

/**
 * A straight wall, solid from both sides. A particle is pushed out on the side on which its centre is: one that crosses the
 * middle line within a step comes out behind it. Points (radius 0) touch only a segment that has a thickness.
 */
export class Segment implements Shape {
  readonly restitution: number;
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** Where it begins. Unit: m. */
  readonly a: Readonly<Vec2>;
  /** Where it ends. Unit: m. */
  readonly b: Readonly<Vec2>;
  /** Unit: m. */
  readonly thickness: number;
  readonly #length: number;
  readonly #ux: number;
  readonly #uy: number;

  constructor(options: SegmentOptions) {
    requireOptions('Segment', 'options', options, '{ a: { x: 0, y: 0 }, b: { x: 1, y: 0 } }');
    const { thickness = 0, restitution = 0 } = options;
    const [a, b] = checkedPoints('Segment', [options.a, options.b], 2, false);
    requireNonNegative('Segment', 'thickness', thickness, 'metres');
    requireShare('Segment', 'restitution', restitution);
    this.a = a;
    this.b = b;
    this.thickness = thickness;
    this.restitution = restitution;
    this.minX = Math.min(a.x, b.x) - thickness / 2;
    this.minY = Math.min(a.y, b.y) - thickness / 2;
    this.maxX = Math.max(a.x, b.x) + thickness / 2;
    this.maxY = Math.max(a.y, b.y) + thickness / 2;
    const dx = b.x - a.x;
    const dy = b.y - a.y;
    this.#length = Math.sqrt(dx * dx + dy * dy);
    this.#ux = dx / this.#length;
    this.#uy = dy / this.#length;
  }

  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void {
    const along = Math.min(Math.max(0, (x - this.a.x) * this.#ux + (y - this.a.y) * this.#uy), this.#length);
    const dx = x - (this.a.x + this.#ux * along);
    const dy = y - (this.a.y + this.#uy * along);
    const gap = Math.sqrt(dx * dx + dy * dy);
    const distance = gap - this.thickness / 2;
    if (!(distance < reach)) return;
    if (gap === 0)
      surface.add(distance, -this.#uy, this.#ux); // on the line itself either side will do
    else surface.add(distance, dx / gap, dy / gap);
  }
}
