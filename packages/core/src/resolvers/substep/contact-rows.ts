import { type ContactBuffer, NO_EDGE, SCENERY } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';

/**
 * The contacts of a step as the solver walks over them, one typed array a quantity: first those of two particles, then those with
 * scenery, so that what cannot give way has the last word. A contact keeps its normal through the step.
 */
export class ContactRows {
  /** How many rows have two particles, and how many there are in all. */
  pairCount = 0;
  count = 0;
  /** Slots: scenery has that after the last particle, where nothing moves. */
  a: Int32Array = new Int32Array(0);
  b: Int32Array = new Int32Array(0);
  normalX: Float64Array = new Float64Array(0);
  normalY: Float64Array = new Float64Array(0);
  /** The gap is this plus (x_a - x_b)·n. Unit: m. */
  offset: Float64Array = new Float64Array(0);
  /** One over the sum of the inverse masses. Unit: kg. */
  mass: Float64Array = new Float64Array(0);
  friction: Float64Array = new Float64Array(0);
  surfaceSpeed: Float64Array = new Float64Array(0);
  restitution: Float64Array = new Float64Array(0);
  /** Separating velocity at the start of the step. Unit: m/s. */
  separating: Float64Array = new Float64Array(0);
  /** Impulses of one small step, along the normal and the tangent (normalY, -normalX). Unit: N·s. */
  normal: Float64Array = new Float64Array(0);
  tangent: Float64Array = new Float64Array(0);
  /** Sums of these over the step. Unit: N·s. */
  normalSum: Float64Array = new Float64Array(0);
  tangentSum: Float64Array = new Float64Array(0);
  /** Index of the contact. */
  contact: Int32Array = new Int32Array(0);

  /** Reads the contacts and x, y, vx, vy, inverseMass. Writes the rows. */
  build(contacts: ContactBuffer, particles: ParticleArrays): void {
    if (this.a.length < contacts.count) this.#reserve(contacts.count * 2);
    this.count = 0;
    this.#take(contacts, particles, false);
    this.pairCount = this.count;
    this.#take(contacts, particles, true);
  }

  #take(contacts: ContactBuffer, { count: slots, x, y, vx, vy, inverseMass }: ParticleArrays, scenery: boolean): void {
    const { count, a, b, normalX, normalY, penetration, edgeEnd, impulse, tangentImpulse } = contacts;
    let r = this.count;
    for (let c = 0; c < count; c++) {
      if ((b[c] === SCENERY) !== scenery || edgeEnd[c] !== NO_EDGE) continue;
      const i = a[c];
      const j = scenery ? slots : b[c];
      const w = inverseMass[i] + inverseMass[j];
      if (w === 0) continue;
      const nx = normalX[c];
      const ny = normalY[c];
      this.a[r] = i;
      this.b[r] = j;
      this.normalX[r] = nx;
      this.normalY[r] = ny;
      this.offset[r] = -penetration[c] - (x[i] - x[j]) * nx - (y[i] - y[j]) * ny;
      this.mass[r] = 1 / w;
      this.friction[r] = contacts.friction[c];
      this.surfaceSpeed[r] = contacts.surfaceSpeed[c];
      this.restitution[r] = contacts.restitution[c];
      this.separating[r] = (vx[i] - vx[j]) * nx + (vy[i] - vy[j]) * ny;
      this.normal[r] = impulse[c];
      this.tangent[r] = tangentImpulse[c];
      this.contact[r++] = c;
    }
    this.normalSum.fill(0, this.count, r);
    this.tangentSum.fill(0, this.count, r);
    this.count = r;
  }

  /** Hands the impulses back. Writes impulse and tangentImpulse of the contacts. */
  report({ impulse, tangentImpulse }: ContactBuffer): void {
    const { count, contact, normalSum, tangentSum } = this;
    for (let r = 0; r < count; r++) {
      impulse[contact[r]] = normalSum[r];
      tangentImpulse[contact[r]] = tangentSum[r];
    }
  }

  #reserve(count: number): void {
    this.a = new Int32Array(count);
    this.b = new Int32Array(count);
    this.contact = new Int32Array(count);
    this.normalX = new Float64Array(count);
    this.normalY = new Float64Array(count);
    this.offset = new Float64Array(count);
    this.mass = new Float64Array(count);
    this.friction = new Float64Array(count);
    this.surfaceSpeed = new Float64Array(count);
    this.restitution = new Float64Array(count);
    this.separating = new Float64Array(count);
    this.normal = new Float64Array(count);
    this.tangent = new Float64Array(count);
    this.normalSum = new Float64Array(count);
    this.tangentSum = new Float64Array(count);
  }
}
