import type { Vec2 } from '../math/vec2.ts';
import type { MotionArrays } from '../particles/motion-arrays.ts';

/**
 * Moves every particle on by one step and clears the force accumulators.
 * Reads x, y, vx, vy, fx, fy, ax, ay, inverseMass, damping. Writes x, y, vx, vy, fx, fy.
 * @returns Whether every position and velocity came out finite.
 */
export type Integrator = (particles: MotionArrays, gravity: Readonly<Vec2>, dt: number) => boolean;

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
  if (particles.accelerated) accelerateConstantly(particles, dt);
  if (!particles.damped) return accelerateAndMove(particles, gravity, dt);
  accelerate(particles, gravity, dt);
  damp(particles, dt);
  return move(particles, dt);
};

/**
 * Explicit Euler in the order of the thesis: p' = p + v·dt with the old velocity, then v' = (v + a·dt)·d^dt. It gains
 * energy on every swing of a spring (a factor of 1 + ω²·dt² a step): here for comparison, and for scenes that must match it.
 */
export const explicitEuler: Integrator = (particles, gravity, dt) => {
  const finite = move(particles, dt);
  if (particles.accelerated) accelerateConstantly(particles, dt);
  accelerate(particles, gravity, dt);
  if (particles.damped) damp(particles, dt);
  return finite && finiteVelocities(particles);
};

/** v' = v + a·dt for the constant acceleration a. Reads ax, ay, inverseMass. Writes vx, vy. */
export function accelerateConstantly({ count, vx, vy, ax, ay, inverseMass }: MotionArrays, dt: number): void {
  for (let i = 0; i < count; i++) {
    const h = inverseMass[i] === 0 ? 0 : dt; // whatever is immovable keeps its velocity
    vx[i] += ax[i] * h;
    vy[i] += ay[i] * h;
  }
}

/** v' = v + (g + F/m)·dt. Reads fx, fy, inverseMass. Writes vx, vy; clears fx, fy. */
export function accelerate(
  { count, vx, vy, fx, fy, inverseMass }: MotionArrays,
  gravity: Readonly<Vec2>,
  dt: number,
): void {
  const { x: gx, y: gy } = gravity;
  for (let i = 0; i < count; i++) {
    const w = inverseMass[i];
    const h = w === 0 ? 0 : dt;
    vx[i] = vx[i] + (gx + fx[i] * w) * h + FLUSH - FLUSH;
    vy[i] = vy[i] + (gy + fy[i] * w) * h + FLUSH - FLUSH;
  }
  fx.fill(0, 0, count);
  fy.fill(0, 0, count);
}

/**
 * v' = v·d^dt. Particles of one damping in a row share one look at the powers, and no call stands inside the inner loop: with
 * one there, V8 reads every array's address anew for each particle. Reads damping, inverseMass. Writes vx, vy.
 */
export function damp({ count, vx, vy, damping, inverseMass, dampingPowers }: MotionArrays, dt: number): void {
  dampingPowers.prepare(damping.length, dt);
  const { bases, powers } = dampingPowers;
  for (let i = 0; i < count; ) {
    const d = damping[i];
    if (bases[i] !== d) dampingPowers.compute(i, damping);
    const kept = powers[i];
    for (; i < count && damping[i] === d; i++) {
      const k = inverseMass[i] === 0 ? 1 : kept;
      vx[i] = vx[i] * k + FLUSH - FLUSH;
      vy[i] = vy[i] * k + FLUSH - FLUSH;
    }
    if (Number.isNaN(d)) vx[i++] = NaN; // it equals nothing, not even itself: on to the next, and the sweep names this one
  }
}

/** p' = p + v·dt. Reads vx, vy. Writes x, y. Tells whether all positions are finite: if not, their sum is not. */
export function move({ count, x, y, vx, vy }: MotionArrays, dt: number): boolean {
  let sum = 0;
  for (let i = 0; i < count; i++) {
    x[i] += vx[i] * dt;
    y[i] += vy[i] * dt;
    sum += x[i] + y[i];
  }
  return sum - sum === 0;
}

/** `accelerate` and `move` in one pass over the arrays, with the same result, for a third less time. */
function accelerateAndMove(particles: MotionArrays, gravity: Readonly<Vec2>, dt: number): boolean {
  const { count, x, y, vx, vy, fx, fy, inverseMass } = particles;
  const { x: gx, y: gy } = gravity;
  let sum = 0;
  for (let i = 0; i < count; i++) {
    const w = inverseMass[i];
    const h = w === 0 ? 0 : dt;
    const u = vx[i] + (gx + fx[i] * w) * h + FLUSH - FLUSH;
    const v = vy[i] + (gy + fy[i] * w) * h + FLUSH - FLUSH;
    const px = x[i] + u * dt;
    const py = y[i] + v * dt;
    vx[i] = u;
    vy[i] = v;
    x[i] = px;
    y[i] = py;
    sum += px + py;
  }
  fx.fill(0, 0, count);
  fy.fill(0, 0, count);
  return sum - sum === 0;
}

/** Whether all velocities are finite. Reads vx, vy. */
function finiteVelocities({ count, vx, vy }: MotionArrays): boolean {
  let sum = 0;
  for (let i = 0; i < count; i++) sum += vx[i] + vy[i];
  return sum - sum === 0;
}
