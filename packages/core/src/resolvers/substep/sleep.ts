import { type ContactBuffer, NO_EDGE, SCENERY } from '../../contacts/contact-buffer.ts';
import { growColumns } from '../../math/columns.ts';
import type { ParticleStore } from '../../particles/particle-store.ts';
import type { Simulation } from '../../world/simulation.ts';
import { Islands } from './islands.ts';

/** How often islands are looked for. Unit: steps. */
const EVERY = 6;
/** No island: of a particle that never slept. */
const NONE = 0;
/** No count of changes. */
const NEVER = -1;
/** Numbers of islands are used again after so many, long after the last sleeper of that number. */
const MOST_ISLANDS = 0x4000_0000;

/**
 * Puts islands to sleep: particles that touch or are linked, directly or by others, all of which have been slower than a limit for a
 * while. An island wakes as a whole.
 */
export class Sleep {
  readonly #time: number;
  readonly #speed: number;
  readonly #table = {
    /** For how long each particle has been slow. Unit: s. */
    restTime: new Float64Array(0),
    /** Of which generation it was then. */
    generation: new Uint32Array(0),
    /** By which number its island was put to sleep. */
    island: new Int32Array(0),
    /** Of the first: whether something of its island moves. */
    restless: new Uint8Array(0),
  };
  readonly #found = new Islands();
  #steps = 0;
  #islands = 1;
  /** The count of changes when everything was found asleep; negative where it was not. */
  #restedAt = NEVER;
  #seenChanges = NEVER;

  /**
   * @param time - How long an island must rest. Unit: s.
   * @param speed - Below which a particle rests. Unit: m/s.
   */
  constructor(time: number, speed: number) {
    this.#time = time;
    this.#speed = speed;
  }

  /** Whether everything sleeps and nothing has changed since. */
  isAtRest({ changes }: ParticleStore): boolean {
    return this.#restedAt === changes;
  }

  /** Wakes the rest of each island of which a particle was woken. Reads asleep. Writes asleep, inverseMass. */
  spread(particles: ParticleStore): void {
    if (particles.sleeping === 0 || particles.changes === this.#seenChanges) return;
    if (this.#table.island.length < particles.capacity) growColumns(this.#table, particles.capacity);
    const { count, asleep } = particles;
    const island = this.#table.island;
    const woken = new Set<number>();
    for (let i = 0; i < count; i++) if (island[i] !== NONE && asleep[i] === 0) woken.add(island[i]);
    for (let i = 0; i < count; i++) {
      if (!woken.has(island[i])) continue;
      particles.wake(i);
      island[i] = NONE;
      this.#table.restTime[i] = 0;
    }
    this.#seenChanges = particles.changes;
  }

  /** Wakes the islands that are touched by what is awake. Returns whether there were any. */
  wakeTouched(contacts: ContactBuffer, particles: ParticleStore): boolean {
    if (particles.sleeping === 0) return false;
    const { asleep, changes } = particles;
    const { count, a, b, edgeEnd } = contacts;
    for (let c = 0; c < count; c++) {
      if (b[c] === SCENERY) continue;
      const sleepers = asleep[a[c]] + asleep[b[c]] + (edgeEnd[c] === NO_EDGE ? 0 : asleep[edgeEnd[c]]);
      if (sleepers === 0 || !this.#disturbs(contacts, particles, c)) continue;
      for (const slot of [a[c], b[c], edgeEnd[c]]) if (slot !== NO_EDGE && asleep[slot] === 1) particles.wake(slot);
    }
    if (changes === particles.changes) return false;
    this.spread(particles);
    return true;
  }

  /**
   * Whether the two touch, or what is awake of them moves or has just woken: hit, it would meet a sleeper as if that were immovable. What is
   * only near disturbs nobody's sleep.
   */
  #disturbs({ a, b, penetration, margin }: ContactBuffer, { asleep }: ParticleStore, c: number): boolean {
    if (penetration[c] >= -margin) return true;
    const { restTime } = this.#table;
    return (asleep[a[c]] === 0 && restTime[a[c]] === 0) || (asleep[b[c]] === 0 && restTime[b[c]] === 0);
  }

  /** Puts to sleep what has come to rest. Reads vx, vy, the contacts and links. Writes asleep, inverseMass, vx, vy. */
  settle(simulation: Simulation, dt: number): void {
    const { particles } = simulation;
    if (this.#table.island.length < particles.capacity) growColumns(this.#table, particles.capacity);
    this.#measure(particles, dt);
    if (++this.#steps % EVERY !== 0) return;
    for (const { slots, count } of simulation.forces.unsteadyTargets()) {
      for (let t = 0; t < count; t++) this.#table.restTime[slots[t]] = 0;
    }
    if (isStill(particles)) {
      this.#restedAt = particles.changes;
      return;
    }
    this.#restedAt = NEVER;
    if (!this.#anyRested(particles)) return;
    this.#found.find(simulation);
    this.#putToSleep(particles);
  }

  /** Adds to the time of rest. Reads vx, vy, generation. */
  #measure({ count, vx, vy, inverseMass, generation }: ParticleStore, dt: number): void {
    const rest = this.#table.restTime;
    const known = this.#table.generation;
    const limit = this.#speed * this.#speed;
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0) continue;
      const slow = vx[i] * vx[i] + vy[i] * vy[i] < limit && known[i] === generation[i];
      rest[i] = slow ? rest[i] + dt : 0;
      known[i] = generation[i];
    }
  }

  #anyRested({ count, inverseMass }: ParticleStore): boolean {
    for (let i = 0; i < count; i++) if (inverseMass[i] !== 0 && this.#table.restTime[i] >= this.#time) return true;
    return false;
  }

  #putToSleep(particles: ParticleStore): void {
    const { count, inverseMass } = particles;
    const restless = this.#table.restless.fill(0, 0, count);
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] !== 0 && this.#table.restTime[i] < this.#time) restless[this.#found.firstOf(i)] = 1;
    }
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0 || restless[this.#found.firstOf(i)] === 1) continue;
      this.#table.island[i] = this.#islands + this.#found.firstOf(i);
      particles.sleep(i);
    }
    this.#islands = ((this.#islands + count) % MOST_ISLANDS) + 1;
  }
}

/** Whether nothing is awake that can move, and nothing else moves. Reads alive, inverseMass, vx, vy. */
function isStill({ count, inverseMass, vx, vy }: ParticleStore): boolean {
  for (let i = 0; i < count; i++) if (inverseMass[i] !== 0 || vx[i] !== 0 || vy[i] !== 0) return false;
  return true;
}
