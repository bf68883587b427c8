import { type ContactBuffer, NO_EDGE, SCENERY } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';

/**
 * A contact rests when it closes no faster than the acceleration of four steps can make it. One step's worth would do if
 * contacts were found on time; found a step late, a thing at rest closes with two. A thing that bounces lower and lower
 * must at last get below the limit: explicit Euler, which adds a step's worth of speed to each hop, keeps a hop of
 * restitution c going at up to 1.5 / (1 - c) steps' worth, some 3 for c = 0.5. The last hundredth is for rounding.
 */
const RESTING_SLACK = 4.04;

/**
 * The closing speed up to which a contact rests: what the acceleration of its particles in this step, each towards the
 * other, can build. The acceleration is the total one, as the step found it. (Each on its own, not their difference: so
 * the upper of two that fell together rests on the lower that has just been stopped.)
 * Reads vx, vy, normal and the velocities before the forces acted. Writes resting.
 */
export function findRestingSpeeds(
  { count, a, b, normalX, normalY, edgeEnd, edgeShare }: ContactBuffer,
  { vx, vy }: ParticleArrays,
  before: { readonly vx: Float64Array; readonly vy: Float64Array },
  resting: Float64Array,
): void {
  const { vx: ux, vy: uy } = before;
  for (let c = 0; c < count; c++) {
    const i = a[c];
    const j = b[c];
    const nx = normalX[c];
    const ny = normalY[c];
    let speed = Math.max(0, -((vx[i] - ux[i]) * nx + (vy[i] - uy[i]) * ny));
    if (j !== SCENERY) {
      let ofSecond = (vx[j] - ux[j]) * nx + (vy[j] - uy[j]) * ny;
      const k = edgeEnd[c];
      if (k !== NO_EDGE) ofSecond += edgeShare[c] * ((vx[k] - ux[k]) * nx + (vy[k] - uy[k]) * ny - ofSecond);
      speed += Math.max(0, ofSecond);
    }
    resting[c] = speed * RESTING_SLACK;
  }
}
