import { firstTouch, touchLevel } from './first-touch.ts';
import type { Flight } from './flight.ts';
import type { GapPath } from './gap-path.ts';
import { Tolerance } from './tolerance.ts';

/** Two discs on their ways. */
export class DiscPath implements GapPath {
  gap = 0;
  rate = 0;
  readonly #flight: Flight;
  readonly #tolerance = new Tolerance();
  #reach = 0;
  #x = 0;
  #y = 0;
  #vx = 0;
  #vy = 0;
  #ax = 0;
  #ay = 0;

  constructor(flight: Flight) {
    this.#flight = flight;
  }

  /** The time from `now` at which two discs touch within the step, or `Infinity`. Unit: s. */
  findTouch(i: number, j: number, now: number): number {
    const flight = this.#flight;
    const tolerance = this.#tolerance;
    const { particles, rests, yields } = flight;
    const smaller = particles.radius[i] < particles.radius[j] ? i : j;
    this.#start(i, j, now);
    tolerance.set(particles.radius[smaller], Math.max(rests[i], rests[j]));
    if (yields[i] + yields[j] > 0) tolerance.yield(flight, smaller, Math.max(flight.stepSpeed(i), flight.stepSpeed(j)));
    const duration = flight.duration - now;
    if (this.#ax === 0 && this.#ay === 0) return this.#findStraight(duration);
    const a = Math.sqrt(this.#ax * this.#ax + this.#ay * this.#ay);
    const speed = Math.sqrt(this.#vx * this.#vx + this.#vy * this.#vy) + a * duration;
    return firstTouch(this, speed, duration, this.#reach / 4, tolerance);
  }

  at(t: number): void {
    const x = this.#x + (this.#vx + this.#ax * t * 0.5) * t;
    const y = this.#y + (this.#vy + this.#ay * t * 0.5) * t;
    const distance = Math.sqrt(x * x + y * y);
    this.gap = distance - this.#reach;
    const along = x * (this.#vx + this.#ax * t) + y * (this.#vy + this.#ay * t);
    this.rate = distance === 0 ? 0 : along / distance;
  }

  /**
   * On straight ways the distance is R where |p + v·t|² = R², a quadratic; its lesser root, in the form that does not cancel.
   */
  #findStraight(duration: number): number {
    const x = this.#x;
    const y = this.#y;
    const vx = this.#vx;
    const vy = this.#vy;
    const b = x * vx + y * vy;
    if (!(b < 0)) return Infinity;
    const distance = Math.sqrt(x * x + y * y);
    const level = touchLevel(distance - this.#reach, b / distance, this.#tolerance);
    if (level === Infinity) return 0;
    const R = this.#reach + level;
    const c = (distance - R) * (distance + R);
    const discriminant = b * b - (vx * vx + vy * vy) * c;
    if (!(discriminant > 0)) return Infinity;
    const time = c / (-b + Math.sqrt(discriminant));
    return time <= duration ? time : Infinity;
  }

  /** The first as seen from the second, at a time. */
  #start(i: number, j: number, now: number): void {
    const { particles, time, pace, ax, ay } = this.#flight;
    const { x, y, vx, vy, radius } = particles;
    const mi = pace[i];
    const mj = pace[j];
    const ti = (now - time[i]) * mi;
    const tj = (now - time[j]) * mj;
    this.#reach = radius[i] + radius[j];
    this.#x = x[i] - x[j] + (vx[i] + ax[i] * ti * 0.5) * ti - (vx[j] + ax[j] * tj * 0.5) * tj;
    this.#y = y[i] - y[j] + (vy[i] + ay[i] * ti * 0.5) * ti - (vy[j] + ay[j] * tj * 0.5) * tj;
    this.#vx = (vx[i] + ax[i] * ti) * mi - (vx[j] + ax[j] * tj) * mj;
    this.#vy = (vy[i] + ay[i] * ti) * mi - (vy[j] + ay[j] * tj) * mj;
    this.#ax = ax[i] * mi - ax[j] * mj;
    this.#ay = ay[i] * mi - ay[j] * mj;
  }
}
