import { wrong } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';
import type { Region } from './region.ts';
import { requireGenerator } from './require-generator.ts';

/** A force generator that is limited to a part of the world: what `inRegion` makes. */
export class InRegion implements ForceGenerator {
  readonly generator: ForceGenerator;
  readonly region: Region;
  readonly #inside = new PickedTargets();

  /** @internal */
  constructor(generator: ForceGenerator, region: Region) {
    this.generator = generator;
    this.region = region;
  }

  apply(particles: ParticleArrays, targets: ForceTargets, dt: number, time: number): void {
    this.#inside.pick(this.region, particles, targets);
    this.generator.apply(particles, this.#inside, dt, time);
  }
}

/**
 * Limits a force to a part of the world: it acts on those of its particles whose centre is in the region at the start of
 * the (sub-)step. Generators that keep particles of their own, such as `Springs`, cannot be limited so.
 * @param region - `insideBox`, `insideDisc`, `insideHalfPlane`, a game's own, or a function that says of one slot whether
 *   its particle is inside.
 *
 * @example
 * ```ts
 * const updraught = new Wind({ velocity: { x: 0, y: 6 }, k1: 0.5 });
 * world.addForce(inRegion(updraught, insideBox({ minX: 2, maxX: 4 })), gliders);
 * world.addForce(inRegion(glue, (particles, slot) => particles.group[slot] === FLY));
 * ```
 */
export function inRegion(
  generator: ForceGenerator,
  region: Region | ((particles: ParticleArrays, slot: number) => boolean),
): InRegion {
  requireGenerator('inRegion', generator);
  if (typeof region === 'function') return new InRegion(generator, fromPredicate(region));
  if (typeof region?.pick !== 'function') {
    throw wrong('inRegion', 'region must be such as insideBox makes, or a function of particles and a slot', region);
  }
  return new InRegion(generator, region);
}

function fromPredicate(isInside: (particles: ParticleArrays, slot: number) => boolean): Region {
  return {
    pick(particles, { slots, count }, picked) {
      let inside = 0;
      for (let t = 0; t < count; t++) if (isInside(particles, slots[t])) picked[inside++] = t;
      return inside;
    },
  };
}

/** Some of the targets of a generator. */
class PickedTargets implements ForceTargets {
  slots: Int32Array = new Int32Array(0);
  count = 0;
  #picked: Int32Array = new Int32Array(0);
  #from: ForceTargets | undefined;

  particle(index: number): Particle {
    return this.#from!.particle(this.#picked[index]);
  }

  pick(region: Region, particles: ParticleArrays, from: ForceTargets): void {
    if (this.slots.length < from.count) {
      this.slots = new Int32Array(from.slots.length);
      this.#picked = new Int32Array(from.slots.length);
    }
    this.#from = from;
    this.count = region.pick(particles, from, this.#picked);
    const { slots, count } = this;
    const picked = this.#picked;
    for (let t = 0; t < count; t++) slots[t] = from.slots[picked[t]];
  }
}
