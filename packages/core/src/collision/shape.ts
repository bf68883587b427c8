/** Immovable scenery that particles collide with. A game's own is made the same way. */
export interface Shape {
  /** Share of the closing speed that is given back; of this and the particle's the greater counts. 0 to 1. */
  readonly restitution: number;
  /** Coefficient of friction, 0 or more; of this and the particle's the geometric mean counts. @default 0 */
  readonly friction?: number;
  /**
   * How fast the surface moves along the tangent (normalY, -normalX), to the right on a floor: a conveyor. It pulls by
   * friction. Unit: m/s. @default 0
   */
  readonly surfaceSpeed?: number;
  /** The box around the shape, infinite where it has no end: particles farther off are not asked about. Unit: m. */
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /**
   * Reports each place of the surface that is nearer than `reach` to a point, or that the point lies behind.
   * @param x - The point. Unit: m.
   * @param y - The point. Unit: m.
   * @param reach - How near a place must be to be reported. Unit: m.
   */
  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void;
}

/** Where a shape reports its places. */
export interface SurfaceReport {
  /**
   * Reports a place.
   * @param distance - From the surface to the point, negative inside. Unit: m.
   * @param normalX - Unit normal at the place, out of the shape.
   * @param normalY - Unit normal at the place, out of the shape.
   */
  add(distance: number, normalX: number, normalY: number): void;
}
