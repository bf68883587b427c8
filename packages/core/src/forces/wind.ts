import { requireNonNegative, requireOptions, requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';

/**
 * The velocity of air at a place and a time, in m, s and m/s. It may return the same object each time, filled anew, so that
 * a step makes no garbage.
 */
export type WindVelocity = (x: number, y: number, time: number) => Readonly<Vec2>;

/** What a wind is made of. */
export interface WindOptions {
  /** Velocity of the air, or a function of place and time that gives it: gusts, eddies, a fan. Unit: m/s. */
  velocity: Readonly<Vec2> | WindVelocity;
  /** Share of the force that grows with the speed relative to the air. Unit: N·s/m. @default 0 */
  k1?: number;
  /** Share of the force that grows with the square of that speed. Unit: N·s²/m². @default 0 */
  k2?: number;
}

/**
 * Wind: drag against the motion relative to air that moves, f = -u·(k1 + k2·|u|), u = v - v_air. Alone it brings a particle
 * to the speed of the air. However light the particle and long the step, it never throws one beyond that speed: the force is at most
 * what takes the relative velocity away within the step.
 *
 * @example
 * ```ts
 * world.addForce(new Wind({ velocity: { x: 5, y: 0 }, k1: 0.2 }), leaves);
 * const air = { x: 0, y: 0 };
 * world.addForce(new Wind({ k1: 0.2, velocity: (x, y, time) => ((air.x = time % 4 < 1 ? 12 : 3), air) }), flag);
 * ```
 */
export class Wind implements ForceGenerator {
  readonly k1: number;
  readonly k2: number;
  #velocity: Readonly<Vec2> | WindVelocity;

  constructor(options: WindOptions) {
    requireOptions('Wind', 'options', options, '{ velocity: { x: 5, y: 0 }, k1: 0.1 }');
    const { velocity, k1 = 0, k2 = 0 } = options;
    requireNonNegative('Wind', 'k1', k1, 'newton-seconds per metre');
    requireNonNegative('Wind', 'k2', k2, 'newton-seconds squared per square metre');
    this.k1 = k1;
    this.k2 = k2;
    this.#velocity = checkedVelocity('Wind', velocity);
  }

  /** Velocity of the air, or the function that gives it. Unit: m/s. */
  get velocity(): Readonly<Vec2> | WindVelocity {
    return this.#velocity;
  }
  set velocity(value: Readonly<Vec2> | WindVelocity) {
    this.#velocity = checkedVelocity('Wind.velocity', value);
  }

  /** Reads x, y, vx, vy, mass. Adds to fx, fy. */
  apply(
    { x, y, vx, vy, mass, fx, fy }: ParticleArrays,
    { slots, count }: ForceTargets,
    dt: number,
    time: number,
  ): void {
    const { k1, k2 } = this;
    const velocity = this.#velocity;
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      const air = typeof velocity === 'function' ? velocity(x[i], y[i], time) : velocity;
      const ux = vx[i] - air.x;
      const uy = vy[i] - air.y;
      const k = Math.min(k1 + k2 * Math.sqrt(ux * ux + uy * uy), mass[i] / dt);
      fx[i] -= k * ux;
      fy[i] -= k * uy;
    }
  }
}

function checkedVelocity(where: string, velocity: Readonly<Vec2> | WindVelocity): Readonly<Vec2> | WindVelocity {
  if (typeof velocity === 'function') return velocity;
  requireVector(where, 'velocity', velocity, 'metres per second');
  return Object.freeze({ x: velocity.x, y: velocity.y });
}
