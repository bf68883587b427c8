import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { aimLinks } from './aim-links.ts';
import { eliminateStiff, substituteStiff } from './solve-stiff-tree.ts';
import {
  CORRECTION,
  DONE,
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
import { energyOfCorrection, kineticEnergy, slowTo, TreeMotion } from './tree-motion.ts';

/** How often a tree is solved anew without the links that push where they can only pull. */
const ROUNDS = 8;

/** Share of its energy of motion that a tree may gain at once, and that it may gain in all. */
const MOST_AT_ONCE = 0.05;
const MOST_IN_ALL = 0.01;
/** Losses make up for gains up to this share. */
const MOST_CREDIT = 0.2;

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
  /** 1 where a link of the tree gives: it may give back energy that it has taken up. */
  readonly elastic: Uint8Array;
  readonly #swift: Uint8Array;
  /** What solving has added to the energy of a tree, less what it took out. Unit: J. */
  readonly #gained: Float64Array;
  // The tree that is being solved.
  #tree = 0;
  #from = 0;
  #to = 0;
  #h = 0;

  constructor(table: TreeTable, stiff: StiffTable, trees: number) {
    this.#table = table;
    this.#stiff = stiff;
    this.plain = new Uint8Array(trees);
    this.elastic = new Uint8Array(trees);
    this.#swift = new Uint8Array(trees);
    this.#gained = new Float64Array(trees);
  }

  /** Solves a tree for a small step of `h` seconds. Reads x, y, vx, vy. Writes vx, vy, and the tensions. */
  solve(tree: number, from: number, to: number, particles: ParticleArrays, h: number): void {
    this.#tree = tree;
    this.#from = from;
    this.#to = to;
    this.#h = h;
    const plain = this.plain[tree] === 1 && this.#swift[tree] === 0;
    const tried = plain ? this.#tryPlain(particles) : PUSHES;
    if (tried === DONE) return;
    this.#prepare();
    if (tried === FAILED || !this.#tryStiff(particles, 0)) this.#tryStiff(particles, 1);
  }

  /** The quick way. Returns `DONE`, or, with all as it was, `FAILED`, or `PUSHES` where a cable would. */
  #tryPlain(particles: ParticleArrays): number {
    const table = this.#table;
    const from = this.#from;
    const to = this.#to;
    const result = eliminate(table, from, to, particles, this.#h);
    if (result === FAILED) return FAILED;
    if (result === ROUGH) this.#motion.save(table, from, to, particles);
    let found = substitute(table, from, to, particles, this.#h, 0);
    let gain = table.rows[from * ROW + GAIN];
    if (result === ROUGH && eliminate(table, from, to, particles, this.#h) !== FAILED) {
      found = substitute(table, from, to, particles, this.#h, 1);
      gain += table.rows[from * ROW + GAIN];
    }
    this.#swift[this.#tree] = found & SWIFT;
    const pushes = (found & PUSHES) !== 0;
    if (!pushes && this.#accepts(gain, particles)) return DONE;
    if (result === ROUGH) this.#motion.restore(table, from, to, particles);
    else undo(table, from, to, particles);
    return pushes ? PUSHES : FAILED;
  }

  /**
   * The way that knows everything: again and again, without the links that push where they can only pull, or pull where they can
   * only push. Returns whether it went well; if not, all is as it was.
   * @param calm - 1 takes energy out, and goes well whatever comes.
   */
  #tryStiff(particles: ParticleArrays, calm: number): boolean {
    const { rows } = this.#table;
    aimLinks(this.#table, this.#stiff, this.#from, this.#to, particles, this.#h, calm);
    this.#motion.save(this.#table, this.#from, this.#to, particles);
    for (let round = 1; ; round++) {
      const result = this.#eliminateStiff(particles, calm);
      if (result === FAILED) return false;
      let found = this.#substituteStiff(particles);
      let gain = rows[this.#from * ROW + GAIN];
      if (result === ROUGH && calm === 0 && this.#eliminateStiff(particles, calm) !== FAILED) {
        found = this.#substituteStiff(particles);
        gain += rows[this.#from * ROW + GAIN];
      }
      const released = round < ROUNDS && (found & PUSHES) !== 0 && this.#letGo();
      if (!released) {
        this.#swift[this.#tree] = found & SWIFT;
        if (this.#accepts(gain, particles)) return true;
        if (calm === 1) {
          this.#slow(gain, particles);
          return true;
        }
      }
      this.#motion.restore(this.#table, this.#from, this.#to, particles);
      if (!released) return false;
    }
  }

  /** The last resort: a tree gains no more than what brings links back takes. */
  #slow(gain: number, particles: ParticleArrays): void {
    const before = kineticEnergy(this.#table, this.#from, this.#to, particles) - gain;
    const correction = energyOfCorrection(this.#table, this.#from, this.#to, CORRECTION / this.#h);
    slowTo(Math.max(before, correction), this.#table, this.#from, this.#to, particles);
  }

  #eliminateStiff(particles: ParticleArrays, calm: number): number {
    return eliminateStiff(this.#table, this.#stiff, this.#from, this.#to, particles, this.#h, calm);
  }

  #substituteStiff(particles: ParticleArrays): number {
    return substituteStiff(this.#table, this.#stiff, this.#from, this.#to, particles, this.#h);
  }

  /** Frees the links that are on the wrong side. */
  #letGo(): boolean {
    const { side } = this.#stiff;
    const { rows } = this.#table;
    let any = false;
    for (let k = this.#from + 1; k < this.#to; k++) {
      if (side[k] === 2 || side[k] * rows[k * ROW + TENSION] >= 0) continue;
      side[k] = 0;
      any = true;
    }
    return any;
  }

  /** Whether a gain of energy is no more than what the method itself wavers by; if so, it is booked. */
  #accepts(gain: number, particles: ParticleArrays): boolean {
    let gained = this.#gained[this.#tree] + gain;
    if (!(gain <= 0) && this.elastic[this.#tree] === 0) {
      const energy = kineticEnergy(this.#table, this.#from, this.#to, particles);
      gained = Math.max(gained, gain - MOST_CREDIT * energy);
      if (!(gain <= MOST_AT_ONCE * energy && gained <= MOST_IN_ALL * energy)) return false;
    }
    this.#gained[this.#tree] = gained;
    return true;
  }

  /** Begins a small step of a stiff tree. */
  #prepare(): void {
    const { rows } = this.#table;
    const { before } = this.#stiff;
    for (let k = this.#from + 1; k < this.#to; k++) {
      before[k] = rows[k * ROW + TENSION];
      rows[k * ROW + TENSION] = 0;
    }
  }
}
