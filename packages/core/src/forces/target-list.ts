import type { Particle } from '../particles/particle.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import type { ForceTargets } from './force-targets.ts';

/** Every particle of a store, those to come included. One list serves every generator that acts on all. */
export class AllTargets implements ForceTargets {
  slots: Int32Array = new Int32Array(0);
  count = 0;
  readonly #store: ParticleStore;
  #version = -1;

  constructor(store: ParticleStore) {
    this.#store = store;
  }

  particle(index: number): Particle {
    return this.#store.handle(this.slots[index]);
  }

  /** Brings the list up to date when particles came or went. Reads alive. Writes the list. */
  refresh(): void {
    const { version, capacity, count, alive } = this.#store;
    if (this.#version === version) return;
    this.#version = version;
    if (this.slots.length < capacity) this.slots = new Int32Array(capacity);
    const slots = this.slots;
    let living = 0;
    for (let i = 0; i < count; i++) {
      if (alive[i] === 1) slots[living++] = i;
    }
    this.count = living;
  }
}

/** Particles that were named one by one, in that order; a removed one drops out of itself. */
export class ChosenTargets implements ForceTargets {
  slots: Int32Array = new Int32Array(4);
  count = 0;
  readonly #store: ParticleStore;
  readonly #chosen = new Set<Particle>();
  #version = -1;
  #dirty = true;

  constructor(store: ParticleStore) {
    this.#store = store;
  }

  particle(index: number): Particle {
    return this.#store.handle(this.slots[index]);
  }

  add(particle: Particle): void {
    this.#chosen.add(particle);
    this.#dirty = true;
  }

  delete(particle: Particle): void {
    this.#dirty = this.#chosen.delete(particle) || this.#dirty;
  }

  /** Brings the list up to date when particles came or went. Reads generations. Writes the list. */
  refresh(): void {
    const { version } = this.#store;
    if (!this.#dirty && this.#version === version) return;
    this.#dirty = false;
    this.#version = version;
    if (this.slots.length < this.#chosen.size) this.slots = new Int32Array(this.#chosen.size * 2);
    let living = 0;
    for (const particle of this.#chosen) {
      if (particle.alive) this.slots[living++] = particle.slot;
      else this.#chosen.delete(particle);
    }
    this.count = living;
  }
}
