import { describe, requireFinite, requireNonNegative, requireShare } from '../math/checks.ts';
import { growColumns } from '../math/columns.ts';
import type { ContactArrays } from './contact-arrays.ts';
import type { Contacts } from './contacts.ts';
import { SensorTouches } from './sensor-touches.ts';

const FIRST_CAPACITY = 64;

/** The second particle of a contact with immovable scenery. */
export const SCENERY = -1;

/** The end of the edge of a contact whose second is no edge. */
export const NO_EDGE = -1;

/** Some particles: 1 for these, 0 for all others. */
export interface SomeSlots {
  readonly bySlot: Uint8Array;
}

/** The contacts of one step as typed arrays, in the order in which they were found. It grows; nothing is dropped. */
export class ContactBuffer implements Contacts, ContactArrays {
  count = 0;
  /** Slots of the two particles; `b` is `SCENERY` for immovable scenery. */
  a: Int32Array = new Int32Array(FIRST_CAPACITY);
  b: Int32Array = new Int32Array(FIRST_CAPACITY);
  normalX: Float64Array = new Float64Array(FIRST_CAPACITY);
  normalY: Float64Array = new Float64Array(FIRST_CAPACITY);
  penetration: Float64Array = new Float64Array(FIRST_CAPACITY);
  restitution: Float64Array = new Float64Array(FIRST_CAPACITY);
  friction: Float64Array = new Float64Array(FIRST_CAPACITY);
  surfaceSpeed: Float64Array = new Float64Array(FIRST_CAPACITY);
  edgeEnd: Int32Array = new Int32Array(FIRST_CAPACITY);
  edgeShare: Float64Array = new Float64Array(FIRST_CAPACITY);
  /** Sum of the impulses along the normal, written by the resolver. Unit: N·s. */
  impulse: Float64Array = new Float64Array(FIRST_CAPACITY);
  tangentImpulse: Float64Array = new Float64Array(FIRST_CAPACITY);
  /** Where the contact comes from: see `ContactSources.at`. */
  source: Int32Array = new Int32Array(FIRST_CAPACITY);

  /** What touches a sensor. */
  readonly sensors: SensorTouches = new SensorTouches();

  leftOut = 0;
  /** How far ahead generators look. Unit: s. */
  lookAhead = 0;
  /** Those with static shapes are the contacts from the first number to before the second. */
  sceneryStart = 0;
  sceneryEnd = 0;
  /** Those with edges are among the contacts from the first number to before the second. */
  edgesStart = 0;
  edgesEnd = 0;
  /** What is nearer than this is added too: how far a thing at rest may get within that time. Unit: m. */
  margin = 0;
  /** Whether the resolver knows contacts with edges: without, none are looked for. */
  takesEdges = true;
  /** Where it is given, the contacts that there are stay, and more are wanted of these particles alone. */
  only: SomeSlots | undefined;
  /** Grows whenever the linked pairs change. */
  linkVersion = 0;
  /** Written to the contacts that are added: who finds them. */
  currentSource = 0;
  readonly #limit: number;
  #slotCount = 0;
  #linkedPairs: ReadonlySet<number> = new Set();

  /** @param limit - The most contacts that a step may have; what comes after is counted in `leftOut`. */
  constructor(limit: number) {
    this.#limit = limit;
  }

  /**
   * Forgets all contacts.
   * @param slotCount - How many slots the particles have: those that generators name must be below.
   * @param linkedPairs - Pairs of slots that a link joins, as `pairKey`.
   */
  clear(slotCount: number, linkedPairs: ReadonlySet<number>): void {
    this.count = 0;
    this.edgesStart = 0;
    this.edgesEnd = 0;
    this.leftOut = 0;
    this.sensors.count = 0;
    this.#slotCount = slotCount;
    this.#linkedPairs = linkedPairs;
  }

  add(
    a: number,
    b: number,
    normalX: number,
    normalY: number,
    penetration: number,
    restitution: number,
    friction = 0,
    surfaceSpeed = 0,
  ): void {
    this.#requireSlots(a, b);
    const before = this.count;
    this.push(a, b, normalX, normalY, penetration, restitution, friction, surfaceSpeed);
    if (this.count > before) this.#requireSound(before);
  }

  /** `add` without the checks, for our own generators. */
  push(
    a: number,
    b: number,
    normalX: number,
    normalY: number,
    penetration: number,
    restitution: number,
    friction = 0,
    surfaceSpeed = 0,
  ): void {
    if (this.count >= this.#limit) {
      this.leftOut++;
      return;
    }
    if (this.count === this.a.length) growColumns(this, this.count * 2);
    const c = this.count++;
    this.a[c] = a;
    this.b[c] = b;
    this.normalX[c] = normalX;
    this.normalY[c] = normalY;
    this.penetration[c] = penetration;
    this.restitution[c] = restitution;
    this.friction[c] = friction;
    this.surfaceSpeed[c] = surfaceSpeed;
    this.edgeEnd[c] = NO_EDGE;
    this.impulse[c] = 0;
    this.tangentImpulse[c] = 0;
    this.source[c] = this.currentSource;
  }

  /**
   * Makes the contact that was added last one with an edge, from its second particle to another.
   * @param end - Slot of the other.
   * @param share - Where on the edge, 0 at the second particle and 1 at the other.
   */
  makeEdge(end: number, share: number): void {
    if (this.leftOut > 0) return; // that contact was left out
    const c = this.count - 1;
    this.edgeEnd[c] = end;
    this.edgeShare[c] = share;
    if (this.edgesEnd === 0) this.edgesStart = c;
    this.edgesEnd = c + 1;
  }

  /** Makes room for more. Returns for how many there is room at the end: the limit is kept. */
  reserve(more: number): number {
    let capacity = this.a.length;
    while (capacity < this.count + more) capacity *= 2;
    if (capacity > this.a.length) growColumns(this, capacity);
    return Math.min(capacity, this.#limit);
  }

  /** Ends the writing of contacts of two particles straight into the arrays, up to a new count. */
  finish(count: number): void {
    this.surfaceSpeed.fill(0, this.count, count);
    this.edgeEnd.fill(NO_EDGE, this.count, count);
    this.impulse.fill(0, this.count, count);
    this.tangentImpulse.fill(0, this.count, count);
    this.source.fill(this.currentSource, this.count, count);
    this.count = count;
  }

  addSensor(a: number, b: number, normalX: number, normalY: number): void {
    this.sensors.add(a, b, normalX, normalY, this.currentSource);
  }

  areLinked(a: number, b: number): boolean {
    return this.#linkedPairs.size > 0 && this.#linkedPairs.has(pairKey(a, b));
  }

  #requireSlots(a: number, b: number): void {
    if (!(Number.isInteger(a) && a >= 0 && a < this.#slotCount)) {
      throw new RangeError(`Contacts.add: a must be the slot of a particle; got ${describe(a)}.`);
    }
    if (!(Number.isInteger(b) && b >= SCENERY && b < this.#slotCount && b !== a)) {
      throw new RangeError(
        `Contacts.add: b must be the slot of another particle, or -1 for scenery; got ${describe(b)}.`,
      );
    }
  }

  /** Checks what stands in the arrays: numbers handed to a function that is not inlined would be garbage. */
  #requireSound(c: number): void {
    const penetration = this.penetration[c];
    const restitution = this.restitution[c];
    const friction = this.friction[c];
    const surfaceSpeed = this.surfaceSpeed[c];
    const nx = this.normalX[c];
    const ny = this.normalY[c];
    if (
      Math.abs(nx * nx + ny * ny - 1) < 1e-6 &&
      penetration - penetration === 0 &&
      restitution >= 0 &&
      restitution <= 1 &&
      friction >= 0 &&
      friction < Infinity &&
      surfaceSpeed - surfaceSpeed === 0
    ) {
      return;
    }
    this.count--;
    requireUnitNormal('Contacts.add', nx, ny);
    requireFinite('Contacts.add', 'penetration', penetration, 'metres');
    requireShare('Contacts.add', 'restitution', restitution);
    requireNonNegative('Contacts.add', 'friction', friction, '');
    requireFinite('Contacts.add', 'surfaceSpeed', surfaceSpeed, 'metres per second');
  }
}

/** Where on an edge a contact lies, 0 at the second particle; 0 also where there is no edge. */
export function shareOf({ edgeEnd, edgeShare }: ContactBuffer, r: number): number {
  return edgeEnd[r] === NO_EDGE ? 0 : edgeShare[r];
}

/** A normal of length 1. */
export function requireUnitNormal(where: string, normalX: number, normalY: number): void {
  if (Math.abs(normalX * normalX + normalY * normalY - 1) < 1e-6) return;
  throw new RangeError(
    `${where}: the normal must have length 1; got (${normalX}, ${normalY}). Divide it by its length.`,
  );
}

/** One number for a pair of slots, whatever their order. */
export function pairKey(a: number, b: number): number {
  return a < b ? a * 0x400_0000 + b : b * 0x400_0000 + a;
}
