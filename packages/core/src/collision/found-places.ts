import { growColumns } from '../math/columns.ts';
import type { SurfaceReport } from './surface-report.ts';

/** A place that lies this near to the plane of another is no corner but a joint of a floor, as a share of the radius. */
const JOINT = 1e-4;

/** Two places as near as this are one. */
const SAME = 1e-9;

/** The places of static shapes that particles touch, or may soon, particle by particle. */
export class FoundPlaces implements SurfaceReport {
  count = 0;
  /** The particle and the shape whose places are added. */
  particle = 0;
  shape = 0;
  slot: Int32Array = new Int32Array(64);
  /** Number of the shape, or below 0 where a place was taken out. */
  shapes: Int32Array = new Int32Array(64);
  distance: Float64Array = new Float64Array(64);
  normalX: Float64Array = new Float64Array(64);
  normalY: Float64Array = new Float64Array(64);
  /** Radius that the particle counts with. Unit: m. */
  radius: Float64Array = new Float64Array(64);
  /** Share of the restitution that counts: what is met after a turn is hit with another speed than the way began with. */
  bounce: Float64Array = new Float64Array(64);
  /** The places in the order of the shapes, of each in the order of the slots. */
  order: Int32Array = new Int32Array(64);
  #firsts = new Int32Array(0);
  #radius = 0;
  #start = 0;

  /** Begins with the next particle. */
  begin(particle: number): void {
    this.particle = particle;
    this.#start = this.count;
  }

  /** Where the places of this particle start. */
  get start(): number {
    return this.#start;
  }

  /** Says of which shape the next places are, and with which radius the particle counts there. */
  of(shape: number, radius: number): void {
    this.shape = shape;
    this.#radius = radius;
  }

  /** Adds a place. */
  push(distance: number, normalX: number, normalY: number, bounce = 1): void {
    if (this.count === this.slot.length) growColumns(this, this.count * 2);
    const p = this.count++;
    this.slot[p] = this.particle;
    this.shapes[p] = this.shape;
    this.distance[p] = distance;
    this.normalX[p] = normalX;
    this.normalY[p] = normalY;
    this.radius[p] = this.#radius;
    this.bounce[p] = bounce;
  }

  /** Adds a place unless the particle has it already. */
  add(distance: number, normalX: number, normalY: number, bounce = 1): void {
    for (let p = this.#start; p < this.count; p++) {
      const isSame =
        Math.abs(this.distance[p] - distance) +
          Math.abs(this.normalX[p] - normalX) +
          Math.abs(this.normalY[p] - normalY) <
        SAME;
      if (isSame) return;
    }
    this.push(distance, normalX, normalY, bounce);
  }

  /** Takes out the places of this particle that are only the corners of shapes whose flats join: of two the nearer stays. */
  dropJoints(): void {
    const { distance, normalX, normalY, shapes, radius } = this;
    for (let p = this.#start; p < this.count; p++) {
      for (let q = this.#start; q < this.count; q++) {
        if (q === p || shapes[q] < 0 || distance[p] < distance[q] || (distance[p] === distance[q] && p < q)) continue;
        const cosine = normalX[p] * normalX[q] + normalY[p] * normalY[q];
        if (!(Math.abs(distance[q] - distance[p] * cosine) < JOINT * radius[p])) continue;
        shapes[p] = -1;
        break;
      }
    }
  }

  /** Sorts the places by their shapes. @returns How many there are in `order`. */
  sort(shapeCount: number): number {
    if (this.#firsts.length <= shapeCount) this.#firsts = new Int32Array(shapeCount * 2 + 1);
    const firsts = this.#firsts;
    firsts.fill(0, 0, shapeCount + 1);
    for (let p = 0; p < this.count; p++) if (this.shapes[p] >= 0) firsts[this.shapes[p] + 1]++;
    for (let s = 0; s < shapeCount; s++) firsts[s + 1] += firsts[s];
    const total = firsts[shapeCount];
    for (let p = 0; p < this.count; p++) if (this.shapes[p] >= 0) this.order[firsts[this.shapes[p]]++] = p;
    return total;
  }
}
