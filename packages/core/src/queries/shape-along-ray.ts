import type { Shape, SurfaceReport } from '../collision/shape.ts';
import type { Ray } from './ray.ts';

/** Nearer than this the surface is met. Unit: m. */
const TOLERANCE = 1e-9;

/** Least step, as a share of the ray: one that grazes a surface would come near in ever shorter ones. What is thinner may be missed. */
const LEAST_STEP = 1e-5;

/** Most of Newton's steps to a surface within the least step; one is enough where it is straight. */
const NEWTON_STEPS = 16;

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
    const least = Math.max(TOLERANCE, LEAST_STEP * ray.length);
    const at = (along: number) => {
      const x = ray.x + ux * along;
      const y = ray.y + uy * along;
      this.#look(shape, x, y, ray.length - along + TOLERANCE);
      return { x, y, normalX: this.#normalX, normalY: this.#normalY, fraction: along / ray.length };
    };
    const start = this.#entry(shape);
    for (let along = start, before = start; along <= ray.length; ) {
      let met = at(along);
      if (this.#distance < -TOLERANCE && along === start) return undefined;
      const step = Math.max(this.#distance, least);
      let towards = along;
      for (let newton = 0; newton < NEWTON_STEPS; newton++) {
        const closing = -(this.#normalX * ux + this.#normalY * uy);
        if (!(closing > 0)) break;
        if (Math.abs(this.#distance) <= TOLERANCE) return met;
        towards += this.#distance / closing;
        if (!(towards >= before && towards <= Math.min(along + step, ray.length))) break;
        met = at(towards);
      }
      before = along;
      along += step;
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
