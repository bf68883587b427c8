import { type ContactBuffer, NO_EDGE } from '../../contacts/contact-buffer.ts';
import { growColumns } from '../../math/columns.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';

/**
 * The contacts with edges as the solver walks over them: the second of two is a place on an edge, whose position and velocity are
 * (1 - t) times those of one end and t times those of the other. What it holds is shared between the ends in the same way, so that
 * momentum and angular momentum are kept. All else is as in `ContactRows`.
 */
export class EdgeRows {
  count = 0;
  /** Slots of the particle and of the two ends. */
  a: Int32Array = new Int32Array(16);
  b: Int32Array = new Int32Array(16);
  e: Int32Array = new Int32Array(16);
  /** Where on the edge, 0 at b and 1 at e. */
  share: Float64Array = new Float64Array(16);
  normalX: Float64Array = new Float64Array(16);
  normalY: Float64Array = new Float64Array(16);
  /** The gap is this plus (x_a - (1 - t)·x_b - t·x_e)·n. Unit: m. */
  offset: Float64Array = new Float64Array(16);
  /** One over w_a + (1 - t)²·w_b + t²·w_e. Unit: kg. */
  mass: Float64Array = new Float64Array(16);
  friction: Float64Array = new Float64Array(16);
  restitution: Float64Array = new Float64Array(16);
  /** 1 where the two touched in the step before. */
  lasting: Uint8Array = new Uint8Array(16);
  /** Separating velocity, negative, with which the two hit each other in the step; 0 where they did not. Unit: m/s. */
  closing: Float64Array = new Float64Array(16);
  /** Impulses of one small step, along the normal and the tangent (normalY, -normalX). Unit: N·s. */
  normal: Float64Array = new Float64Array(16);
  tangent: Float64Array = new Float64Array(16);
  /** Index of the contact. */
  contact: Int32Array = new Int32Array(16);

  /**
   * Reads the contacts, their impulses of a small step, and x, y, inverseMass. Writes the rows.
   * @param from - First contact to look at; the rows of those before it are kept.
   */
  build(contacts: ContactBuffer, before: Impulses, { x, y, inverseMass }: ParticleArrays, from: number): void {
    const { count, a, b, normalX, normalY, edgeEnd, edgeShare } = contacts;
    let r = from === 0 ? 0 : this.count;
    for (let c = from; c < count; c++) {
      const k = edgeEnd[c];
      if (k === NO_EDGE) continue;
      if (r === this.a.length) growColumns(this, r * 2);
      const i = a[c];
      const j = b[c];
      const t = edgeShare[c];
      const w = inverseMass[i] + (1 - t) * (1 - t) * inverseMass[j] + t * t * inverseMass[k];
      if (w === 0) continue;
      const nx = normalX[c];
      const ny = normalY[c];
      const dx = x[i] - x[j] - t * (x[k] - x[j]);
      const dy = y[i] - y[j] - t * (y[k] - y[j]);
      this.a[r] = i;
      this.b[r] = j;
      this.e[r] = k;
      this.share[r] = t;
      this.normalX[r] = nx;
      this.normalY[r] = ny;
      this.offset[r] = -contacts.penetration[c] - dx * nx - dy * ny;
      this.mass[r] = 1 / w;
      this.friction[r] = contacts.friction[c];
      this.restitution[r] = contacts.restitution[c];
      this.lasting[r] = before.lasting[c];
      this.closing[r] = before.closing[c];
      this.normal[r] = before.normal[c];
      this.tangent[r] = before.tangent[c];
      this.contact[r++] = c;
      before.normal[c] = before.tangent[c] = 0; // until `report`
    }
    this.count = r;
  }

  /** Adds what the rows hold to velocities. Reads the impulses, inverseMass. */
  addTo(vx: Float64Array, vy: Float64Array, { inverseMass }: ParticleArrays): void {
    const { count, a, b, e, share, normalX, normalY, normal, tangent } = this;
    for (let r = 0; r < count; r++) {
      const px = normal[r] * normalX[r] + tangent[r] * normalY[r];
      const py = normal[r] * normalY[r] - tangent[r] * normalX[r];
      const wi = inverseMass[a[r]];
      const wj = inverseMass[b[r]] * (1 - share[r]);
      const wk = inverseMass[e[r]] * share[r];
      vx[a[r]] += px * wi;
      vy[a[r]] += py * wi;
      vx[b[r]] -= px * wj;
      vy[b[r]] -= py * wj;
      vx[e[r]] -= px * wk;
      vy[e[r]] -= py * wk;
    }
  }

  /** Takes the impulses of the last small step off the sums: the pass that follows counts them again. */
  uncount({ impulse, tangentImpulse }: ContactBuffer): void {
    for (let r = 0; r < this.count; r++) {
      impulse[this.contact[r]] -= this.normal[r];
      tangentImpulse[this.contact[r]] -= this.tangent[r];
    }
  }

  /** Hands the impulses of a small step back. */
  report({ normal, tangent, closing }: Impulses): void {
    for (let r = 0; r < this.count; r++) {
      normal[this.contact[r]] = this.normal[r];
      tangent[this.contact[r]] = this.tangent[r];
      closing[this.contact[r]] = this.closing[r];
    }
  }
}

/** Impulses of a small step and closing speeds, by contact. */
type Impulses = Readonly<Record<'normal' | 'tangent' | 'closing', Float64Array>> & { readonly lasting: Uint8Array };
