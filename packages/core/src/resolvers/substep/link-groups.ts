import type { ContactSources } from '../../contacts/contact-sources.ts';
import type { RigidMotion } from '../../contacts/solver/rigid-motion.ts';
import type { Link, LinkSolver } from '../../links/link.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { ParticleStore } from '../../particles/particle-store.ts';

/** The links of a world that say who keeps them, each kind with its solver. */
export class LinkGroups {
  readonly #solvers = new Map<() => LinkSolver, LinkSolver>();
  #list: LinkSolver[] = [];
  /** Where the links of each solver stand among all links. */
  #numbers: number[][] = [];
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

  /** Rigid bodies that links make. */
  get bodies(): RigidMotion | undefined {
    return this.#list.find(({ bodies }) => bodies !== undefined)?.bodies;
  }

  /** Reads x, y, vx, vy, inverseMass. Writes vx, vy. */
  solve(particles: ParticleArrays, h: number): void {
    for (let s = 0; s < this.#list.length; s++) this.#list[s].solve(particles, h);
  }

  /** Adds what links held in the last step, in the order of all links. Unit: N·s. */
  addImpulses(sources: ContactSources, impulses: Float64Array): void {
    if (this.#version !== sources.linkVersion) return;
    for (let s = 0; s < this.#list.length; s++) {
      const { impulse } = this.#list[s];
      const numbers = this.#numbers[s];
      for (let l = 0; l < numbers.length; l++) impulses[numbers[l]] += Math.abs(impulse[l]);
    }
  }

  /** Goes on with the velocities at the end of the small step. Writes vx, vy. */
  finish(particles: ParticleArrays): void {
    for (let s = 0; s < this.#list.length; s++) this.#list[s].finish?.(particles);
  }

  /** Undoes by position what contacts have done to the lengths. Writes x, y. */
  straighten(particles: ParticleArrays): void {
    for (let s = 0; s < this.#list.length; s++) this.#list[s].straighten?.(particles);
  }

  #sort(all: readonly Link[], particles: ParticleArrays): void {
    const groups = new Map<() => LinkSolver, number[]>();
    for (let l = 0; l < all.length; l++) {
      const { solver } = all[l];
      if (solver === undefined) continue;
      const group = groups.get(solver);
      if (group === undefined) groups.set(solver, [l]);
      else group.push(l);
    }
    this.#list = [];
    this.#numbers = [...groups.values()];
    for (const [make, numbers] of groups) {
      const links = numbers.map((l) => all[l]);
      const solver = this.#solvers.get(make) ?? make();
      this.#solvers.set(make, solver);
      solver.setLinks(links, particles);
      this.#list.push(solver);
    }
  }
}
