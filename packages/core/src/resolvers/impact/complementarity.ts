import { SCENERY } from '../../contacts/contact-buffer.ts';

/** Ends when no touch is off by more than this share of how far the worst was off at first. */
const TOLERANCE = 1e-13;

/** Most sweeps over the touches. */
const MOST_SWEEPS = 200;

/** Pairs of particles, or of a particle and `SCENERY`, with a unit normal towards the first. */
export interface Normals {
  readonly a: Int32Array;
  readonly b: Int32Array;
  readonly normalX: Float64Array;
  readonly normalY: Float64Array;
}

/** A vector for each particle: velocities, accelerations, or shifts. */
export interface Field {
  readonly x: Float64Array;
  readonly y: Float64Array;
}

/**
 * Finds pushes along the normals, none of them negative, after which in no touch the two approach: (f_a - f_b)·n + bias ≥ 0,
 * and push only where it is 0. On velocities that is what bodies at rest do when they come to lie on each other, on accelerations
 * what supports them, on shifts with the gap as bias how they are separated. The answer is that of all touches together, not
 * of one after the other, so that a pile is as quiet as a single disc.
 *
 * Projected Gauss-Seidel, sped up by conjugate directions (M. Silcowitz-Hansen, S. Niebe, K. Erleben, *A nonsmooth nonlinear
 * conjugate gradient method for interactive contact force problems*, 2010): without these the sweeps needed grow with the
 * square of a pile's height.
 */
export class Complementarity {
  #change = new Float64Array(0);
  #direction = new Float64Array(0);

  /**
   * Reads the touches listed, their normals, inverseMass and bias. Writes the field and the pushes.
   * @param pushes - By touch; where it starts from, which the field has in it already.
   * @param bias - By touch, or undefined for 0.
   * @param floor - Nothing below this counts as off, in the unit of the field.
   * @returns How many sweeps it took.
   */
  solve(
    touches: Normals,
    list: Int32Array,
    count: number,
    inverseMass: Float64Array,
    field: Field,
    pushes: Float64Array,
    bias: Float64Array | undefined,
    floor: number,
  ): number {
    if (this.#change.length < count) {
      this.#change = new Float64Array(count * 2);
      this.#direction = new Float64Array(count * 2);
    }
    const direction = this.#direction;
    const change = this.#change;
    direction.fill(0, 0, count);
    let tolerance = floor;
    let before = Infinity;
    for (let sweep = 0; sweep < MOST_SWEEPS; sweep++) {
      const worst = this.#sweep(touches, list, count, inverseMass, field, pushes, bias);
      if (worst <= tolerance) return sweep + 1;
      if (sweep === 0) tolerance = Math.max(floor, worst * TOLERANCE);
      let gradient = 0;
      for (let k = 0; k < count; k++) gradient += change[k] * change[k];
      const share = sweep === 0 || gradient > before ? 0 : gradient / before;
      before = gradient;
      for (let k = 0; k < count; k++) direction[k] *= share;
      if (share > 0) pushAll(touches, list, count, inverseMass, field, pushes, direction);
      if (share > 0 || sweep === 0) for (let k = 0; k < count; k++) direction[k] += change[k];
    }
    this.#sweep(touches, list, count, inverseMass, field, pushes, bias); // ends without a direction added
    return MOST_SWEEPS + 1;
  }

  /** Puts each touch right in turn. Returns by how much the worst was off. */
  #sweep(
    touches: Normals,
    list: Int32Array,
    count: number,
    inverseMass: Float64Array,
    field: Field,
    pushes: Float64Array,
    bias: Float64Array | undefined,
  ): number {
    const { a, b, normalX, normalY } = touches;
    const { x, y } = field;
    const change = this.#change;
    let worst = 0;
    for (let k = 0; k < count; k++) {
      const c = list[k];
      const i = a[c];
      const j = b[c];
      const nx = normalX[c];
      const ny = normalY[c];
      const wi = inverseMass[i];
      const wj = j === SCENERY ? 0 : inverseMass[j];
      change[k] = 0;
      if (wi + wj === 0) continue;
      let approach = x[i] * nx + y[i] * ny;
      if (j !== SCENERY) approach -= x[j] * nx + y[j] * ny;
      if (bias !== undefined) approach += bias[c];
      const old = pushes[c];
      const now = Math.max(0, old - approach / (wi + wj));
      const d = now - old;
      change[k] = d;
      if (d === 0) continue;
      worst = Math.max(worst, Math.abs(d) * (wi + wj));
      pushes[c] = now;
      x[i] += d * wi * nx;
      y[i] += d * wi * ny;
      if (j === SCENERY) continue;
      x[j] -= d * wj * nx;
      y[j] -= d * wj * ny;
    }
    return worst;
  }
}

/** Adds to the pushes. Writes the field and the pushes. */
function pushAll(
  { a, b, normalX, normalY }: Normals,
  list: Int32Array,
  count: number,
  inverseMass: Float64Array,
  { x, y }: Field,
  pushes: Float64Array,
  amounts: Float64Array,
): void {
  for (let k = 0; k < count; k++) {
    const c = list[k];
    const i = a[c];
    const j = b[c];
    const dx = amounts[k] * normalX[c];
    const dy = amounts[k] * normalY[c];
    pushes[c] += amounts[k];
    x[i] += dx * inverseMass[i];
    y[i] += dy * inverseMass[i];
    if (j === SCENERY) continue;
    x[j] -= dx * inverseMass[j];
    y[j] -= dy * inverseMass[j];
  }
}

/** Takes a push away. Writes the field and the push. */
export function takeAway(
  { a, b, normalX, normalY }: Normals,
  c: number,
  inverseMass: Float64Array,
  { x, y }: Field,
  pushes: Float64Array,
): void {
  const i = a[c];
  const j = b[c];
  x[i] -= pushes[c] * inverseMass[i] * normalX[c];
  y[i] -= pushes[c] * inverseMass[i] * normalY[c];
  if (j !== SCENERY) {
    x[j] += pushes[c] * inverseMass[j] * normalX[c];
    y[j] += pushes[c] * inverseMass[j] * normalY[c];
  }
  pushes[c] = 0;
}
