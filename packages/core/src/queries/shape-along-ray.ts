import type { Shape, SurfaceReport } from '../collision/shape.ts';
import type { Ray } from './ray.ts';

/** Nearer than this the surface is met. Unit: m. */
const TOLERANCE = 1e-9;

/** Most steps towards a surface: a ray that grazes it comes near in ever shorter ones. */
const STEPS = 10_000;

/** Walks along a ray towards the surface of a shape, each time as far as the surface is away. */
export class ShapeAlongRay implements SurfaceReport {
  readonly #ray: Ray;
  #distance = Infinity;
  #normalX = 0;
  #normalY = 0;

  constructor(ray: Ray) {
    this.#ray = ray;
  }

  /** Where the ray enters the shape; undefined where it does not, or starts inside. */
  meet(shape: Shape): { x: number; y: number; normalX: number; normalY: number; fraction: number } | undefined {
    const ray = this.#ray;
    const ux = ray.dx / ray.length;
    const uy = ray.dy / ray.length;
    let along = this.#entry(shape);
    for (let step = 0; step < STEPS && along <= ray.length; step++) {
      const x = ray.x + ux * along;
      const y = ray.y + uy * along;
      this.#look(shape, x, y, ray.length - along + TOLERANCE);
      const leaving = this.#normalX * ux + this.#normalY * uy >= 0;
      if (this.#distance < -TOLERANCE && step === 0) return undefined;
      if (this.#distance <= TOLERANCE && !leaving) {
        return { x, y, normalX: this.#normalX, normalY: this.#normalY, fraction: along / ray.length };
      }
      along += Math.max(this.#distance, TOLERANCE);
    }
    return undefined;
  }

  add(distance: number, normalX: number, normalY: number): void {
    if (distance >= this.#distance) return;
    this.#distance = distance;
    this.#normalX = normalX;
    this.#normalY = normalY;
  }

  #look(shape: Shape, x: number, y: number, reach: number): void {
    this.#distance = Infinity;
    shape.findSurface(x, y, reach, this);
  }

  /** How far along the ray the box around the shape begins; infinitely far where the ray misses it. */
  #entry({ minX, minY, maxX, maxY }: Shape): number {
    const { x, y, dx, dy, length } = this.#ray;
    let enter = 0;
    let leave = 1;
    for (const [from, way, min, max] of [
      [x, dx, minX, maxX],
      [y, dy, minY, maxY],
    ]) {
      if (way === 0) {
        if (from < min || from > max) return Infinity;
        continue;
      }
      const a = (min - from) / way;
      const b = (max - from) / way;
      enter = Math.max(enter, Math.min(a, b));
      leave = Math.min(leave, Math.max(a, b));
    }
    return enter <= leave ? enter * length : Infinity;
  }
}
