import { BodyRows } from '../contacts/solver/body-rows.ts';
import type { RigidMotion } from '../contacts/solver/rigid-motion.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { LimitedLink } from './limited-link.ts';
import { linkGraph } from './link-graph.ts';
import { connectedParts, type RigidShape, rigidShape } from './rigid-shape.ts';

/** How far a body may turn in a small step: the sine. What spins faster is slowed to it. */
const FASTEST_TURN = 0.9;

/** What turns farther might gain energy, since places between which it moves in straight lines are farther apart than they look. */
const WIDE_TURN = 0.2;
/** As a share, how much it may. */
const MOST_GAIN = 0.01;

/**
 * Keeps what rods hold in one shape by moving it as one: a place, an angle and their velocities are all that it has. That is direct, whatever
 * the number of rods, and takes no energy from a body that turns freely: the step is what the rods would do (SHAKE, J.-P. Ryckaert
 * et al., 1977), found from momentum and angular momentum alone.
 */
export class RigidBodies implements RigidMotion {
  readonly rows: BodyRows = new BodyRows();
  vx: Float64Array = new Float64Array(0);
  vy: Float64Array = new Float64Array(0);
  spin: Float64Array = new Float64Array(0);
  x: Float64Array = new Float64Array(0);
  y: Float64Array = new Float64Array(0);
  inverseMass: Float64Array = new Float64Array(0);
  inverseInertia: Float64Array = new Float64Array(0);
  /** The motion as it was read. */
  #oldVx = new Float64Array(0);
  #oldVy = new Float64Array(0);
  #oldSpin = new Float64Array(0);
  #awake = new Uint8Array(0);
  /** First member of each body, and the end of the last. */
  #first: Int32Array = new Int32Array(1);
  /** The members: slot, place in the body from its centre of mass, mass. */
  #slot: Int32Array = new Int32Array(0);
  #shapeX: Float64Array = new Float64Array(0);
  #shapeY: Float64Array = new Float64Array(0);
  #mass = new Float64Array(0);
  /** The body of each slot, or -1; slots beyond have none. */
  #bodyOf: Int32Array = new Int32Array(0);
  #links: readonly LimitedLink[] = [];
  #lengths: Float64Array = new Float64Array(0);

  /** Takes those of the links that make rigid bodies. Returns 1 for each that it has taken. */
  take(links: readonly LimitedLink[], particles: ParticleArrays): Uint8Array {
    const graph = linkGraph(links, particles);
    const shapes: RigidShape[] = [];
    this.#bodyOf = new Int32Array(graph.slots).fill(-1);
    for (const slots of connectedParts(graph)) {
      const shape = rigidShape(slots, links, graph, particles);
      if (shape === undefined) continue;
      for (const slot of slots) this.#bodyOf[slot] = shapes.length;
      shapes.push(shape);
    }
    this.#hold(shapes);
    const taken = Uint8Array.from(graph.near, (slot) => (slot >= 0 && this.#bodyOf[slot] >= 0 ? 1 : 0));
    this.#links = links.filter((_, l) => taken[l] === 1);
    this.#lengths = Float64Array.from(this.#links, ({ maxLength }) => maxLength);
    return taken;
  }

  /** Begins a step. Reads mass, inverseMass, asleep. Returns whether the bodies are still what they were. */
  begin({ mass, inverseMass, asleep }: ParticleArrays): boolean {
    for (let l = 0; l < this.#links.length; l++) {
      const { minLength, maxLength } = this.#links[l];
      if (minLength !== this.#lengths[l] || maxLength !== this.#lengths[l]) return false;
    }
    for (let b = 0; b < this.#awake.length; b++) {
      let changed = false;
      this.#awake[b] = 1;
      for (let k = this.#first[b]; k < this.#first[b + 1]; k++) {
        const s = this.#slot[k];
        if (asleep[s] === 1) this.#awake[b] = 0;
        else if (inverseMass[s] === 0) return false;
        if (mass[s] !== this.#mass[k]) changed = true;
      }
      if (changed) this.#weigh(b, mass);
    }
    return true;
  }

  bodyOf(slot: number): number {
    const body = slot < this.#bodyOf.length ? this.#bodyOf[slot] : -1;
    return body >= 0 && this.#awake[body] === 1 ? body : -1;
  }

  read({ x, y, vx, vy }: ParticleArrays): void {
    const slot = this.#slot;
    const mass = this.#mass;
    for (let b = 0; b < this.#awake.length; b++) {
      if (this.#awake[b] === 0) continue;
      const from = this.#first[b];
      const to = this.#first[b + 1];
      let mx = 0;
      let my = 0;
      let px = 0;
      let py = 0;
      let turn = 0;
      for (let k = from; k < to; k++) {
        const s = slot[k];
        const m = mass[k];
        mx += m * x[s];
        my += m * y[s];
        px += m * vx[s];
        py += m * vy[s];
      }
      const w = this.inverseMass[b];
      const cx = mx * w;
      const cy = my * w;
      for (let k = from; k < to; k++) {
        const s = slot[k];
        turn += mass[k] * ((x[s] - cx) * vy[s] - (y[s] - cy) * vx[s]);
      }
      this.x[b] = cx;
      this.y[b] = cy;
      this.vx[b] = this.#oldVx[b] = px * w;
      this.vy[b] = this.#oldVy[b] = py * w;
      this.spin[b] = this.#oldSpin[b] = turn * this.inverseInertia[b];
    }
  }

  write({ x, y, vx, vy }: ParticleArrays): void {
    for (let b = 0; b < this.#awake.length; b++) {
      if (this.#awake[b] === 0) continue;
      const dvx = this.vx[b] - this.#oldVx[b];
      const dvy = this.vy[b] - this.#oldVy[b];
      const spin = this.spin[b] - this.#oldSpin[b];
      if (dvx === 0 && dvy === 0 && spin === 0) continue;
      for (let k = this.#first[b]; k < this.#first[b + 1]; k++) {
        const s = this.#slot[k];
        vx[s] += dvx - spin * (y[s] - this.y[b]);
        vy[s] += dvy + spin * (x[s] - this.x[b]);
      }
    }
  }

  push(
    body: number,
    impulseX: number,
    impulseY: number,
    atX: number,
    atY: number,
    { x, y }: ParticleArrays,
    vx: Float64Array,
    vy: Float64Array,
  ): void {
    let mx = 0;
    let my = 0;
    const from = this.#first[body];
    const to = this.#first[body + 1];
    for (let k = from; k < to; k++) {
      mx += this.#mass[k] * x[this.#slot[k]];
      my += this.#mass[k] * y[this.#slot[k]];
    }
    const w = this.inverseMass[body];
    const cx = mx * w;
    const cy = my * w;
    const spin = ((atX - cx) * impulseY - (atY - cy) * impulseX) * this.inverseInertia[body];
    for (let k = from; k < to; k++) {
      const s = this.#slot[k];
      vx[s] += impulseX * w - spin * (y[s] - cy);
      vy[s] += impulseY * w + spin * (x[s] - cx);
    }
  }

  /**
   * Gives the members of each body the velocities at which they stay in shape while positions move on by `h`. Reads x, y, vx, vy.
   * Writes x, y by what they are off their shape, and vx, vy.
   */
  solve(particles: ParticleArrays, h: number): void {
    this.straighten(particles);
    this.read(particles);
    const { x, y, vx, vy } = particles;
    for (let b = 0; b < this.#awake.length; b++) {
      if (this.#awake[b] === 0) continue;
      let turn = h * this.spin[b];
      if (Math.abs(turn) > WIDE_TURN) turn = this.#limitTurn(b, turn, particles, h);
      const across = turn / h;
      const inwards = (turn * turn) / ((1 + Math.sqrt(1 - turn * turn)) * h);
      for (let k = this.#first[b]; k < this.#first[b + 1]; k++) {
        const s = this.#slot[k];
        const dx = x[s] - this.x[b];
        const dy = y[s] - this.y[b];
        vx[s] = this.vx[b] - across * dy - inwards * dx;
        vy[s] = this.vy[b] + across * dx - inwards * dy;
      }
    }
  }

  /** Limits the sine of a turn, so that it holds hardly more energy than the members had. Reads vx, vy. */
  #limitTurn(b: number, turn: number, { vx, vy }: ParticleArrays, h: number): number {
    let energy = 0;
    for (let k = this.#first[b]; k < this.#first[b + 1]; k++) {
      const ux = vx[this.#slot[k]] - this.vx[b];
      const uy = vy[this.#slot[k]] - this.vy[b];
      energy += this.#mass[k] * (ux * ux + uy * uy);
    }
    // That of a turn by φ within h is I·(1 - cos φ) / h².
    const versine = Math.min(1, (0.5 + 0.5 * MOST_GAIN) * energy * this.inverseInertia[b] * h * h);
    const most = Math.min(FASTEST_TURN, Math.sqrt(versine * (2 - versine)));
    return Math.max(-most, Math.min(most, turn));
  }

  /** Brings the members back into shape by position alone. Writes x, y. */
  straighten({ x, y }: ParticleArrays): void {
    const slot = this.#slot;
    const shapeX = this.#shapeX;
    const shapeY = this.#shapeY;
    for (let b = 0; b < this.#awake.length; b++) {
      if (this.#awake[b] === 0) continue;
      const from = this.#first[b];
      const to = this.#first[b + 1];
      let cx = 0;
      let cy = 0;
      let along = 0;
      let across = 0;
      for (let k = from; k < to; k++) {
        const s = slot[k];
        const mx = this.#mass[k] * x[s];
        const my = this.#mass[k] * y[s];
        cx += mx;
        cy += my;
        along += shapeX[k] * mx + shapeY[k] * my;
        across += shapeX[k] * my - shapeY[k] * mx;
      }
      cx *= this.inverseMass[b];
      cy *= this.inverseMass[b];
      const norm = Math.sqrt(along * along + across * across);
      if (norm === 0) continue;
      const cos = along / norm;
      const sin = across / norm;
      for (let k = from; k < to; k++) {
        const s = slot[k];
        x[s] = cx + cos * shapeX[k] - sin * shapeY[k];
        y[s] = cy + sin * shapeX[k] + cos * shapeY[k];
      }
    }
  }

  #hold(shapes: readonly RigidShape[]): void {
    this.#first = new Int32Array(shapes.length + 1);
    for (let b = 0; b < shapes.length; b++) this.#first[b + 1] = this.#first[b] + shapes[b].slots.length;
    this.#slot = Int32Array.from(shapes.flatMap(({ slots }) => slots));
    this.#shapeX = Float64Array.from(shapes.flatMap(({ x }) => x));
    this.#shapeY = Float64Array.from(shapes.flatMap(({ y }) => y));
    this.#mass = new Float64Array(this.#slot.length);
    this.#awake = new Uint8Array(shapes.length);
    const column = () => new Float64Array(shapes.length);
    this.x = column();
    this.y = column();
    this.vx = column();
    this.vy = column();
    this.spin = column();
    this.#oldVx = column();
    this.#oldVy = column();
    this.#oldSpin = column();
    this.inverseMass = column();
    this.inverseInertia = column();
  }

  /** Reads the masses of a body, and puts the origin of its shape where they balance. */
  #weigh(b: number, mass: Float64Array): void {
    const from = this.#first[b];
    const to = this.#first[b + 1];
    let sum = 0;
    let cx = 0;
    let cy = 0;
    for (let k = from; k < to; k++) {
      const m = mass[this.#slot[k]];
      this.#mass[k] = m;
      sum += m;
      cx += m * this.#shapeX[k];
      cy += m * this.#shapeY[k];
    }
    let inertia = 0;
    for (let k = from; k < to; k++) {
      const x = this.#shapeX[k] - cx / sum;
      const y = this.#shapeY[k] - cy / sum;
      this.#shapeX[k] = x;
      this.#shapeY[k] = y;
      inertia += this.#mass[k] * (x * x + y * y);
    }
    this.inverseMass[b] = 1 / sum;
    this.inverseInertia[b] = 1 / inertia;
  }
}
