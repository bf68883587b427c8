import { growColumns } from '../../math/columns.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { ContactBuffer, SomeSlots } from '../contact-buffer.ts';

/** What a particle may go beside the way along which its contacts were looked for, as a share of its radius. */
const SLACK = 1;

/**
 * Where contacts were looked for: from each particle's place along its velocity at that time. One that is hit, turned or thrown by a
 * link within the step may leave that way: more contacts must be looked for, or it passes through what was not seen.
 */
export class ContactRange {
  readonly #seen = {
    x: new Float64Array(64),
    y: new Float64Array(64),
    wayX: new Float64Array(64),
    wayY: new Float64Array(64),
  };
  readonly #left = { bySlot: new Uint8Array(64) };
  #margin = 0;

  /** Notes where contacts are looked for now. Reads x, y, vx, vy. */
  note({ count, x, y, vx, vy }: ParticleArrays, { lookAhead, margin, only }: ContactBuffer): void {
    if (this.#seen.x.length < count) this.#reserve(count * 2);
    const seen = this.#seen;
    this.#margin = margin;
    for (let i = 0; i < count; i++) {
      if (only !== undefined && only.bySlot[i] === 0) continue;
      seen.x[i] = x[i];
      seen.y[i] = y[i];
      seen.wayX[i] = vx[i] * lookAhead;
      seen.wayY[i] = vy[i] * lookAhead;
    }
  }

  /**
   * Finds the particles that may leave their way in what is left of the step. Reads x, y, vx, vy, radius.
   * @param rest - What is left. Unit: s.
   */
  findLeft({ count, x, y, vx, vy, radius }: ParticleArrays, rest: number): SomeSlots | undefined {
    const { x: atX, y: atY, wayX, wayY } = this.#seen;
    const left = this.#left.bySlot;
    const margin = this.#margin;
    let found = false;
    left.fill(0, 0, count);
    for (let i = 0; i < count; i++) {
      const slack = SLACK * radius[i] + margin;
      const px = x[i] - atX[i] + vx[i] * rest;
      const py = y[i] - atY[i] + vy[i] * rest;
      if (Math.abs(px) + Math.abs(py) <= slack) continue;
      const wx = wayX[i];
      const wy = wayY[i];
      const ww = wx * wx + wy * wy;
      const share = ww === 0 ? 0 : Math.max(0, Math.min(1, (px * wx + py * wy) / ww));
      const ox = px - wx * share;
      const oy = py - wy * share;
      if (ox * ox + oy * oy <= slack * slack) continue;
      found = true;
      left[i] = 1;
    }
    return found ? this.#left : undefined;
  }

  #reserve(count: number): void {
    growColumns(this.#seen, count);
    growColumns(this.#left, count);
  }
}
