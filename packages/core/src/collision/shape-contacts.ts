import { type ContactBuffer, requireUnitNormal, SCENERY } from '../contacts/contact-buffer.ts';
import type { ContactKeeper } from '../contacts/contact-keeper.ts';
import { contactKeeper } from '../contacts/solver/make-keeper.ts';
import { requireFinite } from '../math/checks.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { FRONT_SHARE } from './edges.ts';
import { mayTouchShape } from './filter.ts';
import { FoundPlaces } from './found-places.ts';
import { keepInFront } from './keep-in-front.ts';
import type { Places, Shape, ShapeFinder, ShapeWalk } from './shape.ts';
import { ShapeIndex } from './shape-index.ts';
import { POINT_RADIUS, radiusAt, ShapeWay } from './shape-way.ts';
import type { SurfaceReport } from './surface-report.ts';
import { SEAM } from './sweep.ts';

/** Contacts are reported when the gap is below this share of the radius: a little early, so that rest is quiet. */
export const EARLY_SHARE = 0.01;

/** A particle that goes farther than this share of its radius within the time looked ahead is followed on its way. */
const FAST_SHARE = 0.125;

/** How far around a particle that is near something is looked, in terms of how far it reaches; what is far from all looks farther. */
const ROOM = 1.25;

/**
 * Finds the contacts of particles with scenery. Of each particle it is kept how far off everything was when it was last looked
 * at: until it has gone so far nothing can touch it. So only what is near scenery costs more than a glance.
 */
export class ShapeContacts implements ShapeFinder, SurfaceReport {
  walk: ShapeWalk | undefined;
  readonly keeper: () => ContactKeeper = contactKeeper;
  readonly #index = new ShapeIndex();
  readonly #places = new FoundPlaces();
  readonly #way = new ShapeWay(this.#index, this.#places);
  #contacts!: ContactBuffer;
  #shapes: readonly Shape[] = [];
  /** Where each particle was looked at, how far off scenery was at least, and whether it stood on what is solid from one side. */
  #x = new Float64Array(0);
  #y = new Float64Array(0);
  #free = new Float64Array(0);
  #held = new Uint8Array(0);
  // Of the particle that is looked at, and of one shape:
  #slot = 0;
  #wasHeld = false;
  #isHeld = false;
  #isFast = false;
  #isSensor = false;
  #radius = 0;
  #mayTouch = false;
  /** How far off scenery is. Unit: m. */
  #distance = 0;
  /** The way in the time looked ahead; where the world does not look ahead, the way that it came by. Unit: m. */
  #wayX = 0;
  #wayY = 0;

  /**
   * Reads x, y, vx, vy, radius, inverseMass, restitution, friction, category, mask, sensor, asleep. Adds the contacts of all movable
   * particles that are awake, shape by shape, and what sensors find.
   * @param firstSource - Number of the first shape among the sources of contacts.
   * @param sensorsAlone - Leaves the contacts out.
   */
  find(
    shapes: readonly Shape[],
    firstSource: number,
    particles: ParticleArrays,
    contacts: ContactBuffer,
    dt: number,
    sensorsAlone = false,
  ): void {
    const { count, x, y, vx, vy, radius, inverseMass, asleep } = particles;
    const { lookAhead, margin, only } = contacts;
    if (shapes.length === 0) return;
    this.#prepare(shapes, count, contacts);
    this.#way.begin(shapes, firstSource, particles, contacts, this.walk);
    const lookX = this.#x;
    const lookY = this.#y;
    const free = this.#free;
    for (let i = 0; i < count; i++) {
      if (only !== undefined && only.bySlot[i] === 0) continue;
      const gone = Math.abs(x[i] - lookX[i]) + Math.abs(y[i] - lookY[i]);
      const way = (Math.abs(vx[i]) + Math.abs(vy[i])) * lookAhead + margin;
      const reach = radius[i] * (1 + EARLY_SHARE) + way + POINT_RADIUS;
      if (gone + reach < free[i] || inverseMass[i] === 0 || asleep[i] === 1) continue;
      const around = free[i] > reach ? free[i] * 2 : reach * ROOM;
      this.#look(i, around, firstSource, particles, dt);
    }
    if (!sensorsAlone) this.#report(firstSource, particles);
  }

  keepInFront(shapes: readonly Shape[], particles: ParticleArrays, before: Places): void {
    keepInFront(shapes, particles, before);
  }

  add(distance: number, normalX: number, normalY: number): void {
    requireFinite('SurfaceReport.add', 'distance', distance, 'metres');
    requireUnitNormal('SurfaceReport.add', normalX, normalY);
    this.#distance = Math.min(this.#distance, distance);
    if (!this.#mayTouch) return;
    const { lookAhead, margin } = this.#contacts;
    const radius = this.#radius;
    const way = this.#wayX * normalX + this.#wayY * normalY;
    let isNear = distance < radius * (1 + EARLY_SHARE);
    if (lookAhead > 0)
      isNear ||= this.#isFast ? distance < radius + SEAM : distance + Math.min(0, way) < radius + margin;
    if (!isNear) return;
    const shape = this.#shapes[this.#places.shape];
    if (shape.oneSided) {
      const before = lookAhead > 0 ? distance : distance - way;
      if (before < radius * (1 - FRONT_SHARE) && !this.#wasHeld) return;
      this.#isHeld = true;
    }
    if (!(this.#isSensor || shape.sensor)) this.#places.push(distance, normalX, normalY);
    else if (distance < radius) this.#contacts.addSensor(this.#slot, SCENERY, normalX, normalY);
  }

  #prepare(shapes: readonly Shape[], count: number, contacts: ContactBuffer): void {
    if (this.#free.length < count) {
      this.#x = new Float64Array(count * 2);
      this.#y = new Float64Array(count * 2);
      this.#free = new Float64Array(count * 2);
      this.#held = new Uint8Array(count * 2);
    }
    if (this.#index.update(shapes)) this.#free.fill(0);
    this.#shapes = shapes;
    this.#contacts = contacts;
    this.#places.count = 0;
  }

  /** Looks at all shapes within `around` of a particle. Writes places, sensors, and how far off scenery is. */
  #look(i: number, around: number, firstSource: number, particles: ParticleArrays, dt: number): void {
    const { x, y, vx, vy, radius, sensor } = particles;
    const { lookAhead, margin } = this.#contacts;
    const time = lookAhead > 0 ? lookAhead : dt;
    const found = this.#index.find(x[i], y[i], around);
    this.#wayX = vx[i] * time;
    this.#wayY = vy[i] * time;
    this.#slot = i;
    this.#isSensor = sensor[i] === 1;
    this.#isFast = (Math.abs(vx[i]) + Math.abs(vy[i])) * lookAhead > radius[i] * FAST_SHARE + margin;
    this.#wasHeld = this.#held[i] === 1;
    this.#isHeld = false;
    this.#distance = around;
    this.#places.begin(i);
    for (let f = 0; f < found; f++) {
      const s = this.#index.at(f);
      const shape = this.#shapes[s];
      this.#radius = lookAhead > 0 ? radiusAt(shape, radius[i]) : radius[i];
      this.#mayTouch = mayTouchShape(particles, i, shape);
      this.#contacts.currentSource = firstSource + s;
      this.#places.of(s, this.#radius);
      shape.findSurface(x[i], y[i], around, this);
      if (shape.oneSided) this.#distance = 0; // what lies behind it is not told
    }
    this.#x[i] = x[i];
    this.#y[i] = y[i];
    this.#free[i] = this.#distance;
    this.#held[i] = this.#isHeld ? 1 : 0;
    if (lookAhead === 0) return;
    this.#places.dropJoints();
    if (this.#isFast && !this.#isSensor) this.#way.follow(i, found, this.#wasHeld);
  }

  /** Hands the places over as contacts, shape by shape. */
  #report(firstSource: number, { restitution, friction }: ParticleArrays): void {
    const contacts = this.#contacts;
    const { slot, shapes, radius, distance, normalX, normalY, bounce } = this.#places;
    const count = this.#places.sort(this.#shapes.length);
    const { order } = this.#places;
    for (let n = 0; n < count; n++) {
      const p = order[n];
      const i = slot[p];
      const shape = this.#shapes[shapes[p]];
      const mu = Math.sqrt(friction[i] * (shape.friction ?? 0));
      const e = Math.max(restitution[i], shape.restitution) * bounce[p];
      contacts.currentSource = firstSource + shapes[p];
      contacts.push(i, SCENERY, normalX[p], normalY[p], radius[p] - distance[p], e, mu, shape.surfaceSpeed ?? 0);
    }
  }
}
