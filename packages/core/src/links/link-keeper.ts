import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { forestSolver } from './forest-solver.ts';
import type { LimitedLink } from './limited-link.ts';
import type { LinkSolver } from './link.ts';
import { RigidBodies } from './rigid-bodies.ts';

/** Makes what keeps links of limited length in the sub-step resolver. */
export function linkKeeper(): LinkSolver {
  return new LinkKeeper();
}

/** Rigid bodies are moved as such; all other links are kept as the trees that they make. */
class LinkKeeper implements LinkSolver {
  readonly bodies: RigidBodies = new RigidBodies();
  readonly #forest = forestSolver();
  #links: readonly LimitedLink[] = [];
  /** Where the links of the forest stand among all. */
  #numbers: number[] = [];
  #impulse = new Float64Array(0);

  get impulse(): Float64Array {
    const { impulse } = this.#forest;
    for (let l = 0; l < this.#numbers.length; l++) this.#impulse[this.#numbers[l]] = impulse[l];
    return this.#impulse;
  }

  setLinks(links: readonly LimitedLink[], particles: ParticleArrays): void {
    const taken = this.bodies.take(links, particles);
    this.#links = links;
    this.#numbers = [...links.keys()].filter((l) => taken[l] === 0);
    this.#impulse = new Float64Array(links.length);
    this.#forest.setLinks(
      this.#numbers.map((l) => links[l]),
      particles,
    );
  }

  begin(particles: ParticleArrays): void {
    if (!this.bodies.begin(particles)) {
      this.setLinks(this.#links, particles);
      this.bodies.begin(particles);
    }
    this.#forest.begin(particles);
  }

  solve(particles: ParticleArrays, h: number): void {
    this.bodies.solve(particles, h);
    this.#forest.solve(particles, h);
  }

  finish(particles: ParticleArrays): void {
    this.#forest.finish?.(particles);
  }

  straighten(particles: ParticleArrays): void {
    this.bodies.straighten(particles);
    this.#forest.straighten?.(particles);
  }
}
