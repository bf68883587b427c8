import type { Engine, Simulation } from '../engine.ts';
import type { Scene } from '../scene.ts';

interface Body {
  x: number;
  y: number;
  previousX: number;
  previousY: number;
  vx: number;
  vy: number;
  fx: number;
  fy: number;
  readonly mass: number;
}

/** Gravity, drag in proportion to the speed, previous positions, semi-implicit Euler, a sweep for NaN: no more than that. */
function stepBodies(bodies: readonly Body[], gravity: number, k1: number, dt: number): void {
  for (const body of bodies) {
    body.fx -= k1 * body.vx;
    body.fy -= k1 * body.vy;
    body.previousX = body.x;
    body.previousY = body.y;
    body.vx += (body.fx / body.mass) * dt;
    body.vy += (body.fy / body.mass - gravity) * dt;
    body.x += body.vx * dt;
    body.y += body.vy * dt;
    body.fx = 0;
    body.fy = 0;
    if (!Number.isFinite(body.x + body.y)) throw new RangeError('a body is not finite');
  }
}

function build({ discs, gravity, drag, dt }: Scene): Simulation {
  const bodies = discs.map(({ x, y, vx = 0, vy = 0, mass }): Body => {
    return { x, y, vx, vy, mass, previousX: 0, previousY: 0, fx: 0, fy: 0 };
  });
  const k1 = drag?.k1 ?? 0;
  return {
    step: () => stepBodies(bodies, gravity, k1, dt),
    readPositions(into) {
      bodies.forEach(({ x, y }, i) => {
        into[2 * i] = x;
        into[2 * i + 1] = y;
      });
    },
    readVelocities(into) {
      bodies.forEach(({ vx, vy }, i) => {
        into[2 * i] = vx;
        into[2 * i + 1] = vy;
      });
    },
  };
}

/** The yardstick of free flight: what one writes by hand in a small game. */
export const objects: Engine = {
  id: 'objects',
  language: 'TypeScript',
  settings: ['a hand-written loop over an array of objects, `src/engines/objects.ts`; free flight alone'],
  cannot: { collide: 'flight alone', links: 'flight alone', crates: 'flight alone', bars: 'flight alone' },
  load: async () => build,
};
