import { aimLinks, freeLinks } from './aim-links.ts';
import { eliminate, substitute } from './solve-tree.ts';
import { CALM, NODE, ROW, SUM, type TreeTable, VX, VY } from './tree-table.ts';

/** How often a tree is solved anew without the links that push where they can only pull. */
const ROUNDS = 8;
const NUMBERS = 3;

/** Rods that neither give nor damp. */
export const PLAIN = 0;
/** Rods. */
export const RODS = 1;
/** Links of any kind. */
export const ANY = 2;
/** What links a group has. */
export type Kind = typeof PLAIN | typeof RODS | typeof ANY;

/** Solves single trees. */
export class TreeSolver {
  readonly #table: TreeTable;
  #saved = new Float64Array(0);

  constructor(table: TreeTable) {
    this.#table = table;
  }

  /** Gives the nodes of a tree velocities with which links have their lengths at the end of the piece. Returns whether it could. */
  solve(from: number, to: number, kind: Kind): boolean {
    const table = this.#table;
    if (kind !== ANY) {
      if (!eliminate(table, from, to, kind === PLAIN && table.shared[CALM] === 0)) return false;
      substitute(table, from, to);
      return true;
    }
    aimLinks(table, from, to);
    this.#save(from, to);
    for (let round = 1; ; round++) {
      if (!eliminate(table, from, to, false)) return false;
      substitute(table, from, to);
      if (round === ROUNDS || !freeLinks(table, from, to)) return true;
      this.#restore(from, to);
    }
  }

  #save(from: number, to: number): void {
    const { node, rows, nodes } = this.#table;
    if (this.#saved.length < (to - from) * NUMBERS) this.#saved = new Float64Array((to - from) * NUMBERS * 2);
    const saved = this.#saved;
    for (let k = from, at = 0; k < to; k++, at += NUMBERS) {
      saved[at] = nodes[node[k] * NODE + VX];
      saved[at + 1] = nodes[node[k] * NODE + VY];
      saved[at + 2] = rows[k * ROW + SUM];
    }
  }

  #restore(from: number, to: number): void {
    const { node, rows, nodes } = this.#table;
    const saved = this.#saved;
    for (let k = from, at = 0; k < to; k++, at += NUMBERS) {
      nodes[node[k] * NODE + VX] = saved[at];
      nodes[node[k] * NODE + VY] = saved[at + 1];
      rows[k * ROW + SUM] = saved[at + 2];
    }
  }
}
