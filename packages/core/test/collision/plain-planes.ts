import type { Resolver } from '@mass/core';

/** Small steps in one step, and passes over the contacts in each: enough that planes hold to rounding. */
const SMALL_STEPS = 4;
const PASSES = 60;

/**
 * A resolver for tests of what the shapes report: contacts with scenery alone, each a hard plane that a particle may come up to and not
 * pass, solved until nothing changes. What is given back is given back as the step ends.
 */
export function plainPlanes(): Resolver {
  return {
    name: 'plain planes',
    step({ particles, contacts, sources, gravity }, dt) {
      const { count, x, y, vx, vy, inverseMass } = particles;
      contacts.lookAhead = dt;
      contacts.margin = Math.hypot(gravity.x, gravity.y) * dt * dt;
      sources.gather(contacts, dt);
      const { a, normalX: nx, normalY: ny, penetration, restitution, impulse } = contacts;
      const rows = Array.from({ length: contacts.count }, (_, c) => c);
      const atFirst = rows.map((c) => vx[a[c]] * nx[c] + vy[a[c]] * ny[c]);
      const offset = rows.map((c) => -penetration[c] - x[a[c]] * nx[c] - y[a[c]] * ny[c]);
      const h = dt / SMALL_STEPS;
      for (let k = 0; k < SMALL_STEPS; k++) {
        for (let i = 0; i < count; i++) {
          vx[i] += inverseMass[i] === 0 ? 0 : gravity.x * h;
          vy[i] += inverseMass[i] === 0 ? 0 : gravity.y * h;
        }
        const held = rows.map(() => 0);
        for (let n = 0; n < PASSES * rows.length; n++) {
          const c = n % rows.length;
          const i = a[c];
          const gap = offset[c] + x[i] * nx[c] + y[i] * ny[c];
          const speed = vx[i] * nx[c] + vy[i] * ny[c];
          const push = Math.max(-held[c], -speed - (gap > 0 ? gap / h : Math.max(-3, (0.2 * gap) / h)));
          held[c] += push;
          impulse[c] += push;
          vx[i] += push * nx[c];
          vy[i] += push * ny[c];
        }
        for (let i = 0; i < count; i++) {
          x[i] += vx[i] * h;
          y[i] += vy[i] * h;
        }
      }
      for (const c of rows) {
        const speed = vx[a[c]] * nx[c] + vy[a[c]] * ny[c];
        const back = Math.max(0, -speed - restitution[c] * atFirst[c]);
        if (impulse[c] === 0 || restitution[c] === 0) continue;
        vx[a[c]] += back * nx[c];
        vy[a[c]] += back * ny[c];
      }
      return true;
    },
  };
}
