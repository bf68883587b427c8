import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import { growColumns } from '../math/columns.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { NeighbourGrid } from './neighbour-grid.ts';
import { PairBuffer } from './pair-buffer.ts';
import { PairRows } from './pair-rows.ts';
import { EARLY_SHARE } from './shape-contacts.ts';

/** How far a disc may go before it is loose, as a share of its radius. */
const SKIN = 0.3;

/** The list is made anew when more than this share of the discs are loose, */
const MOST_LOOSE = 1 / 8;
/** or when they must be compared with more than so many, for each disc that there is. */
const MOST_COMPARED = 8;

/**
 * Pairs of discs that may touch in the coming step, kept from step to step (L. Verlet: Computer "Experiments" on Classical Fluids,
 * 1967). Discs that have gone farther than their skins are loose: their neighbours are found anew in each step, until there are so many
 * that the whole list is.
 */
export class NeighbourList {
  /** The pairs of the coming step. */
  rows: PairRows = new PairRows();
  /** The middle of each disc's way in the coming step, and how far it reaches from there: half the way, its radius, a little more. Unit: m. */
  readonly now: Circles = circles();
  /** The same when the list was made, with the skin. */
  readonly #listed = circles();
  readonly #grid = new NeighbourGrid();
  readonly #list = new PairRows();
  /** The loose discs among themselves: which they are, and where. */
  readonly #loose = { slot: new Int32Array(0), ...circles() };
  /** 1 for the loose, by slot. */
  readonly #isLoose = { flag: new Uint8Array(0) };
  readonly #looseGrid = new NeighbourGrid();
  readonly #looseRows = new PairRows();
  readonly #merged = new PairRows();
  readonly #found = new PairBuffer();
  #version = -1;
  #linkVersion = -1;

  /** Brings the pairs up to date. Reads x, y, vx, vy, radius. Writes the pairs. Returns how many there are. */
  update(particles: ParticleArrays, contacts: ContactBuffer): number {
    const { count, version } = particles;
    if (this.now.x.length < count) this.#reserve(count * 2);
    const old = version !== this.#version || contacts.linkVersion !== this.#linkVersion;
    const loose = this.#reachOut(particles, contacts);
    if (old || !this.#follow(loose, count, contacts)) {
      this.#rebuild(particles, contacts);
      this.#version = version;
      this.#linkVersion = contacts.linkVersion;
    }
    return this.rows.first[count];
  }

  /** Finds how far each disc reaches, and which are loose: those that reach out of where they were listed. Returns how many. */
  #reachOut({ count, x, y, vx, vy, radius }: ParticleArrays, { lookAhead, margin }: ContactBuffer): number {
    const { x: nowX, y: nowY, reach } = this.now;
    const { x: listedX, y: listedY, reach: listedReach } = this.#listed;
    const { slot } = this.#loose;
    const { flag } = this.#isLoose;
    const half = lookAhead / 2;
    let loose = 0;
    for (let i = 0; i < count; i++) {
      const r = radius[i];
      const wayX = vx[i] * half;
      const wayY = vy[i] * half;
      nowX[i] = x[i] + wayX;
      nowY[i] = y[i] + wayY;
      reach[i] = r === 0 ? 0 : r * (1 + EARLY_SHARE) + margin + Math.sqrt(wayX * wayX + wayY * wayY);
      const gone = Math.abs(nowX[i] - listedX[i]) + Math.abs(nowY[i] - listedY[i]);
      flag[i] = Number(r === 0 ? listedReach[i] > 0 : gone + reach[i] > listedReach[i]);
      slot[loose] = i;
      loose += flag[i];
    }
    return loose;
  }

  /** Finds the neighbours of the loose discs, and writes the pairs, unless that is too much to do. Returns whether it was not. */
  #follow(loose: number, count: number, contacts: ContactBuffer): boolean {
    this.rows = loose === 0 ? this.#list : this.#merged;
    if (loose === 0) return true;
    if (loose > count * MOST_LOOSE) return false;
    const { slot, x, y, reach } = this.#loose;
    const { now } = this;
    const found = this.#found;
    for (let k = 0; k < loose; k++) {
      x[k] = now.x[slot[k]];
      y[k] = now.y[slot[k]];
      reach[k] = now.reach[slot[k]];
    }
    found.count = 0;
    this.#looseGrid.findPairs(loose, x, y, reach, found);
    for (let p = 0; p < found.count; p++) {
      found.a[p] = slot[found.a[p]];
      found.b[p] = slot[found.b[p]];
    }
    let compared = 0;
    for (let k = 0; k < loose && compared <= count * MOST_COMPARED; k++) {
      if (reach[k] > 0) compared += this.#grid.findAround(slot[k], x[k], y[k], reach[k], found);
    }
    if (compared > count * MOST_COMPARED) return false;
    dropLinked(found, contacts);
    this.#looseRows.sort(count, found);
    this.#merged.merge(count, this.#list, this.#isLoose.flag, this.#looseRows);
    return true;
  }

  #rebuild({ count, radius }: ParticleArrays, contacts: ContactBuffer): void {
    const { x, y, reach } = this.now;
    const { x: listedX, y: listedY, reach: listedReach } = this.#listed;
    const found = this.#found;
    for (let i = 0; i < count; i++) {
      listedX[i] = x[i];
      listedY[i] = y[i];
      listedReach[i] = reach[i] === 0 ? 0 : reach[i] + SKIN * radius[i];
    }
    found.count = 0;
    this.#grid.findPairs(count, listedX, listedY, listedReach, found);
    dropLinked(found, contacts);
    this.#list.sort(count, found);
    this.rows = this.#list;
  }

  #reserve(count: number): void {
    for (const table of [this.now, this.#listed, this.#loose, this.#isLoose]) growColumns(table, count);
  }
}

/** Where discs are and how far they reach. Unit: m. */
interface Circles {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly reach: Float64Array;
}

function circles(): Circles {
  return { x: new Float64Array(0), y: new Float64Array(0), reach: new Float64Array(0) };
}

/** Puts the lower slot of each pair first, and takes out those that a link holds. */
function dropLinked(pairs: PairBuffer, contacts: ContactBuffer): void {
  const { a, b } = pairs;
  let count = 0;
  for (let p = 0; p < pairs.count; p++) {
    const i = a[p];
    const j = b[p];
    if (i === j || contacts.areLinked(i, j)) continue;
    a[count] = Math.min(i, j);
    b[count++] = Math.max(i, j);
  }
  pairs.count = count;
}
