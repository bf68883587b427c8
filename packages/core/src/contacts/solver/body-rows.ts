import { growColumns } from '../../math/columns.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { type ContactBuffer, shareOf } from '../contact-buffer.ts';
import type { ContactRows } from './contact-rows.ts';
import type { RigidMotion, RowsOfBodies } from './rigid-motion.ts';
import type { Softness } from './softness.ts';
import { repeatOnBodies, solveBodies } from './solve-bodies.ts';

/** The rows of which one thing or both belong to a rigid body. All else of them is in `ContactRows`. */
export class BodyRows implements RowsOfBodies {
  count = 0;
  /** Index of the contact. */
  row: Int32Array = new Int32Array(16);
  /** Bodies of the first and of the second, -1 for none. */
  bodyA: Int32Array = new Int32Array(16);
  bodyB: Int32Array = new Int32Array(16);
  /** One over the change of speed that an impulse makes, along the tangent. Unit: kg. */
  tangentMass: Float64Array = new Float64Array(16);

  /** Lists the rows, those with scenery last: what cannot give way has the last word. Writes which of the rows are here. */
  build(contacts: ContactBuffer, rows: ContactRows, bodies: RigidMotion, particles: ParticleArrays): void {
    const { count, sceneryStart, sceneryEnd } = contacts;
    this.count = 0;
    this.#list(0, sceneryStart, contacts, rows, bodies);
    this.#list(sceneryEnd, count, contacts, rows, bodies);
    this.#list(sceneryStart, sceneryEnd, contacts, rows, bodies);
    this.weigh(contacts, rows, bodies, particles);
  }

  /** One pass over the rows. Writes vx, vy, and the impulses. */
  pass(
    contacts: ContactBuffer,
    rows: ContactRows,
    bodies: RigidMotion,
    particles: ParticleArrays,
    soft: Softness,
    h: number,
    calm: number,
    begins: boolean,
  ): void {
    if (this.count === 0) return;
    this.weigh(contacts, rows, bodies, particles);
    if (begins) repeatOnBodies(this, contacts, rows, bodies, particles);
    solveBodies(this, contacts, rows, bodies, particles, soft, h, calm);
    bodies.write(particles);
  }

  /** Reads the motion of the bodies, and weighs the rows as they stand. Reads x, y, vx, vy, inverseMass. Writes the masses of the rows. */
  weigh(contacts: ContactBuffer, { second, mass }: ContactRows, bodies: RigidMotion, particles: ParticleArrays): void {
    if (this.count === 0) return;
    bodies.read(particles);
    const { x: bodyX, y: bodyY, inverseMass: perMass, inverseInertia } = bodies;
    const { x, y, inverseMass } = particles;
    const { a, edgeEnd, normalX, normalY } = contacts;
    const { count, row, bodyA, bodyB, tangentMass } = this;
    for (let r = 0; r < count; r++) {
      const c = row[r];
      const A = bodyA[r];
      const B = bodyB[r];
      const i = a[c];
      const j = second[c];
      const t = shareOf(contacts, c);
      const k = t === 0 ? j : edgeEnd[c];
      const nx = normalX[c];
      const ny = normalY[c];
      let along = A < 0 ? inverseMass[i] : perMass[A];
      along += B < 0 ? (1 - t) * (1 - t) * inverseMass[j] + t * t * inverseMass[k] : perMass[B];
      let across = along;
      if (A >= 0) {
        const dx = x[i] - bodyX[A];
        const dy = y[i] - bodyY[A];
        const lever = dx * ny - dy * nx;
        const other = dx * nx + dy * ny;
        along += lever * lever * inverseInertia[A];
        across += other * other * inverseInertia[A];
      }
      if (B >= 0) {
        const dx = x[j] + t * (x[k] - x[j]) - bodyX[B];
        const dy = y[j] + t * (y[k] - y[j]) - bodyY[B];
        const lever = dx * ny - dy * nx;
        const other = dx * nx + dy * ny;
        along += lever * lever * inverseInertia[B];
        across += other * other * inverseInertia[B];
      }
      mass[c] = 1 / along;
      tangentMass[r] = 1 / across;
    }
  }

  #list(
    start: number,
    end: number,
    contacts: ContactBuffer,
    { second, ofBody }: ContactRows,
    bodies: RigidMotion,
  ): void {
    for (let c = start; c < end; c++) {
      const A = bodies.bodyOf(contacts.a[c]);
      const B = bodies.bodyOf(second[c]);
      if (A < 0 && B < 0) continue;
      ofBody[c] = 1;
      if (A === B) continue; // a body does not touch itself
      if (this.count === this.row.length) growColumns(this, this.count * 2);
      const r = this.count++;
      this.row[r] = c;
      this.bodyA[r] = A;
      this.bodyB[r] = B;
    }
  }
}
