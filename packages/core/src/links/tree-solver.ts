import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { aimLinks } from './aim-links.ts';
import { eliminateStiff, substituteStiff } from './solve-stiff-tree.ts';
import {
  eliminate,
  FAILED,
  GAIN,
  PUSHES,
  ROUGH,
  ROW,
  SWIFT,
  substitute,
  TENSION,
  type TreeTable,
  undo,
} from './solve-tree.ts';
import type { StiffTable } from './stiff-table.ts';
import { kineticEnergy, TreeMotion } from './tree-motion.ts';

/** How often a tree is solved anew without the links that push where they can only pull. */
const ROUNDS = 8;

/** Share of its energy of motion that a tree may gain at once, that it may gain in all, and that losses make up for. */
const MOST_AT_ONCE = 0.05;
const MOST_IN_ALL = 0.01;
const MOST_CREDIT = 0.05;

/**
 * Solves trees, each in the quickest way that will do: plain links by `eliminate`; all others, and tensions that swing their ends
 * swiftly, by `eliminateStiff`. Where links turn far in a small step, a second pass makes it accurate. What adds energy, as too
 * coarse a step does, is undone, and the tree is solved in the way that takes energy out.
 */
export class TreeSolver {
  readonly #table: TreeTable;
  readonly #stiff: StiffTable;
  readonly #motion: TreeMotion = new TreeMotion();
  /** 1 where `eliminate` knows all links of the tree. */
  readonly plain: Uint8Array;
  readonly #swift: Uint8Array;
  /** What solving has added to the energy of a tree, less what it took out. Unit: J. */
  readonly #gained: Float64Array;
  // The tree that is being solved.
  #tree = 0;
  #from = 0;
  #to = 0;
  #h = 0;
  /** 1 if tensions come on top of those that are there, 0 if they begin anew. */
  #kept = 0;
  #isPlain = false;

  constructor(table: TreeTable, stiff: StiffTable, trees: number) {
    this.#table = table;
    this.#stiff = stiff;
    this.plain = new Uint8Array(trees);
    this.#swift = new Uint8Array(trees);
    this.#gained = new Float64Array(trees);
  }

  /**
   * Solves a tree. Reads x, y, vx, vy. Writes vx, vy, and the tensions.
   * @param kept - 1 if tensions come on top of those that are there, 0 if they begin anew.
   */
  solve(tree: number, from: number, to: number, particles: ParticleArrays, h: number, kept: number): void {
    this.#tree = tree;
    this.#from = from;
    this.#to = to;
    this.#h = h;
    this.#kept = kept;
    this.#isPlain = this.plain[tree] === 1 && this.#swift[tree] === 0;
    if (!this.#isPlain) this.#prepare(particles, kept);
    const result = this.#eliminate(particles);
    if (result === FAILED || !(result === ROUGH ? this.#tryTwice(particles) : this.#try(particles)))
      this.#solveCalmly(particles);
  }

  /** One pass. Returns whether it is good; if not, it is undone. */
  #try(particles: ParticleArrays): boolean {
    if (!this.#isPlain) this.#motion.save(this.#table, this.#from, this.#to, particles);
    const found = this.#substitute(particles, this.#kept);
    if (this.#accepts(this.#table.rows[this.#from * ROW + GAIN], particles)) {
      if ((found & PUSHES) !== 0) this.#release(particles, 0);
      return true;
    }
    if (this.#isPlain) undo(this.#table, this.#from, this.#to, particles);
    else this.#motion.restore(this.#table, this.#from, this.#to, particles);
    return false;
  }

  /** A pass that is an approximation, and one that makes it accurate. */
  #tryTwice(particles: ParticleArrays): boolean {
    const { rows } = this.#table;
    this.#motion.save(this.#table, this.#from, this.#to, particles);
    this.#substitute(particles, this.#kept);
    let gain = rows[this.#from * ROW + GAIN];
    if (this.#eliminate(particles) !== FAILED) {
      const found = this.#substitute(particles, 1);
      gain += rows[this.#from * ROW + GAIN];
      if (this.#accepts(gain, particles)) {
        if ((found & PUSHES) !== 0) this.#release(particles, 0);
        return true;
      }
    }
    this.#motion.restore(this.#table, this.#from, this.#to, particles);
    return false;
  }

  /** The way that takes energy out, and is stable whatever comes. */
  #solveCalmly(particles: ParticleArrays): void {
    if (this.#isPlain) this.#prepare(particles, this.#kept);
    this.#isPlain = false;
    eliminateStiff(this.#table, this.#stiff, this.#from, this.#to, particles, this.#h, 1);
    const found = this.#substitute(particles, 1);
    this.#gained[this.#tree] += Math.min(0, this.#table.rows[this.#from * ROW + GAIN]);
    if ((found & PUSHES) !== 0) this.#release(particles, 1);
  }

  /** Solves the tree again without the links that push where they can only pull, or pull where they can only push. */
  #release(particles: ParticleArrays, calm: number): void {
    if (this.#isPlain) this.#prepare(particles, 1);
    this.#isPlain = false;
    const { rows } = this.#table;
    const { side } = this.#stiff;
    let found = PUSHES;
    for (let round = 0; (found & PUSHES) !== 0 && round < ROUNDS; round++) {
      for (let k = this.#from + 1; k < this.#to; k++) {
        if (side[k] < 2 && side[k] * rows[k * ROW + TENSION] < 0) side[k] = 0;
      }
      const result = eliminateStiff(this.#table, this.#stiff, this.#from, this.#to, particles, this.#h, calm);
      if (result === FAILED) eliminateStiff(this.#table, this.#stiff, this.#from, this.#to, particles, this.#h, 1);
      found = this.#substitute(particles, 1);
    }
  }

  /** Whether a gain of energy is no more than what the method itself wavers by; if so, it is booked. */
  #accepts(gain: number, particles: ParticleArrays): boolean {
    let gained = this.#gained[this.#tree];
    if (!(gain <= 0)) {
      const energy = kineticEnergy(this.#table, this.#from, this.#to, particles);
      gained = Math.max(gained, -MOST_CREDIT * energy);
      if (!(gain <= MOST_AT_ONCE * energy && gained + gain <= MOST_IN_ALL * energy)) return false;
    }
    this.#gained[this.#tree] = gained + gain;
    return true;
  }

  #prepare(particles: ParticleArrays, kept: number): void {
    const { rows } = this.#table;
    const { before } = this.#stiff;
    for (let k = this.#from + 1; k < this.#to; k++) {
      before[k] = rows[k * ROW + TENSION];
      rows[k * ROW + TENSION] *= kept;
    }
    aimLinks(this.#table, this.#stiff, this.#from, this.#to, particles, this.#h);
  }

  #eliminate(particles: ParticleArrays): number {
    return this.#isPlain
      ? eliminate(this.#table, this.#from, this.#to, particles, this.#h)
      : eliminateStiff(this.#table, this.#stiff, this.#from, this.#to, particles, this.#h, 0);
  }

  #substitute(particles: ParticleArrays, kept: number): number {
    const found = this.#isPlain
      ? substitute(this.#table, this.#from, this.#to, particles, this.#h, kept)
      : substituteStiff(this.#table, this.#stiff, this.#from, this.#to, particles, this.#h);
    this.#swift[this.#tree] = found & SWIFT;
    return found;
  }
}
