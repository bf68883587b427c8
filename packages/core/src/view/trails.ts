import { trailLevels } from './paint.ts';
import type { Palette } from './palette.ts';
import type { ViewedWorld } from './viewed-world.ts';

const mostPoints = 240;

/**
 * Where particles have been: a ring of past positions a slot, sampled by the time of the world, all slots at once. A slot
 * that passes to another particle starts anew; so does everything when the time goes back or the world is another one.
 * Segment k of a trail leads from point k - 1 to point k, point 0 being the newest and point -1 where the particle is drawn.
 * For authors of renderers.
 */
export class Trails {
  /** Points a slot. */
  readonly capacity: number;
  /** Past positions, `slot * capacity + ring`. Unit: m. */
  x: Float32Array = new Float32Array(0);
  y: Float32Array = new Float32Array(0);
  /** How many points each slot has. */
  length: Uint16Array = new Uint16Array(0);
  /**
   * Per class, `trailLevels + 1` numbers: the segments at level l are those from `ranges[l]` on and before `ranges[l + 1]`.
   * Newer segments have lower levels.
   */
  readonly ranges: Uint16Array;
  /** The place of the newest point in the ring. Point k is at `(head - k + capacity) % capacity`. */
  head = 0;
  readonly #palette: Palette;
  readonly #interval: number;
  #times: Float64Array;
  #generations = new Uint32Array(0);
  #world: ViewedWorld | null = null;
  #time = 0;
  #samples = 0;

  constructor(palette: Palette) {
    let interval = Infinity;
    let longest = 0;
    for (const trail of palette.trails) {
      if (trail === null) continue;
      interval = Math.min(interval, trail.seconds / trail.points);
      longest = Math.max(longest, trail.seconds);
    }
    this.#palette = palette;
    this.capacity = longest > 0 ? Math.min(mostPoints, Math.ceil(longest / interval) + 1) : 1;
    this.#interval = Math.max(interval, longest / mostPoints);
    this.#times = new Float64Array(this.capacity);
    this.ranges = new Uint16Array(palette.trails.length * (trailLevels + 1));
  }

  /** Trails under another palette, with the positions so far where they fit it. */
  withPalette(palette: Palette): Trails {
    const next = new Trails(palette);
    if (next.capacity !== this.capacity || next.#interval !== this.#interval) return next;
    next.x = this.x;
    next.y = this.y;
    next.length = this.length;
    next.head = this.head;
    next.#times = this.#times;
    next.#generations = this.#generations;
    next.#world = this.#world;
    next.#time = this.#time;
    next.#samples = this.#samples;
    return next;
  }

  /** Forgets every position. */
  clear(): void {
    this.length.fill(0);
    this.#samples = 0;
  }

  /** Takes a sample when one is due. Call it once a frame. */
  update(world: ViewedWorld): void {
    if (world !== this.#world || world.time < this.#time) this.clear();
    this.#world = world;
    this.#time = world.time;
    this.#reserve(world.particles.count);
    this.#forgetReused(world);
    const last = this.#times[this.head];
    // A hair early rather than a frame late: steps of 1/60 s do not add up to 1/30 s exactly.
    if (this.#samples === 0 || world.time - last >= this.#interval * 0.999) this.#sample(world);
    this.#level(world.time);
  }

  #reserve(slots: number): void {
    if (this.length.length >= slots) return;
    const size = Math.max(64, Math.ceil(slots * 1.5));
    const { x, y, length } = this;
    this.x = new Float32Array(size * this.capacity);
    this.y = new Float32Array(size * this.capacity);
    this.length = new Uint16Array(size);
    this.x.set(x);
    this.y.set(y);
    this.length.set(length);
    const generations = this.#generations;
    this.#generations = new Uint32Array(size);
    this.#generations.set(generations);
  }

  #forgetReused(world: ViewedWorld): void {
    const { length } = this;
    const generations = this.#generations;
    const { count, alive } = world.particles;
    for (let i = 0; i < count; i++) {
      const generation = world.generationAt(i);
      if (alive[i] === 1 && generations[i] === generation) continue;
      generations[i] = generation;
      length[i] = 0;
    }
    length.fill(0, count);
  }

  /** The previous positions, not the present ones: what is drawn lies between the two, and a trail must not run ahead of it. */
  #sample(world: ViewedWorld): void {
    const { capacity, x, y, length } = this;
    const { count, alive, group, previousX, previousY } = world.particles;
    const palette = this.#palette;
    this.head = (this.head + 1) % capacity;
    this.#times[this.head] = world.time;
    this.#samples = Math.min(this.#samples + 1, capacity);
    for (let i = 0; i < count; i++) {
      if (alive[i] === 0 || palette.trails[palette.classOf(group[i])] === null) continue;
      const at = i * capacity + this.head;
      x[at] = previousX[i];
      y[at] = previousY[i];
      if (length[i] < capacity) length[i]++;
    }
  }

  /** By the age of the newer end of each segment: which level it is drawn at. All slots share the times. */
  #level(time: number): void {
    const { ranges, capacity, head } = this;
    const { trails } = this.#palette;
    for (let c = 0; c < trails.length; c++) {
      const trail = trails[c];
      if (trail === null) continue;
      const first = c * (trailLevels + 1);
      let k = 0;
      for (let level = 0; level <= trailLevels; level++) {
        ranges[first + level] = k;
        const until = (trail.seconds * (level + 1)) / trailLevels;
        while (level < trailLevels && k < this.#samples && this.#age(k, time, head, capacity) < until) k++;
      }
    }
  }

  #age(k: number, time: number, head: number, capacity: number): number {
    return k === 0 ? 0 : time - this.#times[(head - k + 1 + capacity) % capacity];
  }
}
