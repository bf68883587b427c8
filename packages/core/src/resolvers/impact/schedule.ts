import { mayPush, mayPushShape } from '../../collision/filter.ts';
import type { Shape } from '../../collision/shape.ts';
import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import { LeastTree, leastLeaf, setLeaf } from '../severity/least-tree.ts';
import { Boxes, Pairs } from './boxes.ts';
import { DiscPath } from './disc-path.ts';
import type { Flight } from './flight.ts';
import { ShapePath } from './shape-path.ts';

/** No partner. */
const NOBODY = 0x7fff_ffff;

/**
 * Who touches whom next. Each particle keeps its own next touch alone, with the partner's count of turns at the time, which
 * tells whether the partner's way has changed since; the earliest of all is found by a tree (M. Marín, D. Risso,
 * P. Cordero, *Efficient algorithms for many-body hard particle molecular dynamics*, 1993). At one time the lowest slot comes
 * first, and for it the partner of the lowest slot, then the shapes in order of addition.
 */
export class Schedule {
  readonly boxes: Boxes = new Boxes();
  readonly pairs: Pairs = new Pairs();
  readonly #flight: Flight;
  readonly #discPath: DiscPath;
  readonly #shapePath: ShapePath;
  readonly #tree = new LeastTree();
  /** When each particle touches next, or `Infinity`. Unit: s since the step began. */
  #times = new Float64Array(0);
  /** Slot of the partner, or `~index` of a shape, or `NOBODY`. */
  #partner = new Int32Array(0);
  #partnerTurns = new Int32Array(0);
  #shapes: readonly Shape[] = [];
  #contacts!: ContactBuffer;
  #discsCollide = false;

  constructor(flight: Flight) {
    this.#flight = flight;
    this.#discPath = new DiscPath(flight);
    this.#shapePath = new ShapePath(flight);
  }

  /** Takes note of what there is to hit. */
  begin(shapes: readonly Shape[], contacts: ContactBuffer, discsCollide: boolean): void {
    const { capacity } = this.#flight.particles;
    this.#shapes = shapes;
    this.#contacts = contacts;
    this.#discsCollide = discsCollide;
    if (this.#partner.length !== capacity) {
      this.#times = new Float64Array(capacity);
      this.#partner = new Int32Array(capacity);
      this.#partnerTurns = new Int32Array(capacity);
    }
  }

  /** Finds the pairs that are near on their ways. */
  findPairs(): void {
    this.boxes.begin(this.#flight);
    this.pairs.count = 0;
    if (this.#discsCollide) this.boxes.findPairs(this.#flight, this.pairs);
  }

  /** Predicts the first touch of all. Reads the flight. Writes the schedule. */
  predictAll(): void {
    const { count, inverseMass } = this.#flight.particles;
    for (let i = 0; i < count; i++) {
      this.#times[i] = Infinity;
      this.#partner[i] = NOBODY;
    }
    for (let p = 0; p < this.pairs.count; p++) {
      const i = this.pairs.slots[p * 2];
      const j = this.pairs.slots[p * 2 + 1];
      if (this.#contacts.areLinked(i, j) || !mayPush(this.#flight.particles, i, j)) continue;
      const time = this.#discPath.findTouch(i, j, 0);
      this.#note(i, j, time);
      this.#note(j, i, time);
    }
    for (let i = 0; i < count; i++) if (inverseMass[i] !== 0) this.#predictShapes(i, 0);
    this.#tree.resize(count);
    for (let i = 0; i < count; i++) this.#tree.nodes[this.#tree.leaves + i] = this.#times[i];
    this.#tree.build();
  }

  /** The particle that touches next. */
  get next(): number {
    return leastLeaf(this.#tree.nodes, this.#tree.leaves) - this.#tree.leaves;
  }

  /** When a particle touches next, or `Infinity`. Unit: s since the step began. */
  timeOf(i: number): number {
    return this.#times[i];
  }

  /** Whom a particle touches next: the slot, or `~index` of a shape. */
  partnerOf(i: number): number {
    return this.#partner[i];
  }

  /** Whether the partner's way is still the one that was predicted. */
  isCurrent(i: number): boolean {
    const partner = this.#partner[i];
    return partner < 0 || this.#partnerTurns[i] === this.#flight.turns[partner];
  }

  /** Notes that the way of a particle changed. Reads the flight. Writes its box and its count of turns. */
  turn(i: number, now: number): void {
    this.#flight.turns[i]++;
    this.boxes.update(this.#flight, i, now);
  }

  /** Predicts a particle anew, against all. Reads the flight. Writes the schedule, also of those that it now touches first. */
  predict(i: number, now: number): void {
    const { boxes } = this;
    const { count, radius, inverseMass } = this.#flight.particles;
    this.#times[i] = Infinity;
    this.#partner[i] = NOBODY;
    const collides = this.#discsCollide && radius[i] > 0;
    for (let j = 0; collides && j < count; j++) {
      if (!boxes.overlap(i, j) || i === j || radius[j] === 0 || inverseMass[i] + inverseMass[j] === 0) continue;
      if (this.#contacts.areLinked(i, j) || !mayPush(this.#flight.particles, i, j)) continue;
      const time = now + this.#discPath.findTouch(i, j, now);
      this.#note(i, j, time);
      if (this.#note(j, i, time)) this.#update(j);
    }
    if (inverseMass[i] !== 0) this.#predictShapes(i, now);
    this.#update(i);
  }

  #predictShapes(i: number, now: number): void {
    const shapes = this.#shapes;
    const { minX, minY, maxX, maxY } = this.boxes;
    for (let s = 0; s < shapes.length; s++) {
      const shape = shapes[s];
      if (minX[i] > shape.maxX || maxX[i] < shape.minX || minY[i] > shape.maxY || maxY[i] < shape.minY) continue;
      if (!mayPushShape(this.#flight.particles, i, shape)) continue;
      this.#note(i, ~s, now + this.#shapePath.findTouch(i, shape, now));
    }
  }

  #update(i: number): void {
    setLeaf(this.#tree.nodes, this.#tree.leaves + i, this.#times[i]);
  }

  /** Keeps a touch if it is a particle's first. */
  #note(i: number, partner: number, time: number): boolean {
    const times = this.#times;
    if (!(time < times[i] || (time === times[i] && time < Infinity && rank(partner) < rank(this.#partner[i]))))
      return false;
    times[i] = time;
    this.#partner[i] = partner;
    if (partner >= 0) this.#partnerTurns[i] = this.#flight.turns[partner];
    return true;
  }
}

function rank(partner: number): number {
  return partner >= 0 ? partner : 0x4000_0000 + ~partner;
}
