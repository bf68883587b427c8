import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import { growColumns } from '../math/columns.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { NeighbourGrid } from './neighbour-grid.ts';
import { PairBuffer } from './pair-buffer.ts';
import { EARLY_SHARE } from './shape-contacts.ts';
import { SortedPairs } from './sorted-pairs.ts';

/** How far a disc may go before its neighbours are looked for again, as a share of its radius. */
const SKIN = 0.3;
/** For how many steps, when its neighbours are looked for, its way is taken, if it goes no farther in one than twice its radius. */
const STEPS = 3;

/** The whole list is made anew when more than this share of the discs are loose, */
const MOST_LOOSE = 1 / 8;
/** or when they must be compared with more than so many, for each disc that there is. */
const MOST_COMPARED = 8;

/**
 * Pairs of discs that may touch in the coming step, kept from step to step until one has gone farther than its skin (L. Verlet: Computer
 * "Experiments" on Classical Fluids, 1967). From then on it is loose: only its neighbours are found again, until so many are loose
 * that the whole list is made anew.
 */
export class NeighbourList {
  /** The pairs of the coming step. */
  pairs: SortedPairs = new SortedPairs();
  /** The middle of each disc's way in the coming step, and how far it reaches from there: half the way, its radius, a little more. Unit: m. */
  readonly now: Circles = circles();
  /** The same when its neighbours were looked for, with the skin. */
  readonly #listed = circles();
  readonly #grid = new NeighbourGrid();
  readonly #list = new SortedPairs();
  /** Who has just left its skin. The loose discs: which they are, where they are listed, and a flag, 1 for the loose, by slot. */
  readonly #loose = { left: new Int32Array(0), slot: new Int32Array(0), flag: new Uint8Array(0), ...circles() };
  #looseCount = 0;
  readonly #looseGrid = new NeighbourGrid();
  readonly #loosePairs = new SortedPairs();
  readonly #merged = new SortedPairs();
  readonly #found = new PairBuffer();
  #version = -1;
  #linkVersion = -1;

  /** Brings the pairs up to date. Reads x, y, vx, vy, radius. Writes the pairs. */
  update(particles: ParticleArrays, contacts: ContactBuffer): void {
    const { count, version } = particles;
    if (this.now.x.length < count) this.#reserve(count * 2);
    const old = version !== this.#version || contacts.linkVersion !== this.#linkVersion;
    const left = this.#reachOut(particles, contacts);
    if (old || (left > 0 && !this.#follow(left, particles, contacts))) {
      this.#rebuild(particles, contacts);
      this.#version = version;
      this.#linkVersion = contacts.linkVersion;
    }
  }

  /** Finds how far each disc reaches, and who reaches out of where it is listed. Returns how many do. */
  #reachOut({ count, x, y, vx, vy, radius }: ParticleArrays, { lookAhead, margin }: ContactBuffer): number {
    const { x: nowX, y: nowY, reach } = this.now;
    const { x: listedX, y: listedY, reach: listedReach } = this.#listed;
    const { left } = this.#loose;
    const half = lookAhead / 2;
    let out = 0;
    for (let i = 0; i < count; i++) {
      const r = radius[i];
      const wayX = vx[i] * half;
      const wayY = vy[i] * half;
      const far = r === 0 ? 0 : r * (1 + EARLY_SHARE) + margin + Math.abs(wayX) + Math.abs(wayY);
      const midX = x[i] + wayX;
      const midY = y[i] + wayY;
      nowX[i] = midX;
      nowY[i] = midY;
      reach[i] = far;
      const gone = r === 0 ? 0 : Math.abs(midX - listedX[i]) + Math.abs(midY - listedY[i]);
      if (gone + far > listedReach[i] || (r === 0 && listedReach[i] > 0)) left[out++] = i;
    }
    return out;
  }

  /**
   * Lists those anew that have left their skins, which are loose from now on. Finds the neighbours of all loose discs, and writes the
   * pairs, unless that is too much to do. Returns whether it was not.
   */
  #follow(left: number, particles: ParticleArrays, contacts: ContactBuffer): boolean {
    const { count } = particles;
    const most = count * MOST_COMPARED;
    const loose = this.#loosen(left, particles);
    if (loose > count * MOST_LOOSE) return false;
    const { slot, x, y, reach } = this.#loose;
    const listed = this.#listed;
    const found = this.#found;
    for (let k = 0; k < loose; k++) {
      x[k] = listed.x[slot[k]];
      y[k] = listed.y[slot[k]];
      reach[k] = listed.reach[slot[k]];
    }
    found.count = 0;
    this.#looseGrid.findPairs(loose, x, y, reach, found);
    for (let p = 0; p < found.count; p++) {
      found.a[p] = slot[found.a[p]];
      found.b[p] = slot[found.b[p]];
    }
    let compared = 0;
    for (let k = 0; k < loose && compared <= most; k++) {
      if (reach[k] > 0) compared += this.#grid.findAround(slot[k], x[k], y[k], reach[k], found);
    }
    if (compared > most) return false;
    dropLinked(found, contacts);
    this.#loosePairs.sort(count, found);
    this.#merged.merge(this.#list, this.#loose.flag, this.#loosePairs);
    this.pairs = this.#merged;
    return true;
  }

  /** Makes discs loose that have left their skins. Returns how many are. */
  #loosen(newly: number, { x, y, radius }: ParticleArrays): number {
    const { left, slot, flag } = this.#loose;
    const { now } = this;
    for (let k = 0; k < newly; k++) {
      const i = left[k];
      this.#enlist(i, now.x[i] - x[i], now.y[i] - y[i], radius[i]);
      if (flag[i] === 0) slot[this.#looseCount++] = i;
      flag[i] = 1;
    }
    return this.#looseCount;
  }

  /**
   * Notes where the neighbours of a disc are looked for: around its way in the next steps.
   * @param wayX - Half its way in the coming step. Unit: m.
   * @param wayY - Half its way in the coming step. Unit: m.
   */
  #enlist(i: number, wayX: number, wayY: number, radius: number): void {
    const { now } = this;
    const listed = this.#listed;
    const far = Math.abs(wayX) + Math.abs(wayY);
    const more = far <= radius ? STEPS - 1 : 0;
    listed.x[i] = now.x[i] + wayX * more;
    listed.y[i] = now.y[i] + wayY * more;
    listed.reach[i] = now.reach[i] + far * more + SKIN * radius;
  }

  #rebuild({ count, x, y, radius }: ParticleArrays, contacts: ContactBuffer): void {
    const { now } = this;
    const listed = this.#listed;
    const found = this.#found;
    for (let i = 0; i < count; i++) this.#enlist(i, now.x[i] - x[i], now.y[i] - y[i], radius[i]);
    this.#loose.flag.fill(0, 0, count);
    this.#looseCount = 0;
    found.count = 0;
    this.#grid.findPairs(count, listed.x, listed.y, listed.reach, found);
    dropLinked(found, contacts);
    this.#list.sort(count, found);
    this.pairs = this.#list;
  }

  #reserve(count: number): void {
    for (const table of [this.now, this.#listed, this.#loose]) growColumns(table, count);
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
