import { particleOf } from '../particles/end.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { type Group, GroupSolver } from './group-solver.ts';
import { layOutForests } from './lay-out-forests.ts';
import type { LimitedLink } from './limited-link.ts';
import type { LinkSolver } from './link.ts';
import { linkGraph } from './link-graph.ts';
import { spanningForests } from './spanning-forests.ts';
import { straighten } from './straighten.ts';
import { ANY, PLAIN, RODS } from './tree-solver.ts';
import { DAMPING, GIVE, GOAL, INVERSE_MASS, MASS, NODE, ROW, SUM, TENSION, TOTAL, TreeTable } from './tree-table.ts';

/** Makes what keeps links of limited length in the sub-step resolver. */
export function forestSolver(): LinkSolver {
  return new ForestSolver();
}

/**
 * Keeps links by solving the trees that they make, each directly and in linear time. Loops are dealt out to several forests,
 * solved one after the other. Tensions are not carried on there: along links that turn, that adds energy.
 */
class ForestSolver implements LinkSolver {
  readonly #table = new TreeTable();
  #links: readonly LimitedLink[] = [];
  #groups: readonly Group[] = [];
  #solvers: readonly GroupSolver[] = [];
  /** 1 for each node that could move when the trees were laid out. */
  #movable = new Uint8Array(0);
  /** Slots of the particles whose links are in no tree, because neither end could move. */
  #idle: number[] = [];
  #impulse = new Float64Array(0);

  get impulse(): Float64Array {
    const { rowCount, link, rows, maxLength } = this.#table;
    for (let k = 0; k < rowCount; k++) {
      if (link[k] >= 0) this.#impulse[link[k]] = rows[k * ROW + TOTAL] * maxLength[k];
    }
    return this.#impulse;
  }

  setLinks(links: readonly LimitedLink[], particles: ParticleArrays): void {
    const tensions = this.#tensionsOf(links);
    const graph = linkGraph(links, particles);
    const table = this.#table;
    this.#groups = layOutForests(table, links, graph, spanningForests(graph));
    this.#solvers = this.#groups.map((group) => new GroupSolver(table, group));
    this.#links = links;
    this.#idle = links.flatMap(({ a, b }, l) =>
      (graph.near[l] < 0 ? [a, b] : []).flatMap((end) => particleOf(end)?.slot ?? []),
    );
    const { rowCount, nodeCount, link, rows, slot } = table;
    this.#movable = new Uint8Array(nodeCount);
    this.#impulse = new Float64Array(links.length);
    for (let k = 0; k < rowCount; k++) {
      rows[k * ROW + TENSION] = link[k] < 0 ? 0 : tensions[link[k]];
      rows[k * ROW + SUM] = 0;
    }
    for (let n = 0; n < nodeCount; n++) {
      this.#movable[n] = slot[n] >= 0 && particles.inverseMass[slot[n]] > 0 ? 1 : 0;
    }
  }

  begin(particles: ParticleArrays): void {
    if (!this.#fits(particles)) this.setLinks(this.#links, particles);
    const { rowCount, rows } = this.#table;
    for (let k = 0; k < rowCount; k++) rows[k * ROW + TOTAL] = 0;
    for (let g = 0; g < this.#groups.length; g++) {
      const { trees, from, to } = this.#groups[g];
      const solver = this.#solvers[g];
      solver.awake = this.#readNodes(from, to, particles);
      if (solver.awake && this.#areWound(trees[0], trees[trees.length - 1])) {
        this.#readLinks(trees[0], trees[trees.length - 1], solver);
      }
    }
  }

  solve(particles: ParticleArrays, h: number): void {
    const solvers = this.#solvers;
    for (let g = 0; g < solvers.length; g++) if (solvers[g].awake) solvers[g].solve(particles, h);
  }

  finish(particles: ParticleArrays): void {
    const solvers = this.#solvers;
    for (let g = 0; g < solvers.length; g++) if (solvers[g].awake) solvers[g].finish(particles);
  }

  straighten(particles: ParticleArrays): void {
    for (let g = 0; g < this.#groups.length; g++) {
      const { trees } = this.#groups[g];
      if (this.#solvers[g].awake) straighten(this.#table, trees[0], trees[trees.length - 1], particles);
    }
  }

  /** Whether the same ends can move as when the trees were laid out. */
  #fits({ inverseMass }: ParticleArrays): boolean {
    const { nodeCount, slot } = this.#table;
    for (let n = 0; n < nodeCount; n++) {
      if (slot[n] >= 0 && inverseMass[slot[n]] > 0 !== (this.#movable[n] === 1)) return false;
    }
    for (let i = 0; i < this.#idle.length; i++) if (inverseMass[this.#idle[i]] > 0) return false;
    return true;
  }

  /** Reads the inverse masses of nodes. Returns whether any can move now. */
  #readNodes(from: number, to: number, { mass, inverseMass, asleep }: ParticleArrays): boolean {
    const { slot, nodes } = this.#table;
    let awake = false;
    for (let n = from; n < to; n++) {
      const s = slot[n];
      const w = s >= 0 && asleep[s] === 0 ? inverseMass[s] : 0;
      nodes[n * NODE + INVERSE_MASS] = w;
      nodes[n * NODE + MASS] = w > 0 ? mass[s] : 0;
      if (w > 0) awake = true;
    }
    return awake;
  }

  /** Whether the limits of some link were changed. */
  #areWound(from: number, to: number): boolean {
    const { link, minLength, maxLength } = this.#table;
    for (let k = from; k < to; k++) {
      if (link[k] < 0) continue;
      const { minLength: min, maxLength: max } = this.#links[link[k]];
      if (min !== minLength[k] || max !== maxLength[k]) return true;
    }
    return false;
  }

  #readLinks(from: number, to: number, solver: GroupSolver): void {
    const { link: numbers, minLength, maxLength, restitution, side, rows } = this.#table;
    solver.kind = PLAIN;
    solver.elastic = solver.breakable = false;
    for (let k = from; k < to; k++) {
      if (numbers[k] < 0) continue;
      const link = this.#links[numbers[k]];
      minLength[k] = link.minLength;
      maxLength[k] = link.maxLength;
      restitution[k] = link.restitution;
      rows[k * ROW + GOAL] = link.maxLength;
      rows[k * ROW + GIVE] = link.compliance;
      rows[k * ROW + DAMPING] = link.damping;
      side[k] = link.minLength === link.maxLength ? 2 : 0;
      if (side[k] !== 2) solver.kind = ANY;
      else if (solver.kind === PLAIN && link.compliance + link.damping > 0) solver.kind = RODS;
      if (link.compliance > 0) solver.elastic = true;
      if (link.breaksAt !== undefined) solver.breakable = true;
    }
  }

  /** The tensions that links had, for a list in which some came or went; it keeps the order. */
  #tensionsOf(links: readonly LimitedLink[]): Float64Array {
    const { rowCount, link, rows } = this.#table;
    const old = new Float64Array(this.#links.length);
    for (let k = 0; k < rowCount; k++) if (link[k] >= 0) old[link[k]] = rows[k * ROW + TENSION];
    const tensions = new Float64Array(links.length);
    for (let l = 0, o = 0; l < links.length && o < old.length; l++, o++) {
      while (o < old.length && this.#links[o] !== links[l]) o++;
      if (o < old.length) tensions[l] = old[o];
    }
    return tensions;
  }
}
