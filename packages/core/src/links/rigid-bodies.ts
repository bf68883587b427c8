import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { LimitedLink } from './limited-link.ts';
import { linkGraph } from './link-graph.ts';
import { type RigidShape, rigidShape } from './rigid-shape.ts';

/** How far a body may turn in a small step: the sine. What spins faster is slowed to it. */
const FASTEST_TURN = 0.9;

/**
 * Keeps what rods hold in one shape by moving it as one: a position, an angle and their velocities are all that it has. That is direct, whatever the
 * number of rods, and takes no energy from a body that turns freely: the step is what the rods would do (SHAKE, J.-P. Ryckaert et al., 1977),
 * found from momentum and angular momentum alone.
 */
export class RigidBodies {
  /** First member of each body, and the end of the last. */
  #first: number[] = [0];
  #slot = new Int32Array(0);
  /** Where each member is in its body, from the centre of mass. Unit: m. */
  #x = new Float64Array(0);
  #y = new Float64Array(0);
  #mass = new Float64Array(0);
  /** Of each body: mass, moment of inertia. Unit: kg, kg·m². */
  #bodyMass = new Float64Array(0);
  #inertia = new Float64Array(0);
  #awake = new Uint8Array(0);
  #links: readonly LimitedLink[] = [];
  #lengths = new Float64Array(0);

  /** Takes those of the links that make rigid bodies. Returns 1 for each that it has taken. */
  take(links: readonly LimitedLink[], particles: ParticleArrays): Uint8Array {
    const taken = new Uint8Array(links.length);
    const graph = linkGraph(links, particles);
    const shapes: RigidShape[] = [];
    const bodyOf = new Int32Array(graph.slots).fill(-1);
    for (const slots of parts(graph)) {
      const shape = rigidShape(slots, links, graph, particles);
      if (shape === undefined) continue;
      for (const slot of slots) bodyOf[slot] = shapes.length;
      shapes.push(shape);
    }
    this.#links = links.filter((_, l) => {
      taken[l] = graph.near[l] >= 0 && bodyOf[graph.near[l]] >= 0 ? 1 : 0;
      return taken[l] === 1;
    });
    this.#lengths = Float64Array.from(this.#links, ({ maxLength }) => maxLength);
    this.#write(shapes);
    return taken;
  }

  /** Begins a step. Reads mass, inverseMass, asleep. Returns whether the bodies are still what they were. */
  begin({ mass, inverseMass, asleep }: ParticleArrays): boolean {
    for (let l = 0; l < this.#links.length; l++) {
      const { minLength, maxLength } = this.#links[l];
      if (minLength !== this.#lengths[l] || maxLength !== this.#lengths[l]) return false;
    }
    for (let b = 0; b < this.#awake.length; b++) {
      let changed = this.#bodyMass[b] === 0;
      let awake = 1;
      for (let k = this.#first[b]; k < this.#first[b + 1]; k++) {
        const s = this.#slot[k];
        if (asleep[s] === 1) awake = 0;
        else if (inverseMass[s] === 0) return false;
        if (mass[s] !== this.#mass[k]) changed = true;
      }
      this.#awake[b] = awake;
      if (changed) this.#weigh(b, mass);
    }
    return true;
  }

  /**
   * Gives the members of each body the velocities at which they stay in shape while positions move on by `h`. Reads x, y, vx, vy.
   * Writes x, y by what they are off their shape, and vx, vy.
   */
  solve({ x, y, vx, vy }: ParticleArrays, h: number): void {
    const slot = this.#slot;
    const rx = this.#x;
    const ry = this.#y;
    const mass = this.#mass;
    for (let b = 0; b < this.#awake.length; b++) {
      if (this.#awake[b] === 0) continue;
      const from = this.#first[b];
      const to = this.#first[b + 1];
      let cx = 0;
      let cy = 0;
      let px = 0;
      let py = 0;
      for (let k = from; k < to; k++) {
        const s = slot[k];
        const m = mass[k];
        cx += m * x[s];
        cy += m * y[s];
        px += m * vx[s];
        py += m * vy[s];
      }
      const perMass = 1 / this.#bodyMass[b];
      cx *= perMass;
      cy *= perMass;
      px *= perMass;
      py *= perMass;
      let along = 0;
      let across = 0;
      let spin = 0;
      for (let k = from; k < to; k++) {
        const s = slot[k];
        const m = mass[k];
        const dx = x[s] - cx;
        const dy = y[s] - cy;
        along += m * (rx[k] * dx + ry[k] * dy);
        across += m * (rx[k] * dy - ry[k] * dx);
        spin += m * (dx * (vy[s] - py) - dy * (vx[s] - px));
      }
      const norm = Math.sqrt(along * along + across * across);
      const cos = norm === 0 ? 1 : along / norm;
      const sin = norm === 0 ? 0 : across / norm;
      const turn = Math.max(-FASTEST_TURN, Math.min(FASTEST_TURN, (h * spin) / this.#inertia[b]));
      const across1 = turn / h;
      const inwards = (turn * turn) / ((1 + Math.sqrt(1 - turn * turn)) * h);
      for (let k = from; k < to; k++) {
        const s = slot[k];
        const ox = cos * rx[k] - sin * ry[k];
        const oy = sin * rx[k] + cos * ry[k];
        x[s] = cx + ox;
        y[s] = cy + oy;
        vx[s] = px - across1 * oy - inwards * ox;
        vy[s] = py + across1 * ox - inwards * oy;
      }
    }
  }

  /** Brings the members back into shape by position alone. Writes x, y. */
  straighten({ x, y }: ParticleArrays): void {
    const slot = this.#slot;
    const rx = this.#x;
    const ry = this.#y;
    const mass = this.#mass;
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
        const mx = mass[k] * x[s];
        const my = mass[k] * y[s];
        cx += mx;
        cy += my;
        along += rx[k] * mx + ry[k] * my;
        across += rx[k] * my - ry[k] * mx;
      }
      cx /= this.#bodyMass[b];
      cy /= this.#bodyMass[b];
      const norm = Math.sqrt(along * along + across * across);
      if (norm === 0) continue;
      const cos = along / norm;
      const sin = across / norm;
      for (let k = from; k < to; k++) {
        const s = slot[k];
        x[s] = cx + cos * rx[k] - sin * ry[k];
        y[s] = cy + sin * rx[k] + cos * ry[k];
      }
    }
  }

  #write(shapes: readonly RigidShape[]): void {
    this.#first = [0];
    for (const { slots } of shapes) this.#first.push((this.#first.at(-1) ?? 0) + slots.length);
    this.#slot = Int32Array.from(shapes.flatMap(({ slots }) => slots));
    this.#x = Float64Array.from(shapes.flatMap(({ x }) => x));
    this.#y = Float64Array.from(shapes.flatMap(({ y }) => y));
    this.#mass = new Float64Array(this.#slot.length);
    this.#bodyMass = new Float64Array(shapes.length);
    this.#inertia = new Float64Array(shapes.length);
    this.#awake = new Uint8Array(shapes.length);
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
      cx += m * this.#x[k];
      cy += m * this.#y[k];
    }
    let inertia = 0;
    for (let k = from; k < to; k++) {
      const x = this.#x[k] - cx / sum;
      const y = this.#y[k] - cy / sum;
      this.#x[k] = x;
      this.#y[k] = y;
      inertia += this.#mass[k] * (x * x + y * y);
    }
    this.#bodyMass[b] = sum;
    this.#inertia[b] = inertia;
  }
}

/** The slots of each connected part of a graph. */
function parts({ slots, near, far, first, links }: ReturnType<typeof linkGraph>): number[][] {
  const seen = new Uint8Array(slots);
  const all: number[][] = [];
  for (let start = 0; start < slots; start++) {
    if (seen[start] === 1 || first[start + 1] === first[start]) continue;
    const part = [start];
    seen[start] = 1;
    for (const slot of part) {
      for (let i = first[slot]; i < first[slot + 1]; i++) {
        const other = near[links[i]] === slot ? far[links[i]] : near[links[i]];
        if (other < 0 || seen[other] === 1) continue;
        seen[other] = 1;
        part.push(other);
      }
    }
    all.push(part);
  }
  return all;
}
