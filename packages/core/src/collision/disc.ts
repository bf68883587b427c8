import { requireOptions, requirePositive, requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { Shape } from './shape.ts';
import { Surface, type SurfaceOptions } from './surface.ts';
import type { SurfaceReport } from './surface-report.ts';
import type { Sweep } from './sweep.ts';

/** How an immovable disc is made. */
export interface DiscOptions extends SurfaceOptions {
  /** Unit: m. */
  centre: Readonly<Vec2>;
  /** Positive. Unit: m. */
  radius: number;
}

/** An immovable, solid disc: a peg, a bumper, a planet. */
export class Disc extends Surface implements Shape {
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
    super('Disc', options);
    const { centre, radius } = options;
    requireVector('Disc', 'centre', centre, 'metres');
    requirePositive('Disc', 'radius', radius, 'metres');
    this.centre = Object.freeze({ x: centre.x, y: centre.y });
    this.radius = radius;
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

  sweep(sweep: Sweep): void {
    sweep.corner(this.centre.x, this.centre.y, this.radius, 0, 0, 0, 0);
  }
}
