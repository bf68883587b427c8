import { EARLY_SHARE } from '../collision/shape-contacts.ts';
import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ContactSources } from '../contacts/contact-sources.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import { ContactTable } from './contact-table.ts';
import type { EventQueue } from './events.ts';

/** Compares the contacts of a step with those of the step before: which began, which ended? */
export class ContactWatch {
  readonly #table = new ContactTable();
  #step = 0;

  /**
   * Notes first all contacts that began, then all that ended, each in the order in which they were found, sensors last. Links are not
   * contacts in this sense, nor is what was looked for ahead and did not come about. What sleeps goes on touching.
   * Reads the contacts. Adds events.
   */
  compare(contacts: ContactBuffer, sources: ContactSources, store: ParticleStore, events: EventQueue): void {
    if (!events.has('contactBegin') && !events.has('contactEnd')) {
      this.#table.clear();
      return;
    }
    this.#step++;
    const { count, a, b, source, normalX, normalY, impulse, sensors } = contacts;
    const links = sources.links.length;
    for (let c = 0; c < count; c++) {
      if (source[c] < links || !touches(contacts, store, c) || this.#goesOn(a[c], b[c], source[c], sources, store))
        continue;
      this.#begin(a[c], b[c], source[c], normalX[c], normalY[c], impulse[c], sources, store, events);
    }
    for (let t = 0; t < sensors.count; t++) {
      const { a, b, source, normalX, normalY } = sensors;
      if (this.#goesOn(a[t], b[t], source[t], sources, store)) continue;
      this.#begin(a[t], b[t], source[t], normalX[t], normalY[t], 0, sources, store, events);
    }
    this.#table.keepSleeping(store, this.#step);
    this.#table.keep(this.#step, events);
  }

  /** Whether two touched in the step before; if so they do in this. Scenery is told apart by its source. */
  #goesOn(a: number, b: number, source: number, sources: ContactSources, { generation }: ParticleStore): boolean {
    const t = this.#table.find(Math.max(a, b), Math.min(a, b), generation, sources.at(source));
    if (t >= 0) this.#table.step[t] = this.#step;
    return t >= 0;
  }

  #begin(
    a: number,
    b: number,
    source: number,
    normalX: number,
    normalY: number,
    impulse: number,
    sources: ContactSources,
    store: ParticleStore,
    events: EventQueue,
  ): void {
    const other = b < 0 ? undefined : store.handle(b);
    const event = { a: store.handle(a), b: other, source: sources.at(source), normalX, normalY, impulse };
    this.#table.add(Math.max(a, b), Math.min(a, b), store.generation, this.#step, event);
    events.add('contactBegin', event);
  }
}

/** Whether two touch, or did in this step: a gap that was to be watched and stayed open does not count. */
function touches({ a, b, penetration, impulse }: ContactBuffer, { radius }: ParticleStore, c: number): boolean {
  if (impulse[c] !== 0) return true;
  const size = b[c] < 0 ? radius[a[c]] : radius[a[c]] + radius[b[c]];
  return penetration[c] >= -EARLY_SHARE * size;
}
