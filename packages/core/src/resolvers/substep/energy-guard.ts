import { NO_EDGE } from '../../contacts/contact-buffer.ts';
import { growColumns } from '../../math/columns.ts';
import { type End, particleOf } from '../../particles/end.ts';
import type { ParticleStore } from '../../particles/particle-store.ts';
import type { Simulation } from '../../world/simulation.ts';
import { Islands } from './islands.ts';

/** Share of its energy of motion that an island may gain in a step, and one that nothing touches: links that swing waver by more. */
const MOST_GAIN = 0.0005;
const MOST_GAIN_OF_FREE = 0.03;
/** A particle that has got this share of its energy in a step is looked at; and one where nothing touches. */
const SUSPICIOUS = 0.005;
const SUSPICIOUS_OF_FREE = 0.1;

/**
 * Links and contacts take energy of motion from an island or leave it as it is: they cannot add any, but for what a link that gives has stored.
 * Coarse steps can, where rods, walls and great ratios of masses meet. Here the work that they do in a step is summed, and an island that has
 * gained by it is slowed down to what it had (as in time domain passivity control, B. Hannaford and J.-H. Ryu, 2002). One that is driven from outside is
 * left alone: by something of infinite mass that moves, by what was put elsewhere between two steps, or by a link whose length was changed.
 */
export class EnergyGuard {
  readonly #islands = new Islands();
  #isOn = false;
  /** Whether it is known where everything was after the last step. */
  #isKept = false;
  readonly #table = {
    /** Twice the work done on each particle. Unit: J. */
    work: new Float64Array(0),
    // Sums over an island, at its first particle: twice the work and the energy of motion, mass, momentum.
    gain: new Float64Array(0),
    energy: new Float64Array(0),
    mass: new Float64Array(0),
    px: new Float64Array(0),
    py: new Float64Array(0),
    /** 1 where something that does not move holds or touches it. */
    held: new Uint8Array(0),
    /** 1 where something touches; 1 where something drives it. */
    touched: new Uint8Array(0),
    driven: new Uint8Array(0),
    // Where each particle was after the last step, and of which generation it was, plus 1.
    lastX: new Float64Array(0),
    lastY: new Float64Array(0),
    known: new Uint32Array(0),
  };

  /**
   * Begins a step.
   * @param isOn - Whether there is something in it that can add energy; without, all else does nothing.
   */
  begin({ count, capacity }: ParticleStore, isOn: boolean): void {
    this.#isOn = isOn;
    if (!isOn) {
      this.#isKept = false;
      return;
    }
    if (this.#table.work.length < count) growColumns(this.#table, capacity);
    this.#table.work.fill(0, 0, count);
  }

  /** Before links and contacts act. Reads vx, vy. */
  before({ count, vx, vy, mass, inverseMass }: ParticleStore): void {
    if (!this.#isOn) return;
    const { work } = this.#table;
    for (let i = 0; i < count; i++) if (inverseMass[i] > 0) work[i] -= mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]);
  }

  /** After they have. Reads vx, vy. */
  after({ count, vx, vy, mass, inverseMass }: ParticleStore): void {
    if (!this.#isOn) return;
    const { work } = this.#table;
    for (let i = 0; i < count; i++) if (inverseMass[i] > 0) work[i] += mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]);
  }

  /** Slows islands that have gained. Reads the contacts and links. Writes vx, vy. */
  settle(simulation: Simulation): void {
    if (!this.#isOn) return;
    const { particles, contacts } = simulation;
    if (!this.#isSuspicious(particles, contacts.count > 0 ? SUSPICIOUS : SUSPICIOUS_OF_FREE)) return;
    this.#islands.find(simulation);
    this.#sum(simulation);
    this.#noteHolds(simulation);
    const { count, vx, vy, inverseMass } = particles;
    const { gain, energy, mass, px, py, held, touched, driven } = this.#table;
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0) continue;
      const first = this.#islands.firstOf(i);
      const most = touched[first] === 1 ? MOST_GAIN : MOST_GAIN_OF_FREE;
      if (driven[first] === 1 || !(gain[first] > most * energy[first])) continue;
      const isFree = held[first] === 0;
      const ux = isFree ? px[first] / mass[first] : 0;
      const uy = isFree ? py[first] / mass[first] : 0;
      const own = energy[first] - mass[first] * (ux * ux + uy * uy);
      const share = own > gain[first] ? Math.sqrt(1 - gain[first] / own) : 0;
      vx[i] = ux + share * (vx[i] - ux);
      vy[i] = uy + share * (vy[i] - uy);
    }
  }

  /** Ends a step. Reads x, y. */
  keep({ count, x, y, generation }: ParticleStore): void {
    if (!this.#isOn) return;
    this.#isKept = true;
    const { lastX, lastY, known } = this.#table;
    for (let i = 0; i < count; i++) {
      lastX[i] = x[i];
      lastY[i] = y[i];
      known[i] = generation[i] + 1;
    }
  }

  /** Whether a particle moves without being moved, or was put elsewhere since the last step. */
  #drives(i: number, { particles, before }: Simulation): boolean {
    const { lastX, lastY, known } = this.#table;
    const { vx, vy, inverseMass, asleep, generation } = particles;
    if (inverseMass[i] === 0 && asleep[i] === 0 && (vx[i] !== 0 || vy[i] !== 0)) return true;
    return this.#isKept && known[i] === generation[i] + 1 && (before.x[i] !== lastX[i] || before.y[i] !== lastY[i]);
  }

  #isSuspicious({ count, vx, vy, mass, inverseMass }: ParticleStore, share: number): boolean {
    const { work } = this.#table;
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] > 0 && work[i] > share * mass[i] * (vx[i] * vx[i] + vy[i] * vy[i])) return true;
    }
    return false;
  }

  #sum(simulation: Simulation): void {
    const { count, vx, vy, mass, inverseMass } = simulation.particles;
    const table = this.#table;
    for (const column of [table.gain, table.energy, table.mass, table.px, table.py]) column.fill(0, 0, count);
    for (const column of [table.held, table.touched, table.driven]) column.fill(0, 0, count);
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0) continue;
      const first = this.#islands.firstOf(i);
      table.gain[first] += table.work[i];
      table.energy[first] += mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]);
      table.mass[first] += mass[i];
      table.px[first] += mass[i] * vx[i];
      table.py[first] += mass[i] * vy[i];
      if (this.#drives(i, simulation)) table.driven[first] = 1;
    }
  }

  /** Notes which islands something immovable touches, holds or drives, and what moving surfaces and links that give did to them. */
  #noteHolds(simulation: Simulation): void {
    const { particles, contacts, sources, before } = simulation;
    const { count, a, b, edgeEnd, impulse, tangentImpulse, surfaceSpeed } = contacts;
    const { gain, touched, driven } = this.#table;
    for (let c = 0; c < count; c++) {
      if (impulse[c] === 0) continue;
      const first = this.#join(a[c], b[c], simulation);
      if (edgeEnd[c] !== NO_EDGE) this.#join(a[c], edgeEnd[c], simulation);
      touched[first] = 1;
      gain[first] -= 2 * Math.max(0, tangentImpulse[c] * surfaceSpeed[c]);
    }
    for (const link of sources.links) {
      const first = this.#join(slotOf(link.a), slotOf(link.b), simulation);
      if (link.energyAt)
        gain[first] -= 2 * (link.energyAt(before.x, before.y) - link.energyAt(particles.x, particles.y));
      if (link.takeChange?.()) driven[first] = 1;
    }
  }

  /** Notes of two that touch or are linked, of which one may be immovable, what that does to the other. Returns the first of their island. */
  #join(i: number, j: number, simulation: Simulation): number {
    const { inverseMass } = simulation.particles;
    const { held, driven } = this.#table;
    const iMoves = i >= 0 && inverseMass[i] > 0;
    const jMoves = j >= 0 && inverseMass[j] > 0;
    const first = this.#islands.firstOf(iMoves ? i : Math.max(j, 0));
    if (iMoves && jMoves) return first;
    held[first] = 1;
    const other = iMoves ? j : i;
    if (other >= 0 && this.#drives(other, simulation)) driven[first] = 1;
    return first;
  }
}

/** The slot of an end, or -1 for a fixed point. */
function slotOf(end: End): number {
  return particleOf(end)?.slot ?? -1;
}
