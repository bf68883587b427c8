import {
  requireFinite,
  requireNonNegative,
  requireOptions,
  requirePositive,
  requirePositiveOrInfinite,
} from '../math/checks.ts';
import { requireParticle } from '../particles/membership.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';

/** How a pointer drags. */
export interface PointerSpringOptions {
  /** Swings per second that the spring would make undamped: how tightly it follows. Unit: Hz. @default 5 */
  frequency?: number;
  /** 1 comes to rest without overshoot, less swings, 0 swings on. @default 1 */
  dampingRatio?: number;
  /** Greatest force: what it can lift and tear. Unit: N. @default 1000 for each kilogram of the particle held */
  maxForce?: number;
}

const TAU = 6.283185307179586;
const MAX_FORCE_PER_KILOGRAM = 1000;

/**
 * Drags a particle by a damped spring to a point that moves, such as a pointer or a finger: one for each. Stiffness and
 * damping follow from the particle's mass, so that 10 g and 10 t behave alike. A pinned particle stays.
 *
 * The force is the one that the spring has at the end of the step (implicit), solved for the particle alone: with k = m·ω²
 * and c = 2·m·ζ·ω, F = -(k·(x - target + h·v) + c·v) / (1 + h·(c + h·k) / m). It is stable at any step and frequency
 * (E. Catto, *Soft Constraints*, GDC 2011: the effective mass of a soft constraint).
 *
 * @example
 * ```ts
 * const hand = world.addForce(new PointerSpring());
 * hand.grab(ball);         // pointer down
 * hand.moveTo(2.5, 1);     // pointer move, in metres
 * hand.release();          // pointer up
 * ```
 */
export class PointerSpring implements ForceGenerator {
  readonly frequency: number;
  readonly dampingRatio: number;
  /** Greatest force; undefined for 1000 N for each kilogram of the particle held. Unit: N. */
  readonly maxForce: number | undefined;
  #held: Particle | undefined;
  #x = 0;
  #y = 0;
  #fx = 0;
  #fy = 0;

  constructor(options: PointerSpringOptions = {}) {
    requireOptions('PointerSpring', 'options', options, '{ frequency: 5 }');
    const { frequency = 5, dampingRatio = 1, maxForce } = options;
    requirePositive('PointerSpring', 'frequency', frequency, 'hertz');
    requireNonNegative('PointerSpring', 'dampingRatio', dampingRatio, '');
    if (maxForce !== undefined) requirePositiveOrInfinite('PointerSpring', 'maxForce', maxForce, 'newtons');
    this.frequency = frequency;
    this.dampingRatio = dampingRatio;
    this.maxForce = maxForce;
  }

  /** The particle that is held; none after `release`, or when it was removed. */
  get held(): Particle | undefined {
    return this.#held?.alive ? this.#held : undefined;
  }

  /** Where it is dragged to. Unit: m. */
  get x(): number {
    return this.#x;
  }

  /** Where it is dragged to, up. Unit: m. */
  get y(): number {
    return this.#y;
  }

  /** Horizontal force of the last step. Unit: N. */
  get fx(): number {
    return this.held ? this.#fx : 0;
  }

  /** Vertical force of the last step, up. Unit: N. */
  get fy(): number {
    return this.held ? this.#fy : 0;
  }

  /** Takes hold of a particle where it is, and lets go of the one held before. */
  grab(particle: Particle): void {
    requireParticle('PointerSpring.grab', particle);
    this.#x = particle.x;
    this.#y = particle.y;
    this.#fx = this.#fy = 0;
    this.#held = particle;
  }

  /** Moves the point that the particle is dragged to; without one that is held it does nothing. Unit: m. */
  moveTo(x: number, y: number): void {
    requireFinite('PointerSpring.moveTo', 'x', x, 'metres');
    requireFinite('PointerSpring.moveTo', 'y', y, 'metres');
    this.#x = x;
    this.#y = y;
  }

  /** Lets go. The particle keeps its velocity: it is thrown. */
  release(): void {
    this.#held = undefined;
  }

  /** Reads x, y, vx, vy, mass, inverseMass. Adds to fx, fy. */
  apply(particles: ParticleArrays, _targets: ForceTargets, dt: number): void {
    const held = this.#held;
    if (held === undefined || !held.isIn(particles)) return;
    const i = held.slot;
    if (particles.inverseMass[i] === 0) return;
    const { x, y, vx, vy, mass, fx, fy } = particles;
    const omega = TAU * this.frequency;
    const k = omega * omega; // stiffness and damping for each kilogram
    const c = 2 * this.dampingRatio * omega;
    const soft = 1 / (1 + dt * (c + dt * k));
    const ax = (k * (this.#x - x[i] - dt * vx[i]) - c * vx[i]) * soft;
    const ay = (k * (this.#y - y[i] - dt * vy[i]) - c * vy[i]) * soft;
    const force = mass[i] * Math.sqrt(ax * ax + ay * ay);
    const limit = this.maxForce ?? mass[i] * MAX_FORCE_PER_KILOGRAM;
    const m = force > limit ? mass[i] * (limit / force) : mass[i];
    this.#fx = m * ax;
    this.#fy = m * ay;
    fx[i] += this.#fx;
    fy[i] += this.#fy;
  }
}
