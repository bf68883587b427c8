import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { type ContactBuffer, NO_EDGE, shareOf } from '../contact-buffer.ts';
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

  /** Begins with what the rows hold, but for those of rigid bodies. Reads the contacts, the rows, inverseMass. */
  begin(contacts: ContactBuffer, rows: ContactRows, particles: ParticleArrays): void {
    const { count } = particles;
    const room = particles.vx.length + 1; // one more, for scenery
    if (this.#vx.length < room) this.#reserve(room);
    const vx = this.#vx;
    const vy = this.#vy;
    vx.fill(0, 0, count + 1);
    vy.fill(0, 0, count + 1);
    const { inverseMass } = particles;
    const { a, normalX, normalY, edgeEnd } = contacts;
    const { second, normal, tangent, ofBody } = rows;
    for (let r = 0; r < rows.count; r++) {
      if (normal[r] === 0 || ofBody[r] === 1) continue;
      if (edgeEnd[r] !== NO_EDGE) {
        this.#add(contacts, rows, r, 1, particles);
        continue;
      }
      const i = a[r];
      const j = second[r];
      const px = normal[r] * normalX[r] + tangent[r] * normalY[r];
      const py = normal[r] * normalY[r] - tangent[r] * normalX[r];
      vx[i] += px * inverseMass[i];
      vy[i] += py * inverseMass[i];
      vx[j] -= px * inverseMass[j];
      vy[j] -= py * inverseMass[j];
    }
  }

  /** Takes out what hits did, and their impulses: what was no contact before the step does not hit again. Reads inverseMass. */
  forgetHits(contacts: ContactBuffer, rows: ContactRows, particles: ParticleArrays, resting: number): void {
    const { closing, lasting, normal, tangent, ofBody } = rows;
    for (let r = 0; r < rows.count; r++) {
      if (lasting[r] === 1 || closing[r] >= -resting || normal[r] === 0) continue;
      if (ofBody[r] === 0) this.#add(contacts, rows, r, -1, particles);
      normal[r] = tangent[r] = 0;
    }
  }

  /** Adds what a row does to the motion that is repeated, times a factor. */
  #add(
    contacts: ContactBuffer,
    { second, normal, tangent }: ContactRows,
    r: number,
    factor: number,
    { inverseMass }: ParticleArrays,
  ): void {
    const { a, normalX, normalY, edgeEnd } = contacts;
    const vx = this.#vx;
    const vy = this.#vy;
    const px = factor * (normal[r] * normalX[r] + tangent[r] * normalY[r]);
    const py = factor * (normal[r] * normalY[r] - tangent[r] * normalX[r]);
    const i = a[r];
    const j = second[r];
    const t = shareOf(contacts, r);
    const wj = inverseMass[j] * (1 - t);
    vx[i] += px * inverseMass[i];
    vy[i] += py * inverseMass[i];
    vx[j] -= px * wj;
    vy[j] -= py * wj;
    if (t === 0) return;
    const k = edgeEnd[r];
    vx[k] -= px * inverseMass[k] * t;
    vy[k] -= py * inverseMass[k] * t;
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
  note({ vx, vy }: ParticleArrays): void {
    this.#beforeX.set(vx);
    this.#beforeY.set(vy);
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
