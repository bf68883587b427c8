import { SCENERY } from '../../contacts/contact-buffer.ts';
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
 * gained by it is slowed down to what it had (as in time domain passivity control, B. Hannaford and J.-H. Ryu, 2002).
 */
export class EnergyGuard {
  readonly #islands = new Islands();
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
    /** 1 where something touches. */
    touched: new Uint8Array(0),
  };

  /** Begins a step. */
  begin({ count, capacity }: ParticleStore): void {
    if (this.#table.work.length < count) growColumns(this.#table, capacity);
    this.#table.work.fill(0, 0, count);
  }

  /** Before links and contacts act. Reads vx, vy. */
  before({ count, vx, vy, mass, inverseMass }: ParticleStore): void {
    const { work } = this.#table;
    for (let i = 0; i < count; i++) if (inverseMass[i] > 0) work[i] -= mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]);
  }

  /** After they have. Reads vx, vy. */
  after({ count, vx, vy, mass, inverseMass }: ParticleStore): void {
    const { work } = this.#table;
    for (let i = 0; i < count; i++) if (inverseMass[i] > 0) work[i] += mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]);
  }

  /** Slows islands that have gained. Reads the contacts and links. Writes vx, vy. */
  settle(simulation: Simulation): void {
    const { particles, contacts } = simulation;
    if (!this.#isSuspicious(particles, contacts.count > 0 ? SUSPICIOUS : SUSPICIOUS_OF_FREE)) return;
    this.#islands.find(simulation);
    this.#sum(particles);
    this.#noteHolds(simulation);
    const { count, vx, vy, inverseMass } = particles;
    const { gain, energy, mass, px, py, held, touched } = this.#table;
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0) continue;
      const first = this.#islands.firstOf(i);
      const most = touched[first] === 1 ? MOST_GAIN : MOST_GAIN_OF_FREE;
      if (!(gain[first] > most * energy[first])) continue;
      const isFree = held[first] === 0;
      const ux = isFree ? px[first] / mass[first] : 0;
      const uy = isFree ? py[first] / mass[first] : 0;
      const own = energy[first] - mass[first] * (ux * ux + uy * uy);
      const share = own > gain[first] ? Math.sqrt(1 - gain[first] / own) : 0;
      vx[i] = ux + share * (vx[i] - ux);
      vy[i] = uy + share * (vy[i] - uy);
    }
  }

  #isSuspicious({ count, vx, vy, mass, inverseMass }: ParticleStore, share: number): boolean {
    const { work } = this.#table;
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] > 0 && work[i] > share * mass[i] * (vx[i] * vx[i] + vy[i] * vy[i])) return true;
    }
    return false;
  }

  #sum({ count, vx, vy, mass, inverseMass }: ParticleStore): void {
    const table = this.#table;
    for (const column of Object.values(table)) if (column !== table.work) column.fill(0, 0, count);
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0) continue;
      const first = this.#islands.firstOf(i);
      table.gain[first] += table.work[i];
      table.energy[first] += mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]);
      table.mass[first] += mass[i];
      table.px[first] += mass[i] * vx[i];
      table.py[first] += mass[i] * vy[i];
    }
  }

  /** Notes which islands something immovable touches or holds, and what moving surfaces did to them. */
  #noteHolds({ particles, contacts, sources, before }: Simulation): void {
    const { inverseMass } = particles;
    const { count, a, b, impulse, tangentImpulse, surfaceSpeed } = contacts;
    const { gain, held, touched } = this.#table;
    for (let c = 0; c < count; c++) {
      if (impulse[c] === 0) continue;
      const first = this.#islands.firstOf(a[c]);
      touched[first] = 1;
      if (b[c] === SCENERY || inverseMass[b[c]] === 0) held[first] = 1;
      else if (inverseMass[a[c]] === 0) held[this.#islands.firstOf(b[c])] = 1;
      gain[first] -= 2 * Math.max(0, tangentImpulse[c] * surfaceSpeed[c]);
    }
    for (const link of sources.links) {
      const i = slotOf(link.a, inverseMass);
      const j = slotOf(link.b, inverseMass);
      if (i < 0 && j < 0) continue;
      const first = this.#islands.firstOf(Math.max(i, j));
      if (i < 0 || j < 0) held[first] = 1;
      if (link.energyAt)
        gain[first] -= 2 * (link.energyAt(before.x, before.y) - link.energyAt(particles.x, particles.y));
    }
  }
}

/** The slot of an end that can move, or -1. */
function slotOf(end: End, inverseMass: Float64Array): number {
  const slot = particleOf(end)?.slot ?? -1;
  return slot >= 0 && inverseMass[slot] > 0 ? slot : -1;
}
