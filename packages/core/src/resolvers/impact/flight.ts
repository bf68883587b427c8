import type { ParticleStore } from '../../particles/particle-store.ts';
import { slackOf } from './slack.ts';

/**
 * The particles on their ways between impacts. Each has a time of its own, at which its position and velocity stand in the
 * store (B. D. Lubachevsky, *How to simulate billiards and similar systems*, 1991): an impact touches two particles, and
 * the others need not be brought up to it. From there the way is exact, x + v·t + a·t²/2, as long as the acceleration lasts.
 */
export class Flight {
  /** Acceleration by gravity and forces, as the step found it. Unit: m/s². */
  freeX: Float64Array = new Float64Array(0);
  freeY: Float64Array = new Float64Array(0);
  /** The same with what supports the particle where it rests. Unit: m/s². */
  ax: Float64Array = new Float64Array(0);
  ay: Float64Array = new Float64Array(0);
  /** Since the step began; what the store holds of a particle is of this time. Unit: s. */
  time: Float64Array = new Float64Array(0);
  /** 1, or 0 where a particle stands still for the rest of the step: see `ImpactResolver`. */
  pace: Float64Array = new Float64Array(0);
  /** Impacts of each particle in this step. */
  impacts: Int32Array = new Int32Array(0);
  /** How often each particle came to rest in this step. */
  rests: Int32Array = new Int32Array(0);
  /** 1 where a particle is in a crowd: slowly, it may sink into others until the step ends. */
  yields: Uint8Array = new Uint8Array(0);
  /** Grows whenever the way of a particle changes. */
  turns: Int32Array = new Int32Array(0);
  /** Duration of the step. Unit: s. */
  duration = 0;
  /** Whether any particle is accelerated. */
  isDriven = false;
  /** A gap that counts as none, for the smallest disc. Unit: m. */
  slack = 0;
  #particles!: ParticleStore;

  get particles(): ParticleStore {
    return this.#particles;
  }

  /**
   * Reads fx, fy, ax, ay, inverseMass. Clears fx, fy. Writes the flight.
   * @returns Whether everything is finite.
   */
  begin(particles: ParticleStore, gravity: { readonly x: number; readonly y: number }, duration: number): boolean {
    this.#particles = particles;
    this.duration = duration;
    if (this.time.length !== particles.capacity) this.#resize(particles.capacity);
    const { count, x, y, vx, vy, fx, fy, radius, inverseMass, accelerated } = particles;
    const { freeX, freeY } = this;
    for (let i = 0; i < count; i++) {
      const w = inverseMass[i];
      freeX[i] = w === 0 ? 0 : gravity.x + fx[i] * w;
      freeY[i] = w === 0 ? 0 : gravity.y + fy[i] * w;
    }
    if (accelerated) this.#addConstant();
    fx.fill(0, 0, count);
    fy.fill(0, 0, count);
    this.ax.set(freeX);
    this.ay.set(freeY);
    this.time.fill(0, 0, count);
    this.pace.fill(1, 0, count);
    this.impacts.fill(0, 0, count);
    this.rests.fill(0, 0, count);
    this.yields.fill(0, 0, count);
    let sum = 0;
    let smallest = Infinity;
    this.isDriven = false;
    for (let i = 0; i < count; i++) {
      sum += x[i] + y[i] + (vx[i] + vy[i]) + (freeX[i] + freeY[i]);
      if (freeX[i] !== 0 || freeY[i] !== 0) this.isDriven = true;
      if (inverseMass[i] !== 0) smallest = Math.min(smallest, radius[i]);
    }
    this.slack = slackOf(smallest);
    return sum - sum === 0;
  }

  /** Brings a particle to a time. Reads ax, ay. Writes x, y, vx, vy, time. */
  advance(i: number, time: number): void {
    const { x, y, vx, vy } = this.#particles;
    const t = (time - this.time[i]) * this.pace[i];
    this.time[i] = time;
    x[i] += (vx[i] + this.ax[i] * t * 0.5) * t;
    y[i] += (vy[i] + this.ay[i] * t * 0.5) * t;
    vx[i] += this.ax[i] * t;
    vy[i] += this.ay[i] * t;
  }

  /** Brings all to the end of the step, those that are not finite included. */
  finish(): void {
    const { count } = this.#particles;
    for (let i = 0; i < count; i++) this.advance(i, this.duration);
  }

  /** The speed that a particle's acceleration builds in a step. Unit: m/s. */
  stepSpeed(i: number): number {
    return Math.sqrt(this.freeX[i] * this.freeX[i] + this.freeY[i] * this.freeY[i]) * this.duration;
  }

  #addConstant(): void {
    const { count, ax, ay, inverseMass } = this.#particles;
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0) continue;
      this.freeX[i] += ax[i];
      this.freeY[i] += ay[i];
    }
  }

  #resize(capacity: number): void {
    this.freeX = new Float64Array(capacity);
    this.freeY = new Float64Array(capacity);
    this.ax = new Float64Array(capacity);
    this.ay = new Float64Array(capacity);
    this.time = new Float64Array(capacity);
    this.pace = new Float64Array(capacity);
    this.impacts = new Int32Array(capacity);
    this.rests = new Int32Array(capacity);
    this.yields = new Uint8Array(capacity);
    this.turns = new Int32Array(capacity);
  }
}
