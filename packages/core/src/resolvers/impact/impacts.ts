import type { Shape } from '../../collision/shape.ts';
import { SCENERY } from '../../contacts/contact-buffer.ts';
import type { Flight } from './flight.ts';
import { Places } from './places.ts';
import type { Rests } from './rests.ts';
import { Tolerance } from './tolerance.ts';
import type { Touches } from './touches.ts';

/** Impacts of one particle in one step from which on it gives back nothing: an endless sequence, as far as can be told. */
export const MOST_IMPACTS = 500;

/** Impacts of one particle in one step from which on it stands still, with its velocity, until the step ends. */
const STANDSTILL = MOST_IMPACTS * 2;

/** Two that touch: they come to rest on each other, or one impulse passes between them. */
export class Impacts {
  readonly #flight: Flight;
  readonly #touches: Touches;
  readonly #rests: Rests;
  readonly #places = new Places();
  readonly #tolerance = new Tolerance();

  constructor(flight: Flight, touches: Touches, rests: Rests) {
    this.#flight = flight;
    this.#touches = touches;
    this.#rests = rests;
  }

  /** Two discs touch. Reads and writes the flight, velocities and touches. */
  hitDisc(i: number, j: number, source: number, now: number): void {
    const flight = this.#flight;
    flight.advance(i, now);
    flight.advance(j, now);
    const { restitution } = flight.particles;
    const c = this.#touches.addDiscs(i, j, source, flight.particles);
    this.#hit(i, j, c, Math.max(restitution[i], restitution[j]), now);
  }

  /** A particle touches a shape: of the places that it touches the one that it closes on fastest counts. */
  hitShape(i: number, shape: Shape, source: number, now: number): void {
    const flight = this.#flight;
    flight.advance(i, now);
    const { x, y, vx, vy, radius, restitution } = flight.particles;
    const places = this.#places;
    const tolerance = this.#tolerance;
    tolerance.set(radius[i], flight.rests[i]);
    const count = places.find(shape, x[i], y[i], radius[i], 2 * tolerance.allowance);
    let found = -1;
    let fastest = Infinity;
    for (let p = 0; p < count; p++) {
      const velocity = vx[i] * places.normalX[p] + vy[i] * places.normalY[p];
      if (!(velocity < fastest)) continue;
      found = p;
      fastest = velocity;
    }
    if (found < 0) {
      this.#count(i, SCENERY); // the shape reports there what it did not on the way: this must end too
      return;
    }
    const { gap, normalX, normalY } = places;
    const c = this.#touches.addPlace(i, source, flight.particles, gap[found], normalX[found], normalY[found]);
    this.#hit(i, SCENERY, c, Math.max(restitution[i], shape.restitution), now);
  }

  #hit(i: number, j: number, c: number, restitution: number, now: number): void {
    const closing = -this.#rests.separatingVelocity(c);
    const many = this.#count(i, j);
    this.#touches.noteHit(c);
    if (closing <= this.#rests.restingSpeed(c)) {
      this.#rests.settle(c, now);
      return;
    }
    const kept = many > MOST_IMPACTS ? 0 : restitution;
    if (kept === 0) this.#rests.count(i, j); // on a surface that curves towards it, again at once
    this.#pass(c, closing * (1 + kept));
    this.#rests.relieve(i, j, now);
  }

  /** v_s' = -c·v_s: an impulse J = (v_s' - v_s) / (1/m_a + 1/m_b) along the normal. Writes vx, vy. */
  #pass(c: number, change: number): void {
    const { a, b, normalX, normalY, impulse } = this.#touches;
    const { vx, vy, inverseMass } = this.#flight.particles;
    const i = a[c];
    const j = b[c];
    const wi = inverseMass[i];
    const wj = j === SCENERY ? 0 : inverseMass[j];
    const J = change / (wi + wj);
    impulse[c] += J;
    vx[i] += J * wi * normalX[c];
    vy[i] += J * wi * normalY[c];
    if (j === SCENERY) return;
    vx[j] -= J * wj * normalX[c];
    vy[j] -= J * wj * normalY[c];
  }

  /** Counts an impact; of too many two stand still. Returns the greater count of the two. */
  #count(i: number, j: number): number {
    const { impacts, pace } = this.#flight;
    const many = Math.max(++impacts[i], j === SCENERY ? 0 : ++impacts[j]);
    if (many <= STANDSTILL) return many;
    pace[i] = 0;
    if (j !== SCENERY) pace[j] = 0;
    return many;
  }
}
