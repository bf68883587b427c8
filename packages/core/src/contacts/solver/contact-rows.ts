import { growColumns } from '../../math/columns.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import { type ContactBuffer, SCENERY, shareOf } from '../contact-buffer.ts';

/** What the solver needs beside the contacts themselves, in the same order. A contact keeps its normal through the step. */
export class ContactRows {
  count = 0;
  /** How many did not last from the step before. */
  fresh = 0;
  /** What gravity adds to a velocity in a small step. Unit: m/s. */
  fallX = 0;
  fallY = 0;
  /** Slot of the second: scenery has that after the last particle, where nothing moves. */
  second: Int32Array = new Int32Array(64);
  /** The gap is this plus (x_a - x_b)·n, where x_b is the place on the edge. Unit: m. */
  offset: Float64Array = new Float64Array(64);
  /** One over the sum of the inverse masses, on an edge w_a + (1 - t)²·w_b + t²·w_e; 0 where nothing can move. Unit: kg. */
  mass: Float64Array = new Float64Array(64);
  /** 1 where one of the two belongs to a rigid body: `BodyRows` has these. */
  ofBody: Uint8Array = new Uint8Array(64);
  /** 1 where the two touched in the step before. */
  lasting: Uint8Array = new Uint8Array(64);
  /** Separating velocity, negative, with which the two hit each other in the step; 0 where they did not. Unit: m/s. */
  closing: Float64Array = new Float64Array(64);
  /** Impulses of one small step, along the normal and the tangent (normalY, -normalX). Unit: N·s. */
  normal: Float64Array = new Float64Array(64);
  tangent: Float64Array = new Float64Array(64);

  /** Makes room for as many rows as there are contacts. */
  reserve(count: number): void {
    if (this.second.length < count) growColumns(this, count * 2);
    this.count = count;
  }

  /** Rows that are new begin with nothing. */
  forget(from: number): void {
    this.normal.fill(0, from, this.count);
    this.tangent.fill(0, from, this.count);
    this.closing.fill(0, from, this.count);
    this.lasting.fill(0, from, this.count);
  }

  /**
   * Reads the contacts, x, y, inverseMass, and the impulses. Writes all the rest.
   * @param from - First row to write.
   */
  build(contacts: ContactBuffer, { count: slots, x, y, inverseMass }: ParticleArrays, from: number): void {
    const { count, a, b, normalX, normalY, penetration, edgesStart, edgesEnd } = contacts;
    const { second, offset, mass, ofBody, lasting, normal } = this;
    let fresh = from === 0 ? 0 : this.fresh;
    for (let c = from; c < count; c++) {
      const i = a[c];
      const j = b[c] === SCENERY ? slots : b[c];
      const nx = normalX[c];
      const ny = normalY[c];
      const w = inverseMass[i] + inverseMass[j];
      second[c] = j;
      ofBody[c] = 0;
      offset[c] = -penetration[c] - (x[i] - x[j]) * nx - (y[i] - y[j]) * ny;
      mass[c] = w === 0 ? 0 : 1 / w;
      if (normal[c] === 0 && penetration[c] < 0) lasting[c] = 0;
      fresh += 1 - lasting[c];
    }
    this.fresh = fresh;
    for (let c = Math.max(from, edgesStart); c < edgesEnd; c++) {
      const t = shareOf(contacts, c);
      if (t === 0) continue;
      const j = b[c];
      const k = contacts.edgeEnd[c];
      const w = inverseMass[a[c]] + (1 - t) * (1 - t) * inverseMass[j] + t * t * inverseMass[k];
      offset[c] += t * ((x[k] - x[j]) * normalX[c] + (y[k] - y[j]) * normalY[c]);
      mass[c] = w === 0 ? 0 : 1 / w;
    }
  }
}
