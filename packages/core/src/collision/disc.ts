import { requireOptions, requirePositive, requireShare, requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { Shape, SurfaceReport } from './shape.ts';

/** How an immovable disc is made. */
export interface DiscOptions {
  /** Unit: m. */
  centre: Readonly<Vec2>;
  /** Positive. Unit: m. */
  radius: number;
  /** Share of the closing speed that is given back, 0 to 1. @default 0 */
  restitution?: number;
}

/** An immovable, solid disc: a peg, a bumper, a planet. */
export class Disc implements Shape {
  readonly restitution: number;
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** Unit: m. */
  readonly centre: Readonly<Vec2>;
  /** Unit: m. */
  readonly radius: number;

  constructor(options: DiscOptions) {
    requireOptions('Disc', 'options', options, '{ centre: { x: 0, y: 0 }, radius: 1 }');
    const { centre, radius, restitution = 0 } = options;
    requireVector('Disc', 'centre', centre, 'metres');
    requirePositive('Disc', 'radius', radius, 'metres');
    requireShare('Disc', 'restitution', restitution);
    this.centre = Object.freeze({ x: centre.x, y: centre.y });
    this.radius = radius;
    this.restitution = restitution;
    this.minX = centre.x - radius;
    this.minY = centre.y - radius;
    this.maxX = centre.x + radius;
    this.maxY = centre.y + radius;
  }

  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void {
    const dx = x - this.centre.x;
    const dy = y - this.centre.y;
    const gap = Math.sqrt(dx * dx + dy * dy);
    const distance = gap - this.radius;
    if (!(distance < reach)) return;
    if (gap === 0)
      surface.add(distance, 0, 1); // the centre defines no direction: any will do
    else surface.add(distance, dx / gap, dy / gap);
  }
}
