import { describe, requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import { Particle } from './particle.ts';

/** What a spring or a link hangs on: a particle, or a fixed point `{ x, y }` in metres, which makes it the anchored kind. */
export type End = Particle | Readonly<Vec2>;

/** An end as it is kept: a particle that lives, or a frozen copy of the point. */
export function checkedEnd(where: string, name: string, end: End): End {
  if (end instanceof Particle) {
    if (!end.alive) {
      throw new Error(`${where}: ${name} must be a particle that is in a world; it was removed.`);
    }
    return end;
  }
  if (typeof end !== 'object' || end === null) {
    throw new TypeError(`${where}: ${name} must be a particle or a fixed point { x, y }; got ${describe(end)}.`);
  }
  requireVector(where, name, end, 'metres');
  return Object.freeze({ x: end.x, y: end.y });
}

/** The particle at an end, if it is not a fixed point. */
export function particleOf(end: End): Particle | undefined {
  return end instanceof Particle ? end : undefined;
}

/** Whether an end is still there: a fixed point always is. */
export function isEndAlive(end: End): boolean {
  return !(end instanceof Particle) || end.alive;
}
