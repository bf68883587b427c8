import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { mayPushShape } from './filter.ts';
import type { Places, Shape } from './shape.ts';
import { Sweep } from './sweep.ts';

/** Surfaces that one particle may be put back in front of in a step. */
const MOST = 4;
/** How far in front a point is put. Unit: m. */
const LEAST = 1e-3;
/** What is stopped on its way is stopped after this share of it. */
const SHORT = 0.99;

const way = new Sweep();

/**
 * The last guard: whose centre has gone through a surface, on the straight way from where the step began, is put back in front of it, and
 * loses the speed at which it went. What a hit or a link throws within a small step may go where no contact was looked for. Only who
 * went farther than half its radius can have done so. Reads the shapes, and x, y of the start. Writes x, y, vx, vy.
 */
export function keepInFront(shapes: readonly Shape[], particles: ParticleArrays, before: Places): void {
  const { count, x, y, radius, inverseMass } = particles;
  if (shapes.length === 0) return;
  for (let i = 0; i < count; i++) {
    const dx = x[i] - before.x[i];
    const dy = y[i] - before.y[i];
    if (inverseMass[i] === 0 || dx * dx + dy * dy <= (radius[i] * radius[i]) / 4) continue;
    for (let n = 0; n <= MOST; n++) if (!putBack(i, particles, before, shapes, n === MOST)) break;
  }
}

/**
 * Returns whether something was in the way.
 * @param last - Stops it on its way, short of the surface: there it is in front of all others, too.
 */
function putBack(
  i: number,
  particles: ParticleArrays,
  before: Places,
  shapes: readonly Shape[],
  last: boolean,
): boolean {
  const { x, y, vx, vy, radius } = particles;
  const dx = x[i] - before.x[i];
  const dy = y[i] - before.y[i];
  if (dx === 0 && dy === 0) return false;
  const minX = Math.min(x[i], before.x[i]);
  const maxX = Math.max(x[i], before.x[i]);
  const minY = Math.min(y[i], before.y[i]);
  const maxY = Math.max(y[i], before.y[i]);
  way.radius = 0;
  way.begin(before.x[i], before.y[i], dx, dy, 0);
  for (let s = 0; s < shapes.length; s++) {
    const shape = shapes[s];
    if (maxX < shape.minX || minX > shape.maxX || maxY < shape.minY || minY > shape.maxY) continue;
    if (!shape.oneSided && mayPushShape(particles, i, shape)) shape.sweep?.(way);
  }
  if (!(way.time < 1)) return false;
  const { normalX, normalY } = way;
  const front = Math.max(0, way.distance);
  const wanted = Math.min(front, Math.max(LEAST, radius[i] / 2)); // no farther in front than it was
  if (last) {
    x[i] = before.x[i] + SHORT * way.time * dx;
    y[i] = before.y[i] + SHORT * way.time * dy;
  } else {
    const off = wanted - front - dx * normalX - dy * normalY;
    x[i] += off * normalX;
    y[i] += off * normalY;
  }
  const closing = Math.min(0, vx[i] * normalX + vy[i] * normalY);
  vx[i] -= closing * normalX;
  vy[i] -= closing * normalY;
  return true;
}
