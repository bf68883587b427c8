import { type ContactBuffer, SCENERY } from '../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { mayTouchShape } from './filter.ts';
import type { FoundPlaces } from './found-places.ts';
import type { Shape, ShapeWalk } from './shape.ts';
import type { ShapeIndex } from './shape-index.ts';
import { Sweep } from './sweep.ts';

/** Where the world looks ahead a point keeps this far off walls without thickness: so it has a side. Unit: m. */
export const POINT_RADIUS = 0.001;

/** How often a way is followed around what it met; where it goes on after that, it ends. */
const MOST_TURNS = 64;

/** A plane that the particle is behind of by more than this share of its radius, as the way begins, is not in front of it. */
const BEHIND_SHARE = 0.1;

/** A way shorter than this leads nowhere. Unit: m. */
const SHORTEST = 1e-12;

/** Steps in which a shape without `sweep` is walked up to, at the most. */
const MOST_STEPS = 256;

/**
 * Follows a fast particle along its way in the coming step: straight to what it meets first, along that to what it meets next, and so
 * on. Each place that it meets is a plane which it may come up to and not pass.
 */
export class ShapeWay {
  readonly #index: ShapeIndex;
  readonly #places: FoundPlaces;
  readonly #sweep = new Sweep();
  readonly #probe: Sweep;
  #walk: ShapeWalk | undefined;
  #shapes: readonly Shape[] = [];
  #firstSource = 0;
  #particles!: ParticleArrays;
  #contacts!: ContactBuffer;
  #dx = 0;
  #dy = 0;

  constructor(index: ShapeIndex, places: FoundPlaces) {
    this.#index = index;
    this.#places = places;
    this.#probe = new Sweep(places);
  }

  /**
   * Begins a step.
   * @param firstSource - Number of the first shape among the sources of contacts.
   * @param walk - For shapes without `sweep`.
   */
  begin(
    shapes: readonly Shape[],
    firstSource: number,
    particles: ParticleArrays,
    contacts: ContactBuffer,
    walk: ShapeWalk | undefined,
  ): void {
    this.#walk = walk;
    this.#shapes = shapes;
    this.#firstSource = firstSource;
    this.#particles = particles;
    this.#contacts = contacts;
  }

  /**
   * Reads x, y, vx, vy, radius, and the places where the particle touches already. Adds places, and the sensors that it passes.
   * @param found - How many shapes are near: see the index.
   * @param held - Whether it stands on what is solid from one side.
   */
  follow(i: number, found: number, held: boolean): void {
    const { x, y, vx, vy, radius } = this.#particles;
    const { lookAhead } = this.#contacts;
    const sweep = this.#sweep;
    sweep.held = held;
    this.#dx = vx[i] * lookAhead;
    this.#dy = vy[i] * lookAhead;
    this.#slideOnTouched(x[i], y[i]);
    let px = x[i];
    let py = y[i];
    let left = lookAhead;
    for (let turn = 0; ; turn++) {
      sweep.begin(px, py, this.#dx, this.#dy, 0);
      if (sweep.length < SHORTEST) return;
      const hit = this.#meetFirst(i, found);
      if (turn === 0) this.#tellPassed(i, found);
      if (hit < 0) return;
      const { time, normalX, normalY } = sweep;
      const distance = sweep.distance + (x[i] - px) * normalX + (y[i] - py) * normalY;
      const hitRadius = radiusAt(this.#shapes[hit], radius[i]);
      this.#places.of(hit, hitRadius);
      px += this.#dx * time;
      py += this.#dy * time;
      // A plane across the way, where it ends. No plane may push the particle now, before it comes there.
      const acrossX = -this.#dx / sweep.length;
      const acrossY = -this.#dy / sweep.length;
      const across = hitRadius + (x[i] - px) * acrossX + (y[i] - py) * acrossY;
      if (turn === MOST_TURNS || distance < hitRadius * (1 - BEHIND_SHARE)) {
        this.#places.add(across, acrossX, acrossY, 0);
        return;
      }
      const closing = this.#dx * normalX + this.#dy * normalY;
      const atFirst = (vx[i] * normalX + vy[i] * normalY) * left;
      this.#places.add(distance, normalX, normalY, atFirst < 0 ? Math.min(1, Math.max(0, closing / atFirst)) : 0);
      left *= 1 - time;
      this.#dx *= 1 - time;
      this.#dy *= 1 - time;
      this.#slideOn(normalX, normalY, x[i] * normalX + y[i] * normalY - distance);
      if (!sweep.isBlocked(px, py, this.#dx, this.#dy)) continue;
      this.#places.add(across, acrossX, acrossY, 0); // two planes at a narrow angle hold it, but a third holds it sooner
      return;
    }
  }

  /** The way leads along what the particle touches. */
  #slideOnTouched(x: number, y: number): void {
    const { normalX, normalY, distance, start, count } = this.#places;
    this.#sweep.clearFloors();
    for (let p = start; p < count; p++) {
      this.#slideOn(normalX[p], normalY[p], x * normalX[p] + y * normalY[p] - distance[p]);
    }
  }

  /** The way leads along a plane, no more into it. */
  #slideOn(normalX: number, normalY: number, offset: number): void {
    this.#sweep.addFloor(normalX, normalY, offset);
    const into = Math.min(0, this.#dx * normalX + this.#dy * normalY);
    this.#dx -= into * normalX;
    this.#dy -= into * normalY;
  }

  /** The number of the shape that is met first on the way, or -1. */
  #meetFirst(i: number, found: number): number {
    const sweep = this.#sweep;
    let hit = -1;
    for (let f = 0; f < found; f++) {
      const s = this.#index.at(f);
      if (this.#shapes[s].sensor) continue;
      const before = sweep.time;
      this.#tell(sweep, s, i);
      if (sweep.time < before) hit = s;
    }
    return hit;
  }

  /** Tells of sensors on the way, and of what is passed by narrowly, up to what is met first. */
  #tellPassed(i: number, found: number): void {
    const { x, y, dx, dy, time } = this.#sweep;
    const share = Math.min(1, time);
    const probe = this.#probe;
    for (let f = 0; f < found; f++) {
      const s = this.#index.at(f);
      const { sensor } = this.#shapes[s];
      probe.begin(x, y, dx * share, dy * share, sensor ? 0 : this.#contacts.margin);
      this.#tell(probe, s, i);
      if (!sensor || probe.time > 1) continue;
      this.#contacts.currentSource = this.#firstSource + s;
      this.#contacts.addSensor(i, SCENERY, probe.normalX, probe.normalY);
    }
  }

  /** Has a shape, if the particle may touch it, tell what is on the way. */
  #tell(sweep: Sweep, s: number, i: number): void {
    const shape = this.#shapes[s];
    if (!mayTouchShape(this.#particles, i, shape)) return;
    sweep.radius = radiusAt(shape, this.#particles.radius[i]);
    this.#places.of(s, sweep.radius);
    if (shape.sweep) shape.sweep(sweep);
    else this.#walk?.meet(shape, sweep, Math.max(sweep.radius / 2, sweep.length / MOST_STEPS));
  }
}

/** The radius that a particle counts with at a shape where the world looks ahead. Unit: m. */
export function radiusAt({ thickness }: Shape, radius: number): number {
  return radius === 0 && thickness === 0 ? POINT_RADIUS : radius;
}
