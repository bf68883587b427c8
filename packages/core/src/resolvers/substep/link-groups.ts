import type { ContactSources } from '../../contacts/contact-sources.ts';
import type { Link, LinkSolver } from '../../links/link.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { ParticleStore } from '../../particles/particle-store.ts';

/** The links of a world that say who keeps them, each kind with its solver. */
export class LinkGroups {
  readonly #solvers = new Map<() => LinkSolver, LinkSolver>();
  #list: LinkSolver[] = [];
  #version = -1;
  #sleepVersion = 0;

  /** Sorts the links out, if any came or went or who sleeps has changed, and begins a step. */
  begin(sources: ContactSources, particles: ParticleStore): void {
    if (this.#version !== sources.linkVersion || this.#sleepVersion !== particles.sleepVersion) {
      this.#version = sources.linkVersion;
      this.#sleepVersion = particles.sleepVersion;
      this.#sort(sources.links, particles);
    }
    for (let s = 0; s < this.#list.length; s++) this.#list[s].begin(particles);
  }

  /** Reads x, y, vx, vy, inverseMass. Writes vx, vy. */
  solve(particles: ParticleArrays, h: number): void {
    for (let s = 0; s < this.#list.length; s++) this.#list[s].solve(particles, h);
  }

  #sort(all: readonly Link[], particles: ParticleArrays): void {
    const groups = new Map<() => LinkSolver, Link[]>();
    for (const link of all) {
      if (link.solver === undefined) continue;
      const group = groups.get(link.solver);
      if (group === undefined) groups.set(link.solver, [link]);
      else group.push(link);
    }
    this.#list = [];
    for (const [make, links] of groups) {
      const solver = this.#solvers.get(make) ?? make();
      this.#solvers.set(make, solver);
      solver.setLinks(links, particles);
      this.#list.push(solver);
    }
  }
}
