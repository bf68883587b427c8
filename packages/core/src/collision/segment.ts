import { requireFlag, requireNonNegative, requireOptions } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import { Edges } from './edges.ts';
import { checkedPoints } from './points.ts';
import type { Shape } from './shape.ts';
import { Surface, type SurfaceOptions } from './surface.ts';
import type { SurfaceReport } from './surface-report.ts';
import type { Sweep } from './sweep.ts';

/** How a segment is made. */
export interface SegmentOptions extends SurfaceOptions {
  /** Where it begins. Unit: m. */
  a: Readonly<Vec2>;
  /** Where it ends; not where it begins. Unit: m. */
  b: Readonly<Vec2>;
  /** Half of it lies on either side, and the ends are round. Unit: m. @default 0 */
  thickness?: number;
  /**
   * Whether it is solid from its left alone, seen from a to b, which is above where b is to the right: what comes from the other side
   * passes, and is held once it is through. @default false
   */
  oneSided?: boolean;
}

/**
 * A straight wall, solid from both sides unless `oneSided`. A particle is pushed out on the side on which its centre is: one that crosses the
 * middle line within a step comes out behind it, which cannot happen where the resolver looks ahead, as the sub-step resolver does. Of a
 * segment without thickness that one keeps points (radius 0) 1 mm off; other resolvers do not let the two touch.
 */
export class Segment extends Surface implements Shape {
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
  /** Whether it is solid from its left alone. */
  readonly oneSided: boolean;
  readonly #edges: Edges;

  constructor(options: SegmentOptions) {
    requireOptions('Segment', 'options', options, '{ a: { x: 0, y: 0 }, b: { x: 1, y: 0 } }');
    super('Segment', options);
    const { thickness = 0, oneSided = false } = options;
    const [a, b] = checkedPoints('Segment', [options.a, options.b], 2, false);
    requireNonNegative('Segment', 'thickness', thickness, 'metres');
    requireFlag('Segment', 'oneSided', oneSided);
    this.a = a;
    this.b = b;
    this.thickness = thickness;
    this.oneSided = oneSided;
    this.minX = Math.min(a.x, b.x) - thickness / 2;
    this.minY = Math.min(a.y, b.y) - thickness / 2;
    this.maxX = Math.max(a.x, b.x) + thickness / 2;
    this.maxY = Math.max(a.y, b.y) + thickness / 2;
    this.#edges = new Edges([a, b], false);
  }

  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void {
    const ux = this.#edges.ux[0];
    const uy = this.#edges.uy[0];
    const fromX = x - this.a.x;
    const fromY = y - this.a.y;
    const along = Math.min(Math.max(0, fromX * ux + fromY * uy), this.#edges.length[0]);
    const dx = x - (this.a.x + ux * along);
    const dy = y - (this.a.y + uy * along);
    const gap = Math.sqrt(dx * dx + dy * dy);
    const distance = gap - this.thickness / 2;
    if (!(distance < reach) || (this.oneSided && ux * fromY - uy * fromX < this.thickness / 2)) return;
    if (gap === 0)
      surface.add(distance, -uy, ux); // on the line itself either side will do
    else surface.add(distance, dx / gap, dy / gap);
  }

  sweep(sweep: Sweep): void {
    this.#edges.tell(sweep, this.thickness / 2, this.oneSided ? 'left' : 'both');
  }
}
