import { requirePositive, requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { Shape } from './shape.ts';
import { Surface, type SurfaceOptions } from './surface.ts';
import type { SurfaceReport } from './surface-report.ts';
import type { Sweep } from './sweep.ts';

/** Which half of the plane is solid. */
export interface HalfPlaneOptions extends SurfaceOptions {
  /** A point on the surface. Unit: m. @default { x: 0, y: 0 } */
  point?: Readonly<Vec2>;
  /** Out of the solid half; any length but 0. @default { x: 0, y: 1 }, a floor */
  normal?: Readonly<Vec2>;
}

/** A floor, a wall or a ramp without end: everything behind its surface is solid. */
export class HalfPlane extends Surface implements Shape {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** A point on the surface. Unit: m. */
  readonly point: Readonly<Vec2>;
  /** Unit normal out of the solid half. */
  readonly normal: Readonly<Vec2>;

  constructor(options: HalfPlaneOptions = {}) {
    super('HalfPlane', options);
    const { point = { x: 0, y: 0 }, normal = { x: 0, y: 1 } } = options;
    requireVector('HalfPlane', 'point', point, 'metres');
    requireVector('HalfPlane', 'normal', normal, 'any unit');
    const length = Math.sqrt(normal.x * normal.x + normal.y * normal.y);
    requirePositive('HalfPlane', 'the length of normal', length, '');
    this.point = { x: point.x, y: point.y };
    this.normal = { x: normal.x / length, y: normal.y / length };
    // Upright walls and level floors, which most are, have an end on one side: what is far in front is not asked about.
    this.minX = this.normal.x === -1 ? point.x : -Infinity;
    this.minY = this.normal.y === -1 ? point.y : -Infinity;
    this.maxX = this.normal.x === 1 ? point.x : Infinity;
    this.maxY = this.normal.y === 1 ? point.y : Infinity;
  }

  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void {
    const { point, normal } = this;
    const distance = (x - point.x) * normal.x + (y - point.y) * normal.y;
    if (distance < reach) surface.add(distance, normal.x, normal.y);
  }

  sweep(sweep: Sweep): void {
    const { point, normal } = this;
    sweep.flat((sweep.x - point.x) * normal.x + (sweep.y - point.y) * normal.y, normal.x, normal.y, 0, 0, 0);
  }
}
