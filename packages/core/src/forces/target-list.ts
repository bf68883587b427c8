import type { Particle } from '../particles/particle.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import type { ForceTargets } from './force-targets.ts';

/**
 * Every particle of a store, those to come included; or those that were named one by one, in that order, of which a removed
 * one drops out of itself.
 */
export class TargetList implements ForceTargets {
  slots: Int32Array = new Int32Array(0);
  count = 0;
  readonly #store: ParticleStore;
  readonly #chosen: Set<Particle> | undefined;
  #version = -1;

  /** @param chosen - The particles that are named; without it, all. */
  constructor(store: ParticleStore, chosen?: Set<Particle>) {
    this.#store = store;
    this.#chosen = chosen;
  }

  particle(index: number): Particle {
    return this.#store.handle(this.slots[index]);
  }

  /** Names more particles; where all are meant, that changes nothing. */
  add(particles: readonly Particle[]): void {
    for (const particle of particles) this.#chosen?.add(particle);
    this.#version = -1;
  }

  delete(particles: readonly Particle[]): void {
    for (const particle of particles) this.#chosen?.delete(particle);
    this.#version = -1;
  }

  /** Brings the list up to date when particles came or went. Reads alive. Writes the list. */
  refresh(): void {
    const { version, capacity } = this.#store;
    if (this.#version === version) return;
    this.#version = version;
    const room = this.#chosen === undefined ? capacity : this.#chosen.size;
    if (this.slots.length < room) this.slots = new Int32Array(room);
    this.count = 0;
    if (this.#chosen === undefined) this.#listAll();
    else this.#listChosen(this.#chosen);
  }

  #listAll(): void {
    const { count, alive } = this.#store;
    const { slots } = this;
    let living = 0;
    for (let i = 0; i < count; i++) {
      if (alive[i] === 1) slots[living++] = i;
    }
    this.count = living;
  }

  #listChosen(chosen: Set<Particle>): void {
    for (const particle of chosen) {
      if (particle.alive) this.slots[this.count++] = particle.slot;
      else chosen.delete(particle);
    }
  }
}
