import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { addRest, advance, gather, measureMotion, measureStretch, scatter, scatterMean, slow } from './node-motion.ts';
import { ANY, type Kind, TreeSolver } from './tree-solver.ts';
import { CALM, ENERGY, HASTE, MOST_BACK, PIECE, ROW, SUM, TOTAL, type TreeTable } from './tree-table.ts';

/** Into how many pieces a small step is divided at most. */
const MOST = 32;
/** How many small steps long a group keeps to its pieces once fewer would do: each change of them costs energy. */
const PATIENCE = 60;
/** Fewer must do with so much to spare. */
const SPARE = 0.8;
/** What is worse than expected by this factor is done again in more pieces. */
const WORSE = 1.5;

/** Share of its length that a link may be off; beyond it, it is brought back in several small steps. */
const CORRECTION = 0.1;

/** Share of its energy that a group may gain in a small step, and in all; and the share of what is more that is taken out in each. */
const MOST_AT_ONCE = 0.25;
const MOST_IN_ALL = 0.005;
const GENTLY = 0.1;
/** Losses make up for gains up to this share. */
const MOST_CREDIT = 0.2;

/** Where a group stands in the table. */
export interface Group {
  /** First row of each of its trees, and the end of the last. */
  readonly trees: readonly number[];
  /** Its nodes. */
  readonly from: number;
  readonly to: number;
}

/**
 * Keeps what links hold together: one tree after the other, in pieces of small steps where something turns or swings faster than small
 * steps can follow. Pulling along the direction at the start of a step keeps energy as long as directions change little. Within a
 * small step, a group flies and is solved again and again; the others see the mean of its velocities, which leads to the same places, and
 * once they are reached it goes on with the last. What adds energy, as too coarse a step does, is undone, and done again in more pieces,
 * or, if nothing helps, in the way that takes energy out.
 */
export class GroupSolver {
  readonly #table: TreeTable;
  readonly #solver: TreeSolver;
  readonly #group: Group;
  /** Whether some of it can move now. */
  awake = false;
  /** What links it has. */
  kind: Kind = ANY;
  /** Whether a link gives: then it holds energy, too. */
  elastic = false;
  /** Whether a link can break: then its tensions are added up. */
  breakable = false;
  /** Pieces of the next small step. */
  #pieces = 1;
  /** How many small steps long fewer pieces would have done. */
  #spared = 0;
  #divided = false;
  /** How many pieces the small step should have been. */
  #need = 1;
  /** Energy before the small step. Unit: J. */
  #energy = 0;
  /** What solving has added to the energy, less what it took out. Unit: J. */
  #gained = 0;

  constructor(table: TreeTable, group: Group) {
    this.#table = table;
    this.#group = group;
    this.#solver = new TreeSolver(table);
  }

  /** Keeps the group for a small step of `h` seconds. Reads x, y, vx, vy. Writes vx, vy, and the tensions. */
  solve(particles: ParticleArrays, h: number): void {
    const table = this.#table;
    const { from, to } = this.#group;
    let pieces = this.#pieces;
    gather(table, from, to, particles);
    this.#measure();
    const surplus = this.#gained - MOST_IN_ALL * table.shared[ENERGY];
    const taken = surplus > 0 ? slow(table, from, to, GENTLY * surplus) : 0;
    this.#energy = table.shared[ENERGY] - taken;
    this.#gained -= taken;
    for (;;) {
      this.#run(pieces, h, 0);
      if (this.#need <= WORSE * pieces && (pieces === MOST || this.#accepts())) {
        this.#choose(pieces);
        break;
      }
      this.#undo(particles);
      if (taken > 0) slow(table, from, to, taken);
      if (pieces === MOST) {
        this.#run(MOST, h, 1);
        break;
      }
      pieces = Math.min(MOST, Math.max(2 * pieces, Math.ceil(this.#need)));
    }
    if (pieces === MOST && !this.#accepts()) slow(table, from, to, table.shared[ENERGY] - this.#energy);
    this.#divided = pieces > 1;
    if (this.#divided) scatterMean(table, from, to, particles, h);
    else scatter(table, from, to, particles);
    if (this.breakable) this.#addUp();
  }

  /** Goes on with the velocities at the end of the small step, once positions have moved on. Writes vx, vy. */
  finish(particles: ParticleArrays): void {
    if (this.#divided) addRest(this.#table, this.#group.from, this.#group.to, particles);
  }

  /** Goes through a small step in pieces. Finds out how many it should have been: `Infinity` if it was given up. */
  #run(pieces: number, h: number, calm: number): void {
    const { trees, from, to } = this.#group;
    const { shared } = this.#table;
    shared[PIECE] = h / pieces;
    shared[CALM] = calm;
    shared[MOST_BACK] = CORRECTION / pieces;
    shared[HASTE] = 0;
    this.#need = Infinity;
    for (let n = 0; n < pieces; n++) {
      for (let t = 0; t < trees.length - 1; t++) {
        if (!this.#solver.solve(trees[t], trees[t + 1], this.kind)) return;
      }
      if (pieces > 1 || this.elastic) advance(this.#table, from, to);
    }
    this.#need = pieces * Math.sqrt(shared[HASTE]);
  }

  #undo(particles: ParticleArrays): void {
    const { trees, from, to } = this.#group;
    const { rows } = this.#table;
    gather(this.#table, from, to, particles);
    for (let k = trees[0]; k < trees[trees.length - 1]; k++) rows[k * ROW + SUM] = 0;
  }

  /** Adds up the tensions. */
  #addUp(): void {
    const { trees } = this.#group;
    const { rows } = this.#table;
    for (let k = trees[0]; k < trees[trees.length - 1]; k++) {
      rows[k * ROW + TOTAL] += rows[k * ROW + SUM];
      rows[k * ROW + SUM] = 0;
    }
  }

  /** More pieces at once, fewer after a while. */
  #choose(pieces: number): void {
    const need = this.#need;
    const wanted = Math.max(1, Math.min(MOST, Math.ceil(need)));
    this.#spared = need < SPARE * (pieces - 1) ? this.#spared + 1 : 0;
    this.#pieces = wanted > pieces || this.#spared === PATIENCE ? wanted : pieces;
    if (this.#spared === PATIENCE) this.#spared = 0;
  }

  /** Measures the energy of motion, and of what gives. */
  #measure(): void {
    const { trees, from, to } = this.#group;
    measureMotion(this.#table, from, to);
    if (this.elastic) measureStretch(this.#table, trees[0], trees[trees.length - 1]);
  }

  /** Whether a gain of energy is no more than what the method itself wavers by; if so, it is booked. */
  #accepts(): boolean {
    this.#measure();
    const energy = this.#table.shared[ENERGY];
    const gain = energy - this.#energy;
    let gained = this.#gained + gain;
    if (!(gain <= 0)) {
      gained = Math.max(gained, gain - MOST_CREDIT * energy);
      if (!(gain <= MOST_AT_ONCE * energy)) return false;
    }
    this.#gained = gained;
    return true;
  }
}
