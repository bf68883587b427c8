import { particleOf } from '../particles/end.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { type ForestLayout, layOutForests } from './lay-out-forests.ts';
import type { LimitedLink } from './limited-link.ts';
import type { LinkSolver } from './link.ts';
import { linkGraph } from './link-graph.ts';
import { CABLE, INVERSE_MASS, LENGTH, RANGE, ROD, ROW, TENSION, TOTAL, TreeTable } from './solve-tree.ts';
import { spanningForests } from './spanning-forests.ts';
import { StiffTable } from './stiff-table.ts';
import { straighten } from './straighten.ts';
import { TreeSolver } from './tree-solver.ts';

/** Makes what keeps links of limited length in the sub-step resolver. */
export function forestSolver(): LinkSolver {
  return new ForestSolver();
}

/**
 * Keeps links by solving the trees that they make, each directly and in linear time. Loops are dealt out to several forests,
 * solved one after the other in each small step. Tensions are not carried on there: along links that turn, that adds energy.
 */
class ForestSolver implements LinkSolver {
  readonly #table = new TreeTable();
  readonly #stiff = new StiffTable();
  #links: readonly LimitedLink[] = [];
  #layout: ForestLayout = { trees: [0], groups: [0] };
  #solver: TreeSolver = new TreeSolver(this.#table, this.#stiff, 0);
  /** 1 where some of the tree can move now. */
  #awake = new Uint8Array(0);
  /** 1 for each slot that could move when the trees were laid out. */
  #movable = new Uint8Array(0);
  /** Slots of the particles whose links are in no tree, because neither end could move. */
  #idle: number[] = [];
  #impulse = new Float64Array(0);

  get impulse(): Float64Array {
    const { count, link, rows } = this.#table;
    for (let k = 0; k < count; k++)
      if (link[k] >= 0) this.#impulse[link[k]] = rows[k * ROW + TOTAL] * rows[k * ROW + LENGTH];
    return this.#impulse;
  }

  setLinks(links: readonly LimitedLink[], particles: ParticleArrays): void {
    const tensions = this.#tensionsOf(links);
    const graph = linkGraph(links, particles);
    const table = this.#table;
    this.#layout = layOutForests(table, links, graph, spanningForests(graph));
    this.#links = links;
    this.#idle = links.flatMap(({ a, b }, l) =>
      (graph.near[l] < 0 ? [a, b] : []).flatMap((end) => particleOf(end)?.slot ?? []),
    );
    const { count, link, rows, slot } = table;
    const trees = this.#layout.trees.length - 1;
    this.#stiff.clear(slot.length);
    this.#solver = new TreeSolver(table, this.#stiff, trees);
    this.#awake = new Uint8Array(trees);
    this.#movable = new Uint8Array(count);
    this.#impulse = new Float64Array(links.length);
    for (let k = 0; k < count; k++) {
      rows[k * ROW + TENSION] = link[k] < 0 ? 0 : tensions[link[k]];
      this.#movable[k] = slot[k] >= 0 && particles.inverseMass[slot[k]] > 0 ? 1 : 0;
    }
  }

  begin(particles: ParticleArrays): void {
    if (!this.#fits(particles)) this.setLinks(this.#links, particles);
    const { trees } = this.#layout;
    for (let tree = 0; tree < trees.length - 1; tree++) {
      const from = trees[tree];
      const to = trees[tree + 1];
      this.#awake[tree] = this.#readNodes(from, to, particles);
      if (this.#awake[tree] === 0 || !this.#areWound(from, to)) continue;
      this.#solver.plain[tree] = this.#readLinks(from, to);
      this.#solver.elastic[tree] = this.#stiff.compliance.subarray(from + 1, to).some((give) => give > 0) ? 1 : 0;
    }
  }

  solve(particles: ParticleArrays, h: number): void {
    const { trees } = this.#layout;
    for (let tree = 0; tree < trees.length - 1; tree++) {
      if (this.#awake[tree] === 1) this.#solver.solve(tree, trees[tree], trees[tree + 1], particles, h);
    }
  }

  straighten(particles: ParticleArrays): void {
    const { trees } = this.#layout;
    for (let tree = 0; tree < trees.length - 1; tree++) {
      if (this.#awake[tree] === 1) straighten(this.#table, this.#stiff, trees[tree], trees[tree + 1], particles);
    }
  }

  /** Whether the same ends can move as when the trees were laid out. */
  #fits({ inverseMass }: ParticleArrays): boolean {
    const { count, slot } = this.#table;
    for (let k = 0; k < count; k++) {
      if (slot[k] >= 0 && inverseMass[slot[k]] > 0 !== (this.#movable[k] === 1)) return false;
    }
    for (let i = 0; i < this.#idle.length; i++) if (inverseMass[this.#idle[i]] > 0) return false;
    return true;
  }

  /** Reads the inverse masses of a tree. Returns 1 if any of it can move now. */
  #readNodes(from: number, to: number, { inverseMass, asleep }: ParticleArrays): number {
    const { slot, rows } = this.#table;
    let awake = 0;
    for (let k = from; k < to; k++) {
      const s = slot[k];
      const w = s >= 0 && asleep[s] === 0 ? inverseMass[s] : 0;
      rows[k * ROW + INVERSE_MASS] = w;
      rows[k * ROW + TOTAL] = 0;
      if (w > 0) awake = 1;
    }
    return awake;
  }

  /** Whether the limits of some link of a tree were changed. */
  #areWound(from: number, to: number): boolean {
    const { link } = this.#table;
    const { minLength, maxLength } = this.#stiff;
    for (let k = from + 1; k < to; k++) {
      const { minLength: min, maxLength: max } = this.#links[link[k]];
      if (min !== minLength[k] || max !== maxLength[k]) return true;
    }
    return false;
  }

  /** Reads the links of a tree. Returns 1 if `eliminate` knows all of them. */
  #readLinks(from: number, to: number): number {
    const { link: numbers, kind, rows } = this.#table;
    const { minLength, maxLength, compliance, damping, restitution } = this.#stiff;
    let plain = 1;
    for (let k = from + 1; k < to; k++) {
      const link = this.#links[numbers[k]];
      const min = link.minLength;
      const max = link.maxLength;
      minLength[k] = min;
      maxLength[k] = max;
      rows[k * ROW + LENGTH] = max;
      kind[k] = min === max ? ROD : min > 0 ? RANGE : CABLE;
      compliance[k] = link.compliance;
      damping[k] = link.damping;
      restitution[k] = link.restitution;
      if (kind[k] === RANGE || link.compliance > 0 || link.damping > 0 || (link.restitution > 0 && kind[k] !== ROD))
        plain = 0;
    }
    return plain;
  }

  /** The tensions that links had, for a list in which some came or went; it keeps the order. */
  #tensionsOf(links: readonly LimitedLink[]): Float64Array {
    const { count, link, rows } = this.#table;
    const old = new Float64Array(this.#links.length);
    for (let k = 0; k < count; k++) if (link[k] >= 0) old[link[k]] = rows[k * ROW + TENSION];
    const tensions = new Float64Array(links.length);
    for (let l = 0, o = 0; l < links.length && o < old.length; l++, o++) {
      while (o < old.length && this.#links[o] !== links[l]) o++;
      if (o < old.length) tensions[l] = old[o];
    }
    return tensions;
  }
}
