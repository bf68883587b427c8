import type { Shape } from '../../collision/shape.ts';
import type { SurfaceReport } from '../../collision/surface-report.ts';
import { firstTouch } from './first-touch.ts';
import type { Flight } from './flight.ts';
import type { GapPath } from './gap-path.ts';
import { Tolerance } from './tolerance.ts';

/** A point that touches scenery advances by this where the gap is smaller. Unit: m. */
const STRIDE_OF_POINTS = 1e-4;

/** A disc, or a point, on its way past a static shape; the gap is that of the nearest place which the shape reports. */
export class ShapePath implements GapPath, SurfaceReport {
  gap = 0;
  rate = 0;
  readonly #flight: Flight;
  readonly #tolerance = new Tolerance();
  #shape!: Shape;
  #radius = 0;
  #reach = 0;
  #x = 0;
  #y = 0;
  #vx = 0;
  #vy = 0;
  #ax = 0;
  #ay = 0;
  #vxThen = 0;
  #vyThen = 0;

  constructor(flight: Flight) {
    this.#flight = flight;
  }

  /** The time from `now` at which a particle touches a shape within the step, or `Infinity`. Unit: s. */
  findTouch(i: number, shape: Shape, now: number): number {
    this.#start(i, now);
    this.#shape = shape;
    const duration = this.#flight.duration - now;
    const a = Math.sqrt(this.#ax * this.#ax + this.#ay * this.#ay);
    const speed = Math.sqrt(this.#vx * this.#vx + this.#vy * this.#vy) + a * duration;
    const tolerance = this.#tolerance;
    tolerance.set(this.#radius, this.#flight.rests[i]);
    if (this.#flight.yields[i] === 1) tolerance.yield(this.#flight, i, this.#flight.stepSpeed(i));
    this.#reach = this.#radius + speed * duration + tolerance.slack;
    const stride = this.#radius > 0 ? this.#radius / 2 : STRIDE_OF_POINTS;
    return firstTouch(this, speed, duration, stride, tolerance);
  }

  at(t: number): void {
    this.gap = Infinity;
    this.rate = 0;
    this.#vxThen = this.#vx + this.#ax * t;
    this.#vyThen = this.#vy + this.#ay * t;
    const x = this.#x + (this.#vx + this.#ax * t * 0.5) * t;
    const y = this.#y + (this.#vy + this.#ay * t * 0.5) * t;
    this.#shape.findSurface(x, y, this.#reach, this);
  }

  add(distance: number, normalX: number, normalY: number): void {
    const gap = distance - this.#radius;
    if (!(gap < this.gap)) return;
    this.gap = gap;
    this.rate = this.#vxThen * normalX + this.#vyThen * normalY;
  }

  #start(i: number, now: number): void {
    const { particles, time, pace, ax, ay } = this.#flight;
    const { x, y, vx, vy, radius } = particles;
    const m = pace[i];
    const t = (now - time[i]) * m;
    this.#radius = radius[i];
    this.#x = x[i] + (vx[i] + ax[i] * t * 0.5) * t;
    this.#y = y[i] + (vy[i] + ay[i] * t * 0.5) * t;
    this.#vx = (vx[i] + ax[i] * t) * m;
    this.#vy = (vy[i] + ay[i] * t) * m;
    this.#ax = ax[i] * m;
    this.#ay = ay[i] * m;
  }
}
