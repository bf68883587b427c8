import { requireVector, wrong } from '../math/checks.ts';
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
    throw wrong(where, `${name} must be a particle or a fixed point { x, y }`, end);
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

/** Throws unless two ends, each checked, are two different particles, or a particle and a fixed point. */
export function requireTwoEnds(where: string, a: End, b: End): void {
  if (a === b || !(a instanceof Particle || b instanceof Particle)) {
    throw new TypeError(`${where}: the ends must be two different particles, or a particle and a fixed point.`);
  }
}

/** Both ends as they are kept: two different particles, or a particle and a fixed point. */
export function checkedEnds(where: string, a: End, b: End): [End, End] {
  const ends: [End, End] = [checkedEnd(where, 'a', a), checkedEnd(where, 'b', b)];
  requireTwoEnds(where, ...ends);
  return ends;
}

/** The slot of the particle at an end, or -1 for a fixed point. A particle of another world is an error. */
export function slotOfEnd(where: string, end: End, particles: object): number {
  if (!(end instanceof Particle)) return -1;
  if (!end.isIn(particles)) {
    throw new Error(`${where}: both ends must be in the world that it acts in; one lives in another world.`);
  }
  return end.slot;
}
