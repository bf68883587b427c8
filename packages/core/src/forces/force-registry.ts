import { absent } from '../math/checks.ts';
import { requireMembers } from '../particles/membership.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import type { ForceGenerator } from './force-generator.ts';
import type { ForceTargets } from './force-targets.ts';
import { requireGenerator } from './require-generator.ts';
import { TargetList } from './target-list.ts';

/** Which generator acts on which particles. Generators run in the order in which they were first added. */
export class ForceRegistry {
  readonly #store: ParticleStore;
  readonly #everyone: TargetList;
  readonly #targets = new Map<ForceGenerator, TargetList>();
  #generators: ForceGenerator[] = [];

  constructor(store: ParticleStore) {
    this.#store = store;
    this.#everyone = new TargetList(store);
  }

  /** The generators, in the order in which they run. */
  get list(): readonly ForceGenerator[] {
    return this.#generators;
  }

  /** Adds particles to those that a generator acts on; without a list it acts on all, those to come included. */
  add(where: string, generator: ForceGenerator, particles?: Iterable<Particle>): void {
    requireGenerator(where, generator);
    let targets = this.#everyone;
    if (particles !== undefined) {
      targets = this.#targets.get(generator) ?? new TargetList(this.#store, new Set());
      const members = requireMembers(where, particles, this.#store);
      targets.add(members);
      for (const particle of members) particle.wake();
    } else {
      this.#store.wakeAll();
    }
    this.#targets.set(generator, targets);
    this.#generators = [...this.#targets.keys()];
  }

  /** Frees particles of a generator, or takes it out where none are named. */
  remove(where: string, generator: ForceGenerator, particles?: Iterable<Particle>): void {
    const targets = this.#targets.get(generator);
    if (targets === undefined) throw absent(where, 'a force', generator);
    if (particles === undefined) {
      this.#targets.delete(generator);
      this.#generators = [...this.#targets.keys()];
      return;
    }
    if (targets === this.#everyone) {
      throw new Error(
        `${where}: the force acts on all particles; single ones cannot be freed of it. Add it with a list of particles instead.`,
      );
    }
    targets.delete(requireMembers(where, particles, this.#store));
  }

  /** What the generators act on that may push a particle at rest at any time. */
  unsteadyTargets(): readonly ForceTargets[] {
    const found: ForceTargets[] = [];
    for (const [generator, targets] of this.#targets) {
      if (generator.steady) continue;
      targets.refresh();
      found.push(targets);
    }
    return found;
  }

  /** Runs every generator. Reads what they read. Adds to fx, fy. */
  apply(dt: number, time: number): void {
    const generators = this.#generators;
    for (let g = 0; g < generators.length; g++) this.applyOne(generators[g], dt, time);
  }

  /** Adds one generator's forces to the accumulators. */
  applyOne(generator: ForceGenerator, dt: number, time: number): void {
    const targets = this.#targets.get(generator) ?? this.#everyone;
    targets.refresh();
    generator.apply(this.#store, targets, dt, time);
  }
}
