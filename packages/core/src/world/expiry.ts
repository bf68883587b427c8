import type { ParticleStore } from '../particles/particle-store.ts';
import type { SlotList } from '../particles/slot-list.ts';
import type { EventQueue } from './events.ts';

/** The particles whose lifetime ends with a step. */
export class Expiry implements SlotList {
  slots: Int32Array = new Int32Array(16);
  count = 0;
  #generations = new Uint32Array(16);

  /**
   * Takes dt off every lifetime and lists, by slot, what has less than half a step left: so a lifetime ends with the step
   * nearest to it, whatever the rounding. Reads alive. Writes lifetime and the list.
   */
  age(store: ParticleStore, dt: number): void {
    this.count = 0;
    if (!store.mortal) return;
    const { count, lifetime, generation } = store;
    if (this.slots.length < count) {
      this.slots = new Int32Array(store.capacity);
      this.#generations = new Uint32Array(store.capacity);
    }
    let mortal = false;
    for (let i = 0; i < count; i++) {
      if (lifetime[i] === Infinity) continue;
      mortal = true;
      lifetime[i] -= dt;
      if (lifetime[i] >= dt / 2) continue;
      this.slots[this.count] = i;
      this.#generations[this.count++] = generation[i];
    }
    store.mortal = mortal;
  }

  /** Notes what is on the list. Adds events. */
  note(store: ParticleStore, events: EventQueue): void {
    if (!events.has('particleExpired')) return;
    for (let e = 0; e < this.count; e++) events.add('particleExpired', { particle: store.handle(this.slots[e]) });
  }

  /** Removes what is on the list, unless it went in the meantime. Writes the store. */
  removeFrom(store: ParticleStore): void {
    for (let e = 0; e < this.count; e++) {
      const slot = this.slots[e];
      if (store.generation[slot] === this.#generations[e]) store.remove(slot);
    }
  }
}
