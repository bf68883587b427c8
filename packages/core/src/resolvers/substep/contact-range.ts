import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import { growColumns } from '../../math/columns.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';

/** What a particle may go beyond the range in which its contacts were looked for, as a share of its radius. */
const SLACK = 0.5;

/**
 * How far each particle could go when contacts were looked for, by its velocity then. One that is hit, or thrown by a link, within the
 * step may go farther: contacts must be looked for again, or it passes through what was not seen.
 */
export class ContactRange {
  readonly #at = { x: new Float64Array(64), y: new Float64Array(64), range: new Float64Array(64) };

  /** Reads x, y, vx, vy, radius. */
  note({ count, x, y, vx, vy, radius }: ParticleArrays, { lookAhead, margin }: ContactBuffer): void {
    if (this.#at.x.length < count) growColumns(this.#at, count * 2);
    const { x: atX, y: atY, range } = this.#at;
    for (let i = 0; i < count; i++) {
      atX[i] = x[i];
      atY[i] = y[i];
      range[i] = (Math.abs(vx[i]) + Math.abs(vy[i])) * lookAhead + margin + SLACK * radius[i];
    }
  }

  /**
   * Whether some particle may leave its range. Reads x, y, vx, vy.
   * @param rest - What is left of the step. Unit: s.
   */
  isLeft({ count, x, y, vx, vy }: ParticleArrays, rest: number): boolean {
    const { x: atX, y: atY, range } = this.#at;
    for (let i = 0; i < count; i++) {
      const way = Math.abs(x[i] - atX[i]) + Math.abs(y[i] - atY[i]) + (Math.abs(vx[i]) + Math.abs(vy[i])) * rest;
      if (way > range[i]) return true;
    }
    return false;
  }
}
