import type { Shape, ShapeWalk } from './shape.ts';
import type { SurfaceReport } from './surface-report.ts';
import type { Sweep } from './sweep.ts';

/** Nearer than this a surface is met. Unit: m. */
const TOLERANCE = 1e-9;

/** What closes by less than this share of the way runs along the surface, to rounding. */
const ALONG = 1e-3;

/** Most of Newton's steps to a surface within the least step; one is enough where it is straight. */
const NEWTON_STEPS = 16;

/** Brings a disc on its way up to a shape that has no `sweep`, each time as far as the surface is away (J. C. Hart, *Sphere Tracing*, 1996). */
export class SurfaceWalk implements ShapeWalk, SurfaceReport {
  #ux = 0;
  #uy = 0;
  /** To the nearest place, and to the nearest that the way closes upon. Unit: m. */
  #distance = Infinity;
  #ahead = Infinity;
  #normalX = 0;
  #normalY = 0;

  meet(shape: Shape, sweep: Sweep, least: number): void {
    const { length, radius } = sweep;
    this.#ux = sweep.dx / length;
    this.#uy = sweep.dy / length;
    const start = entry(shape, sweep) * length;
    this.#look(shape, sweep, start);
    const level = Math.min(radius, this.#distance); // what is in each other already meets where it would be deeper
    for (let along = start, before = start; along <= length; ) {
      this.#look(shape, sweep, along);
      const step = Math.max(this.#distance - level, least);
      const isPast = this.#ahead < level - TOLERANCE;
      if (this.#approach(shape, sweep, level, along, before, Math.min(along + step, length))) return;
      if (isPast) {
        // It came in at so narrow an angle that the place is not found: this one is near.
        this.#look(shape, sweep, along);
        this.#meet(sweep, along);
        return;
      }
      before = along;
      along += step;
    }
  }

  add(distance: number, normalX: number, normalY: number): void {
    this.#distance = Math.min(this.#distance, distance);
    if (distance >= this.#ahead || !(normalX * this.#ux + normalY * this.#uy < -ALONG)) return;
    this.#ahead = distance;
    this.#normalX = normalX;
    this.#normalY = normalY;
  }

  /** Goes on from a place to that where the distance is `level`, by Newton's method, if that lies between two others. */
  #approach(shape: Shape, sweep: Sweep, level: number, along: number, from: number, to: number): boolean {
    let towards = along;
    for (let newton = 0; newton < NEWTON_STEPS; newton++) {
      const gap = this.#ahead - level;
      if (Math.abs(gap) <= TOLERANCE) {
        this.#meet(sweep, towards);
        return true;
      }
      towards -= gap / (this.#normalX * this.#ux + this.#normalY * this.#uy);
      if (!(towards >= from && towards <= to)) return false;
      this.#look(shape, sweep, towards);
    }
    return false;
  }

  #meet(sweep: Sweep, along: number): void {
    const closing = -(this.#normalX * this.#ux + this.#normalY * this.#uy);
    sweep.meet(along / sweep.length, this.#ahead + closing * along, this.#normalX, this.#normalY);
  }

  #look(shape: Shape, { x, y, radius, length }: Sweep, along: number): void {
    this.#distance = this.#ahead = Infinity;
    shape.findSurface(x + this.#ux * along, y + this.#uy * along, radius + length - along + TOLERANCE, this);
  }
}

/** Where on its way a disc comes to the box around a shape, as a share; `Infinity` where it does not. */
function entry({ minX, minY, maxX, maxY }: Shape, { x, y, dx, dy, radius }: Sweep): number {
  const x0 = (minX - radius - x) / dx;
  const x1 = (maxX + radius - x) / dx;
  const y0 = (minY - radius - y) / dy;
  const y1 = (maxY + radius - y) / dy;
  if (dx === 0 && (x < minX - radius || x > maxX + radius)) return Infinity;
  if (dy === 0 && (y < minY - radius || y > maxY + radius)) return Infinity;
  const enter = Math.max(0, dx === 0 ? 0 : Math.min(x0, x1), dy === 0 ? 0 : Math.min(y0, y1));
  const leave = Math.min(1, dx === 0 ? 1 : Math.max(x0, x1), dy === 0 ? 1 : Math.max(y0, y1));
  return enter <= leave ? enter : Infinity;
}
