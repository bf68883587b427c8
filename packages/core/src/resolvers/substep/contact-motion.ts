import { type ContactBuffer, NO_EDGE } from '../../contacts/contact-buffer.ts';
import type { RigidMotion } from '../../links/rigid-motion.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { push } from './contact-place.ts';
import type { ContactRows } from './contact-rows.ts';

/**
 * What the contacts change of each particle's velocity in a small step. As the normals stay as they are, the next small step begins with
 * the same: a sum over the particles instead of a pass over the contacts.
 */
export class ContactMotion {
  #vx = new Float64Array(0);
  #vy = new Float64Array(0);
  /** Velocities before the contacts of this small step. Unit: m/s. */
  #beforeX = new Float64Array(0);
  #beforeY = new Float64Array(0);

  /** Begins with what the rows hold. Reads the contacts, the rows, x, y, inverseMass. */
  begin(contacts: ContactBuffer, rows: ContactRows, bodies: RigidMotion | undefined, particles: ParticleArrays): void {
    const { count, inverseMass } = particles;
    if (this.#vx.length <= count) this.#reserve(count * 2 + 1);
    const vx = this.#vx;
    const vy = this.#vy;
    vx.fill(0, 0, count + 1);
    vy.fill(0, 0, count + 1);
    const { a, normalX, normalY, edgeEnd } = contacts;
    const { second, normal, tangent, ofBody } = rows;
    for (let r = 0; r < rows.count; r++) {
      const px = normal[r] * normalX[r] + tangent[r] * normalY[r];
      const py = normal[r] * normalY[r] - tangent[r] * normalX[r];
      if (edgeEnd[r] !== NO_EDGE || ofBody[r] === 1) {
        if (normal[r] > 0) push(contacts, rows, bodies, r, px, py, particles, vx, vy);
        continue;
      }
      const i = a[r];
      const j = second[r];
      vx[i] += px * inverseMass[i];
      vy[i] += py * inverseMass[i];
      vx[j] -= px * inverseMass[j];
      vy[j] -= py * inverseMass[j];
    }
  }

  /** v += the change that the contacts made last. Writes vx, vy. */
  repeat({ count, vx, vy }: ParticleArrays): void {
    const dx = this.#vx;
    const dy = this.#vy;
    for (let i = 0; i < count; i++) {
      vx[i] += dx[i];
      vy[i] += dy[i];
    }
  }

  /** Notes the velocities before the contacts are solved. Reads vx, vy. */
  note({ count, vx, vy }: ParticleArrays): void {
    const x = this.#beforeX;
    const y = this.#beforeY;
    for (let i = 0; i < count; i++) {
      x[i] = vx[i];
      y[i] = vy[i];
    }
  }

  /** Adds what the contacts changed since. Reads vx, vy. */
  learn({ count, vx, vy }: ParticleArrays): void {
    const dx = this.#vx;
    const dy = this.#vy;
    const x = this.#beforeX;
    const y = this.#beforeY;
    for (let i = 0; i < count; i++) {
      dx[i] += vx[i] - x[i];
      dy[i] += vy[i] - y[i];
    }
  }

  #reserve(count: number): void {
    this.#vx = new Float64Array(count);
    this.#vy = new Float64Array(count);
    this.#beforeX = new Float64Array(count);
    this.#beforeY = new Float64Array(count);
  }
}
