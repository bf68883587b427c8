import type { Shape } from '../../collision/shape.ts';
import type { SurfaceReport } from '../../collision/surface-report.ts';

/** Two normals closer than this, by their product, are of one place. */
export const SAME_PLACE = 0.9;

/** The places of a static shape that a disc touches. */
export class Places implements SurfaceReport {
  count = 0;
  /** From the disc to the place, negative where it overlaps. Unit: m. */
  readonly gap: number[] = [];
  /** Unit normals out of the shape. */
  readonly normalX: number[] = [];
  readonly normalY: number[] = [];
  #radius = 0;

  /** Finds the places nearer than `tolerance` to a disc. */
  find(shape: Shape, x: number, y: number, radius: number, tolerance: number): number {
    this.count = 0;
    this.#radius = radius;
    shape.findSurface(x, y, radius + tolerance, this);
    return this.count;
  }

  add(distance: number, normalX: number, normalY: number): void {
    this.gap[this.count] = distance - this.#radius;
    this.normalX[this.count] = normalX;
    this.normalY[this.count] = normalY;
    this.count++;
  }

  /** The gap to the place with about this normal, whatever it is, up to the radius and 1 m. Unit: m. */
  gapAt(shape: Shape, x: number, y: number, radius: number, normalX: number, normalY: number): number {
    const count = this.find(shape, x, y, radius, radius + 1);
    let gap = radius + 1;
    for (let p = 0; p < count; p++) {
      const same = this.normalX[p] * normalX + this.normalY[p] * normalY > SAME_PLACE;
      if (same) gap = Math.min(gap, this.gap[p]);
    }
    return gap;
  }
}
