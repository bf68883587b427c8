import { requireNonNegative, requireOptions, requirePositive } from '../math/checks.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';
import { requireGenerator } from './require-generator.ts';

/** What a force runs on. */
export interface FuelOptions {
  /** How much fuel there is, 0 or more, in whatever unit the game counts. */
  fuel: number;
  /** Fuel used for each newton-second of impulse, positive. @default 1: the fuel is counted in N·s */
  perNewtonSecond?: number;
}

/** A force generator that runs on fuel: what `fuelled` makes. */
export class Fuelled implements ForceGenerator {
  readonly generator: ForceGenerator;
  /** Fuel used for each newton-second of impulse. */
  readonly perNewtonSecond: number;
  #fuel: number;
  #fx: Float64Array = new Float64Array(0);
  #fy: Float64Array = new Float64Array(0);

  /** @internal */
  constructor(generator: ForceGenerator, fuel: number, perNewtonSecond: number) {
    this.generator = generator;
    this.perNewtonSecond = perNewtonSecond;
    this.#fuel = fuel;
  }

  /** Fuel left, 0 or more. Set it to fill up. */
  get fuel(): number {
    return this.#fuel;
  }
  set fuel(value: number) {
    requireNonNegative('Fuelled.fuel', 'fuel', value, '');
    this.#fuel = value;
  }

  /** Whether there is none left: the force is off. */
  get empty(): boolean {
    return this.#fuel === 0;
  }

  /** In the step within which the fuel runs out, each target gets the share of its force that the fuel is good for. */
  apply(particles: ParticleArrays, targets: ForceTargets, dt: number, time: number): void {
    if (this.#fuel === 0) return;
    const { fx, fy } = particles;
    const { slots, count } = targets;
    if (this.#fx.length < count) {
      this.#fx = new Float64Array(slots.length);
      this.#fy = new Float64Array(slots.length);
    }
    const keptX = this.#fx;
    const keptY = this.#fy;
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      keptX[t] = fx[i];
      keptY[t] = fy[i];
      fx[i] = 0;
      fy[i] = 0;
    }
    this.generator.apply(particles, targets, dt, time);
    const share = this.#burn(particles, targets, dt);
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      fx[i] = keptX[t] + share * fx[i];
      fy[i] = keptY[t] + share * fy[i];
    }
  }

  /** Takes the fuel of a step, and returns the share of the step that it is good for. Reads fx, fy. */
  #burn({ fx, fy }: ParticleArrays, { slots, count }: ForceTargets, dt: number): number {
    let force = 0;
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      force += Math.sqrt(fx[i] * fx[i] + fy[i] * fy[i]);
    }
    const needed = force * dt * this.perNewtonSecond;
    const fuel = this.#fuel;
    // What would be left by rounding alone is burnt along, not kept for another step. NaN fails this, and passes through.
    if (!(needed * (1 + 1e-9) >= fuel)) {
      if (needed > 0) this.#fuel = fuel - needed;
      return 1;
    }
    this.#fuel = 0;
    return needed < Infinity ? fuel / needed : 1;
  }
}

/**
 * A force that runs on fuel: any generator, until the impulse that it gave its targets (the sum of |F|·dt) has used the fuel
 * up; the last step gets what is left, so that the impulse is exactly what the fuel is good for. A force that is not finite
 * stays so: the world names it. Fuel that a failed step has burnt is not given back.
 *
 * @example
 * ```ts
 * const rocket = forEachParticle((ship) => ship.applyForce(0, ignition ? 30 : 0));
 * const engine = world.addForce(fuelled(rocket, { fuel: 200 }), [ship]);
 * if (engine.empty) land();
 * ```
 */
export function fuelled(generator: ForceGenerator, options: FuelOptions): Fuelled {
  requireGenerator('fuelled', generator);
  requireOptions('fuelled', 'options', options, '{ fuel: 200 }');
  const { fuel, perNewtonSecond = 1 } = options;
  requireNonNegative('fuelled', 'fuel', fuel, '');
  requirePositive('fuelled', 'perNewtonSecond', perNewtonSecond, '');
  return new Fuelled(generator, fuel, perNewtonSecond);
}
