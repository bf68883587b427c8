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
