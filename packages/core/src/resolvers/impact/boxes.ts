import type { Flight } from './flight.ts';

/** Boxes reach farther than what is in them by this share of the radius, so that what nearly touches overlaps. */
const MARGIN = 0.11;

/** The box around the way of each particle from now to the end of the step. */
export class Boxes {
  minX: Float64Array = new Float64Array(0);
  minY: Float64Array = new Float64Array(0);
  maxX: Float64Array = new Float64Array(0);
  maxY: Float64Array = new Float64Array(0);
  /** Slots of discs, from left to right. */
  order: Int32Array = new Int32Array(0);
  orderCount = 0;

  /** Boxes of all, and their order. */
  begin(flight: Flight): void {
    const { capacity, count } = flight.particles;
    if (this.minX.length !== capacity) this.#resize(capacity);
    for (let i = 0; i < count; i++) this.update(flight, i, flight.time[i]);
  }

  /**
   * The box around the two ends of the way, and a margin by which a parabola leaves their chord: a·t²/8.
   * Reads the flight. Writes one box.
   */
  update({ particles, time, pace, ax, ay, duration }: Flight, i: number, now: number): void {
    const { x, y, vx, vy, radius } = particles;
    const m = pace[i];
    const t0 = (now - time[i]) * m;
    const t1 = (duration - time[i]) * m;
    const x0 = x[i] + (vx[i] + ax[i] * t0 * 0.5) * t0;
    const y0 = y[i] + (vy[i] + ay[i] * t0 * 0.5) * t0;
    const x1 = x[i] + (vx[i] + ax[i] * t1 * 0.5) * t1;
    const y1 = y[i] + (vy[i] + ay[i] * t1 * 0.5) * t1;
    const bulge = (t1 - t0) * (t1 - t0) * 0.125;
    const reachX = radius[i] * (1 + MARGIN) + Math.abs(ax[i]) * bulge;
    const reachY = radius[i] * (1 + MARGIN) + Math.abs(ay[i]) * bulge;
    this.minX[i] = Math.min(x0, x1) - reachX;
    this.minY[i] = Math.min(y0, y1) - reachY;
    this.maxX[i] = Math.max(x0, x1) + reachX;
    this.maxY[i] = Math.max(y0, y1) + reachY;
  }

  overlap(i: number, j: number): boolean {
    const { minX, minY, maxX, maxY } = this;
    return minX[i] <= maxX[j] && minX[j] <= maxX[i] && minY[i] <= maxY[j] && minY[j] <= maxY[i];
  }

  /**
   * Finds each pair of discs whose boxes overlap, and of which one can move, by sweeping along x: the order is that of
   * the step before, put right, which costs little where little has moved. Of equal edges the lower slot comes first.
   * @param pairs - Receives the slots of each pair, the lower one first.
   */
  findPairs(flight: Flight, pairs: Pairs): void {
    const { count, radius, inverseMass } = flight.particles;
    const { minX, minY, maxX, maxY, order } = this;
    this.#sort(count, radius);
    pairs.count = 0;
    for (let k = 0; k < this.orderCount; k++) {
      const i = order[k];
      const right = maxX[i];
      const bottom = minY[i];
      const top = maxY[i];
      for (let l = k + 1; l < this.orderCount && minX[order[l]] <= right; l++) {
        const j = order[l];
        if (minY[j] > top || maxY[j] < bottom || inverseMass[i] + inverseMass[j] === 0) continue;
        pairs.add(Math.min(i, j), Math.max(i, j));
      }
    }
  }

  #sort(count: number, radius: Float64Array): void {
    const { order, minX } = this;
    let discs = 0;
    for (let i = 0; i < count; i++) if (radius[i] > 0) discs++;
    if (!this.#holds(discs, count, radius)) {
      this.orderCount = 0;
      for (let i = 0; i < count; i++) if (radius[i] > 0) order[this.orderCount++] = i;
    }
    for (let k = 1; k < this.orderCount; k++) {
      const i = order[k];
      let l = k - 1;
      for (; l >= 0 && (minX[order[l]] > minX[i] || (minX[order[l]] === minX[i] && order[l] > i)); l--) {
        order[l + 1] = order[l];
      }
      order[l + 1] = i;
    }
  }

  /** Whether the order is of the discs there are. */
  #holds(discs: number, count: number, radius: Float64Array): boolean {
    if (this.orderCount !== discs) return false;
    for (let k = 0; k < discs; k++) if (!(this.order[k] < count && radius[this.order[k]] > 0)) return false;
    return true;
  }

  #resize(capacity: number): void {
    this.minX = new Float64Array(capacity);
    this.minY = new Float64Array(capacity);
    this.maxX = new Float64Array(capacity);
    this.maxY = new Float64Array(capacity);
    this.order = new Int32Array(capacity);
    this.orderCount = 0;
  }
}

/** Pairs of slots. */
export class Pairs {
  count = 0;
  /** Slots `slots[2 * p]` and, higher, `slots[2 * p + 1]`. */
  slots: Int32Array = new Int32Array(128);

  add(i: number, j: number): void {
    if (this.count * 2 === this.slots.length) {
      const slots = new Int32Array(this.slots.length * 2);
      slots.set(this.slots);
      this.slots = slots;
    }
    this.slots[this.count * 2] = i;
    this.slots[this.count * 2 + 1] = j;
    this.count++;
  }
}
