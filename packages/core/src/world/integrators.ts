import { pow } from '../math/exact.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';

/**
 * Moves every particle on by one step and clears the force accumulators.
 * Reads x, y, vx, vy, fx, fy, ax, ay, inverseMass, damping. Writes x, y, vx, vy, fx, fy.
 */
export type Integrator = (particles: ParticleArrays, gravity: Readonly<Vec2>, dt: number) => void;

/**
 * Added to a velocity and taken away again, it leaves any velocity that matters as it is and turns one below some
 * 10⁻²¹⁶ m/s into 0: motion that decays ends, instead of going on in subnormal numbers, which cost twenty times the time.
 */
const FLUSH = 1e-200;

/**
 * Semi-implicit (symplectic) Euler: v' = (v + a·dt)·d^dt, then p' = p + v'·dt with the new velocity. The energy of a
 * swinging spring stays within a bound, as long as ω·dt < 2.
 */
export const semiImplicitEuler: Integrator = (particles, gravity, dt) => {
  const { count, x, y, vx, vy, fx, fy, ax, ay, inverseMass, damping } = particles;
  const { x: gx, y: gy } = gravity;
  let lastDamping = 1;
  let kept = 1;
  for (let i = 0; i < count; i++) {
    const w = inverseMass[i];
    if (w !== 0) {
      if (damping[i] !== lastDamping) kept = pow((lastDamping = damping[i]), dt);
      vx[i] = (vx[i] + (gx + ax[i] + fx[i] * w) * dt) * kept + FLUSH - FLUSH;
      vy[i] = (vy[i] + (gy + ay[i] + fy[i] * w) * dt) * kept + FLUSH - FLUSH;
    }
    x[i] += vx[i] * dt;
    y[i] += vy[i] * dt;
    fx[i] = 0;
    fy[i] = 0;
  }
};

/**
 * Explicit Euler in the order of the thesis: p' = p + v·dt with the old velocity, then v' = (v + a·dt)·d^dt. It gains
 * energy on every swing of a spring (about ω²·dt² a step): here for comparison, and for scenes that must match it.
 */
export const explicitEuler: Integrator = (particles, gravity, dt) => {
  const { count, x, y, vx, vy, fx, fy, ax, ay, inverseMass, damping } = particles;
  const { x: gx, y: gy } = gravity;
  let lastDamping = 1;
  let kept = 1;
  for (let i = 0; i < count; i++) {
    const w = inverseMass[i];
    x[i] += vx[i] * dt;
    y[i] += vy[i] * dt;
    if (w !== 0) {
      if (damping[i] !== lastDamping) kept = pow((lastDamping = damping[i]), dt);
      vx[i] = (vx[i] + (gx + ax[i] + fx[i] * w) * dt) * kept + FLUSH - FLUSH;
      vy[i] = (vy[i] + (gy + ay[i] + fy[i] * w) * dt) * kept + FLUSH - FLUSH;
    }
    fx[i] = 0;
    fy[i] = 0;
  }
};
