import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { shareOf } from './contact-place.ts';
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

  /** Begins with what the rows hold. Reads the contacts, the rows, inverseMass. */
  begin(contacts: ContactBuffer, rows: ContactRows, particles: ParticleArrays): void {
    const { count, inverseMass } = particles;
    if (this.#vx.length <= count) this.#reserve(count * 2 + 1);
    const vx = this.#vx;
    const vy = this.#vy;
    vx.fill(0, 0, count + 1);
    vy.fill(0, 0, count + 1);
    const { a, normalX, normalY, edgesStart, edgesEnd } = contacts;
    const { second, normal, tangent } = rows;
    for (let r = 0; r < rows.count; r++) {
      const i = a[r];
      const j = second[r];
      const px = normal[r] * normalX[r] + tangent[r] * normalY[r];
      const py = normal[r] * normalY[r] - tangent[r] * normalX[r];
      vx[i] += px * inverseMass[i];
      vy[i] += py * inverseMass[i];
      vx[j] -= px * inverseMass[j];
      vy[j] -= py * inverseMass[j];
    }
    for (let r = edgesStart; r < edgesEnd; r++) {
      const t = shareOf(contacts, r);
      if (t === 0) continue;
      // That part of it which the other end of the edge holds.
      const j = second[r];
      const k = contacts.edgeEnd[r];
      const px = t * (normal[r] * normalX[r] + tangent[r] * normalY[r]);
      const py = t * (normal[r] * normalY[r] - tangent[r] * normalX[r]);
      vx[j] += px * inverseMass[j];
      vy[j] += py * inverseMass[j];
      vx[k] -= px * inverseMass[k];
      vy[k] -= py * inverseMass[k];
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
