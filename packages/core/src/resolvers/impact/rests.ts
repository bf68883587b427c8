import { SCENERY } from '../../contacts/contact-buffer.ts';
import { Cluster } from './cluster.ts';
import { Complementarity, push } from './complementarity.ts';
import { CLOSING_EPSILON } from './first-touch.ts';
import type { Flight } from './flight.ts';
import type { Touches } from './touches.ts';

/** What counts as still, of a velocity and of an acceleration. Unit: m/s, m/s². */
const STILL_VELOCITY = 1e-13;
const STILL_ACCELERATION = 1e-11;

/**
 * What rests on what. Two things come to rest on each other when they touch no faster than the acceleration of one step
 * makes them: from then on their normal velocity is 0, and the normal acceleration that presses them together is cancelled,
 * for all touches that hang together at once. So a pile at rest costs no impacts, and what slides does so on exact parabolas.
 */
export class Rests {
  /** The particles whose way the last call changed. */
  readonly cluster: Cluster = new Cluster();
  readonly #flight: Flight;
  readonly #touches: Touches;
  readonly #complementarity = new Complementarity();
  readonly #velocity: { x: Float64Array; y: Float64Array } = { x: new Float64Array(0), y: new Float64Array(0) };
  readonly #acceleration: { x: Float64Array; y: Float64Array } = { x: new Float64Array(0), y: new Float64Array(0) };
  #impulses = new Float64Array(0);

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
  }

  /**
   * The closing speed up to which a touch is one at rest: what a step's acceleration builds. Where one of the two is held up
   * already it is that of each on its own towards the other, else that of one against the other: what falls together does not rest.
   */
  restingSpeed(i: number, j: number, nx: number, ny: number): number {
    const { freeX, freeY, duration } = this.#flight;
    const ofFirst = -(freeX[i] * nx + freeY[i] * ny);
    if (j === SCENERY) return Math.max(0, ofFirst) * duration;
    const ofSecond = freeX[j] * nx + freeY[j] * ny;
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

  /** At the start of a step: stills and supports all touches that are marked as resting. */
  settleAll(): void {
    this.cluster.clear(this.#flight.particles.capacity);
    this.cluster.addAll(this.#touches);
    this.#still();
    this.#support(0);
  }

  /** A touch comes to rest: it is stilled and supported together with all that rests there. */
  settle(c: number, now: number): void {
    const touches = this.#touches;
    const { a, b, resting } = touches;
    resting[c] = 1;
    this.#flight.rests[a[c]]++;
    if (b[c] !== SCENERY) this.#flight.rests[b[c]]++;
    this.#collect(a[c], b[c], now);
    this.#releaseClosing(c, now);
    this.#still();
    this.#releaseOpening(now);
    this.#support(now);
    this.cluster.keepTurned(this.#flight);
  }

  /** After an impact of two: what does not rest on them any more is let go, and the rest supported anew. */
  relieve(i: number, j: number, now: number): void {
    this.#collect(i, j, now);
    if (this.cluster.touchCount > 0) {
      this.#releaseOpening(now);
      this.#support(now);
    }
    this.cluster.keepTurned(this.#flight);
  }

  #isHeld(i: number): boolean {
    const { force } = this.#touches;
    for (let c = this.#touches.firstOf(i); c >= 0; c = this.#touches.nextOf(i, c)) if (force[c] > 0) return true;
    return false;
  }

  /** Gathers what hangs on two particles and brings it to one time. Reads positions. Writes normals. */
  #collect(i: number, j: number, now: number): void {
    const { cluster } = this;
    const flight = this.#flight;
    const { inverseMass, capacity, x, y } = flight.particles;
    cluster.clear(capacity);
    cluster.add(this.#touches, inverseMass, i);
    if (j !== SCENERY) cluster.add(this.#touches, inverseMass, j);
    for (let s = 0; s < cluster.slotCount; s++) flight.advance(cluster.slots[s], now);
    cluster.note(flight);
    const { a, b, normalX, normalY } = this.#touches;
    for (let k = 0; k < cluster.touchCount; k++) {
      const c = cluster.touches[k];
      if (b[c] === SCENERY) continue;
      if (inverseMass[a[c]] === 0) flight.advance(a[c], now);
      if (inverseMass[b[c]] === 0) flight.advance(b[c], now);
      const dx = x[a[c]] - x[b[c]];
      const dy = y[a[c]] - y[b[c]];
      const distance = Math.sqrt(dx * dx + dy * dy);
      if (distance === 0) continue;
      normalX[c] = dx / distance;
      normalY[c] = dy / distance;
    }
  }

  /** Makes all closing velocities 0. Writes vx, vy and the impulses. */
  #still(): void {
    const { touches, touchCount } = this.cluster;
    const { inverseMass } = this.#flight.particles;
    if (this.#impulses.length < this.#touches.a.length) this.#impulses = new Float64Array(this.#touches.a.length);
    const impulses = this.#impulses;
    for (let k = 0; k < touchCount; k++) impulses[touches[k]] = 0;
    this.#solve(this.#velocity, impulses, inverseMass, STILL_VELOCITY);
    for (let k = 0; k < touchCount; k++) this.#touches.impulse[touches[k]] += impulses[touches[k]];
  }

  /** Makes all closing accelerations 0 from now on. Writes ax, ay, forces and impulses. */
  #support(now: number): void {
    const { touches, touchCount } = this.cluster;
    const { force, impulse } = this.#touches;
    const { inverseMass } = this.#flight.particles;
    const left = this.#flight.duration - now;
    for (let k = 0; k < touchCount; k++) impulse[touches[k]] -= force[touches[k]] * left;
    this.#solve(this.#acceleration, force, inverseMass, STILL_ACCELERATION);
    for (let k = 0; k < touchCount; k++) impulse[touches[k]] += force[touches[k]] * left;
  }

  #solve(
    field: { x: Float64Array; y: Float64Array },
    pushes: Float64Array,
    inverseMass: Float64Array,
    floor: number,
  ): void {
    const { touches, touchCount } = this.cluster;
    this.#complementarity.solve(this.#touches, touches, touchCount, inverseMass, field, pushes, undefined, floor);
  }

  /** Lets go what is hit too hard to rest, but for one touch: it will be an impact. */
  #releaseClosing(but: number, now: number): void {
    const { a, b, normalX, normalY } = this.#touches;
    for (let k = 0; k < this.cluster.touchCount; k++) {
      const c = this.cluster.touches[k];
      const closing = -this.separatingVelocity(c);
      if (c === but || closing <= CLOSING_EPSILON) continue;
      if (closing > this.restingSpeed(a[c], b[c], normalX[c], normalY[c])) this.#release(c, now);
    }
    this.cluster.dropReleased(this.#touches);
  }

  /** Lets go what separates. */
  #releaseOpening(now: number): void {
    for (let k = 0; k < this.cluster.touchCount; k++) {
      const c = this.cluster.touches[k];
      if (this.separatingVelocity(c) > CLOSING_EPSILON) this.#release(c, now);
    }
    this.cluster.dropReleased(this.#touches);
  }

  #release(c: number, now: number): void {
    const { resting, force, impulse } = this.#touches;
    resting[c] = 0;
    if (force[c] === 0) return;
    impulse[c] -= force[c] * (this.#flight.duration - now);
    push(this.#touches, c, this.#flight.particles.inverseMass, this.#acceleration, force, -force[c]);
    force[c] = 0;
  }
}
