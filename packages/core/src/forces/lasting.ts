import { requirePositive } from '../math/checks.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';
import { requireGenerator } from './require-generator.ts';

/** A force generator that ends after a time: what `lasting` makes. */
export class Lasting implements ForceGenerator {
  readonly generator: ForceGenerator;
  /** How long it acts in all. Unit: s. */
  readonly duration: number;
  #start = -1;
  #left: number;
  #fx: Float64Array = new Float64Array(0);
  #fy: Float64Array = new Float64Array(0);

  /** @internal */
  constructor(generator: ForceGenerator, duration: number) {
    this.generator = generator;
    this.duration = duration;
    this.#left = duration;
  }

  /** Time left: all of it until the first step, 0 when it has ended. Unit: s. */
  get remaining(): number {
    return this.#left;
  }

  /** Whether it acts no more. */
  get ended(): boolean {
    return this.#left === 0;
  }

  /** Has it act for its whole duration again, from the next step on. */
  restart(): void {
    this.#start = -1;
    this.#left = this.duration;
  }

  /** In the step within which it ends, it acts with the share of its force that the rest of its time is of the step. */
  apply(particles: ParticleArrays, targets: ForceTargets, dt: number, time: number): void {
    if (this.#fx.length < particles.fx.length) {
      this.#fx = new Float64Array(particles.fx.length);
      this.#fy = new Float64Array(particles.fx.length);
    }
    if (this.#start < 0) this.#start = time;
    const left = this.#start + this.duration - time;
    const rounding = dt * 1e-9; // times are sums of steps: what is left by rounding alone is taken along, not kept for a step
    this.#left = left <= dt + rounding ? 0 : left - dt;
    if (this.#left > 0) this.generator.apply(particles, targets, dt, time);
    else if (left > rounding) this.#applyShare(left / dt, particles, targets, dt, time);
  }

  /** Over all particles, not over the targets alone: the generator may act on others too. */
  #applyShare(share: number, particles: ParticleArrays, targets: ForceTargets, dt: number, time: number): void {
    const { count, fx, fy } = particles;
    const keptX = this.#fx;
    const keptY = this.#fy;
    for (let i = 0; i < count; i++) {
      keptX[i] = fx[i];
      keptY[i] = fy[i];
      fx[i] = 0;
      fy[i] = 0;
    }
    this.generator.apply(particles, targets, dt, time);
    for (let i = 0; i < count; i++) {
      fx[i] = keptX[i] + share * fx[i];
      fy[i] = keptY[i] + share * fy[i];
    }
  }
}

/**
 * A force that ends: any generator, for a number of seconds from the first step that it takes part in. The impulse is exactly
 * that of the duration, even where it ends within a step.
 * @param duration - How long it acts, more than 0. Unit: s.
 *
 * @example
 * ```ts
 * const gust = world.addForce(lasting(new Wind({ velocity: { x: 20, y: 0 }, k1: 0.2 }), 1.5), leaves);
 * if (gust.ended) world.removeForce(gust);
 * ```
 */
export function lasting(generator: ForceGenerator, duration: number): Lasting {
  requireGenerator('lasting', generator);
  requirePositive('lasting', 'duration', duration, 'seconds');
  return new Lasting(generator, duration);
}
