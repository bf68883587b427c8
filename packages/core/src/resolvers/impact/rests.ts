import { SCENERY } from '../../contacts/contact-buffer.ts';
import { Cluster } from './cluster.ts';
import { Complementarity, takeAway } from './complementarity.ts';
import type { Flight } from './flight.ts';
import { CLOSING_EPSILON } from './tolerance.ts';
import type { Touches } from './touches.ts';

/** The most that counts as still, of a velocity and of an acceleration. Unit: m/s, m/s². */
const STILL_VELOCITY = 1e-10;
const STILL_ACCELERATION = 1e-7;

/**
 * Most looks at a touch in a step, to find what comes to rest and what supports it: about a millisecond. Enough for all that
 * may happen to thirty discs at rest; with more it is a crowd.
 */
const MOST_WORK = 100_000;

/** In a crowd the support is found anew this many times in a step. */
const LATE_RELIEFS = 4;

/** Impacts of one particle in one step that are nothing unusual. */
const FEW = 8;

/**
 * What rests on what. Two things come to rest on each other when they touch no faster than the acceleration of one step
 * makes them. From then on, for all that hangs together there at once, velocities and accelerations are such that none of
 * these is in another as the step ends. So a pile at rest costs no impacts, and what slides does so on exact parabolas.
 *
 * In a crowd, a step in which too much happens, what comes to rest has to wait for its end: slow as it is, it may sink in until
 * then, and all is stilled and separated together.
 */
export class Rests {
  /** Those particles whose way the last call changed. */
  readonly cluster: Cluster = new Cluster();
  readonly #flight: Flight;
  readonly #touches: Touches;
  readonly #complementarity = new Complementarity();
  readonly #velocity: { x: Float64Array; y: Float64Array } = { x: new Float64Array(0), y: new Float64Array(0) };
  readonly #acceleration: { x: Float64Array; y: Float64Array } = { x: new Float64Array(0), y: new Float64Array(0) };
  /** By touch. */
  #impulses: Float64Array = new Float64Array(0);
  #bias: Float64Array = new Float64Array(0);
  #work = 0;
  #dueTime = Infinity;

  constructor(flight: Flight, touches: Touches) {
    this.#flight = flight;
    this.#touches = touches;
  }

  /** Binds the arrays of the step. */
  begin(): void {
    const { particles, ax, ay } = this.#flight;
    this.#velocity.x = particles.vx;
    this.#velocity.y = particles.vy;
    this.#acceleration.x = ax;
    this.#acceleration.y = ay;
    this.#work = 0;
    this.#dueTime = Infinity;
  }

  /** When the support is to be found anew, or `Infinity`. Unit: s since the step began. */
  get dueTime(): number {
    return this.#dueTime;
  }

  /** Whether more happens than can be looked after one by one. */
  get isCrowded(): boolean {
    return this.#work > MOST_WORK;
  }

  /**
   * The closing speed up to which a touch is one at rest: what a step's acceleration builds. Where one of the two is held up
   * already it is that of each on its own towards the other, else that of one against the other: what falls together does not
   * rest. From its `FEW`th impact in a step on, it is that of a particle in whatever direction: in a pile one pushes the other
   * sideways too, to and fro without end.
   */
  restingSpeed(c: number): number {
    const { a, b, normalX, normalY } = this.#touches;
    const { freeX, freeY, impacts, duration } = this.#flight;
    const i = a[c];
    const j = b[c];
    const ofFirst = -(freeX[i] * normalX[c] + freeY[i] * normalY[c]);
    if (this.isCrowded || impacts[i] > FEW) return this.#flight.stepSpeed(i);
    if (j === SCENERY) return Math.max(0, ofFirst) * duration;
    if (impacts[j] > FEW) return this.#flight.stepSpeed(j);
    const ofSecond = freeX[j] * normalX[c] + freeY[j] * normalY[c];
    if (!this.#isHeld(i) && !this.#isHeld(j)) return Math.max(0, ofFirst + ofSecond) * duration;
    return (Math.max(0, ofFirst) + Math.max(0, ofSecond)) * duration;
  }

  /** (v_a - v_b)·n of a touch; its particles are to be of one time. Unit: m/s. */
  separatingVelocity(c: number): number {
    const { a, b, normalX, normalY } = this.#touches;
    const { vx, vy } = this.#flight.particles;
    const alone = vx[a[c]] * normalX[c] + vy[a[c]] * normalY[c];
    return b[c] === SCENERY ? alone : alone - (vx[b[c]] * normalX[c] + vy[b[c]] * normalY[c]);
  }

  /** At the start of a step: stills and supports all touches that rest. */
  settleAll(): void {
    this.#collectAll(0);
    this.#still(0);
    this.#support(0);
  }

  /** Supports anew all that rests, after impacts. */
  relieveAll(now: number): void {
    this.#dueTime = Infinity;
    this.#collectAll(now);
    this.#still(now);
    this.#support(now);
    this.cluster.keepTurned(this.#flight);
  }

  /** Counts that two came to rest on each other. */
  count(i: number, j: number): void {
    const { rests } = this.#flight;
    rests[i]++;
    if (j !== SCENERY) rests[j]++;
  }

  /** A touch comes to rest: it is stilled and supported together with all that rests there. */
  settle(c: number, now: number): void {
    const { a, b } = this.#touches;
    const { yields } = this.#flight;
    this.count(a[c], b[c]);
    if (this.isCrowded) {
      yields[a[c]] = 1;
      if (b[c] !== SCENERY) yields[b[c]] = 1;
      this.cluster.clear(this.#flight.particles.capacity, this.#touches.count);
      return;
    }
    this.#collect(a[c], b[c], c, now);
    this.#still(now);
    this.#support(now);
    this.cluster.keepTurned(this.#flight);
  }

  /** After an impact of two: what rests on them is supported anew. */
  relieve(i: number, j: number, now: number): void {
    if (this.isCrowded || !this.#flight.isDriven) {
      if (this.#flight.isDriven) this.#dueTime = Math.min(this.#dueTime, now + this.#flight.duration / LATE_RELIEFS);
      this.cluster.clear(this.#flight.particles.capacity, this.#touches.count);
      return;
    }
    this.#collect(i, j, -1, now);
    this.#support(now);
    this.cluster.keepTurned(this.#flight);
  }

  #isHeld(i: number): boolean {
    const { force } = this.#touches;
    for (let c = this.#touches.firstOf(i); c >= 0; c = this.#touches.nextOf(i, c)) if (force[c] > 0) return true;
    return false;
  }

  /** Whether a touch closes no faster than one at rest. */
  #isSlow(c: number): boolean {
    const closing = -this.separatingVelocity(c);
    return closing <= CLOSING_EPSILON || closing <= this.restingSpeed(c);
  }

  /** Gathers all that rests and brings it to one time. */
  #collectAll(now: number): void {
    const { cluster } = this;
    const flight = this.#flight;
    const touches = this.#touches;
    const { particles } = flight;
    cluster.clear(particles.capacity, touches.count);
    for (let c = 0; c < touches.count; c++) {
      this.#bring(touches.a[c], now);
      this.#bring(touches.b[c], now);
      touches.measure(c, particles);
      if (touches.isNear(c, particles) && this.#isSlow(c)) cluster.addTouch(c);
      else if (touches.force[c] !== 0) this.#release(c, now);
    }
  }

  #bring(i: number, now: number): void {
    if (i === SCENERY) return;
    this.#flight.advance(i, now);
    if (this.#flight.particles.inverseMass[i] !== 0) this.cluster.addSlot(i, this.#flight);
  }

  /** Gathers what hangs on two particles and brings it to one time. One touch belongs to it however fast it closes. */
  #collect(i: number, j: number, always: number, now: number): void {
    const { cluster } = this;
    const flight = this.#flight;
    const touches = this.#touches;
    const { capacity, inverseMass } = flight.particles;
    cluster.clear(capacity, touches.count);
    this.#bring(i, now);
    this.#bring(j, now);
    for (let s = 0; s < cluster.slotCount; s++) {
      const slot = cluster.slots[s];
      for (let c = touches.firstOf(slot); c >= 0; c = touches.nextOf(slot, c)) {
        if (!cluster.mark(c)) continue;
        const other = touches.a[c] === slot ? touches.b[c] : touches.a[c];
        if (other !== SCENERY) flight.advance(other, now);
        touches.measure(c, flight.particles);
        const rests = touches.isNear(c, flight.particles) && (c === always || this.#isSlow(c));
        if (!rests && touches.force[c] === 0) continue;
        if (other !== SCENERY && inverseMass[other] !== 0) cluster.addSlot(other, flight);
        if (rests) cluster.addTouch(c);
        else this.#release(c, now);
      }
    }
  }

  /** Takes off the closing velocities what would close more than the gap by the end. Writes vx, vy, impulses. */
  #still(now: number): void {
    const { touches, touchCount } = this.cluster;
    const { impulse } = this.#touches;
    const { particles } = this.#flight;
    const left = this.#flight.duration - now;
    if (this.#impulses.length < impulse.length) {
      this.#impulses = new Float64Array(impulse.length);
      this.#bias = new Float64Array(impulse.length);
    }
    for (let k = 0; k < touchCount; k++) {
      const c = touches[k];
      this.#impulses[c] = 0;
      this.#bias[c] = this.#touches.freeGap(c, particles) / left;
    }
    this.#solve(this.#velocity, this.#impulses, Math.min(STILL_VELOCITY, (0.1 * this.#flight.slack) / left));
    for (let k = 0; k < touchCount; k++) impulse[touches[k]] += this.#impulses[touches[k]];
  }

  /**
   * Supports what would close the gap by the end: gap + v·t + a·t²/2 ≥ 0 at the time left, t.
   * Writes ax, ay, forces and impulses.
   */
  #support(now: number): void {
    const { touches, touchCount } = this.cluster;
    const { force, impulse } = this.#touches;
    const { particles } = this.#flight;
    const left = this.#flight.duration - now;
    if (this.#bias.length < force.length) this.#bias = new Float64Array(force.length);
    for (let k = 0; k < touchCount; k++) {
      const c = touches[k];
      impulse[c] -= force[c] * left;
      const apart = this.#touches.freeGap(c, particles) + this.separatingVelocity(c) * left;
      this.#bias[c] = Math.max(0, (2 * apart) / (left * left));
    }
    this.#solve(this.#acceleration, force, Math.min(STILL_ACCELERATION, (0.5 * this.#flight.slack) / (left * left)));
    for (let k = 0; k < touchCount; k++) impulse[touches[k]] += force[touches[k]] * left;
  }

  #solve(field: { x: Float64Array; y: Float64Array }, pushes: Float64Array, floor: number): void {
    const { touches, touchCount } = this.cluster;
    const { inverseMass } = this.#flight.particles;
    this.#work +=
      touchCount *
      this.#complementarity.solve(this.#touches, touches, touchCount, inverseMass, field, pushes, this.#bias, floor);
  }

  /** Takes away the support by a touch that rests no more. */
  #release(c: number, now: number): void {
    const { force, impulse } = this.#touches;
    impulse[c] -= force[c] * (this.#flight.duration - now);
    takeAway(this.#touches, c, this.#flight.particles.inverseMass, this.#acceleration, force);
  }
}
