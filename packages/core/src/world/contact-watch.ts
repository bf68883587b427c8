import { type ContactBuffer, pairKey, SCENERY } from '../contacts/contact-buffer.ts';
import type { ContactSource, ContactSources } from '../contacts/contact-sources.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import type { ContactEvent, EventQueue } from './events.ts';

/** Compares the contacts of a step with those of the step before: which began, which ended? */
export class ContactWatch {
  #touching = new Map<number, ContactEvent>();
  #touchingNow = new Map<number, ContactEvent>();
  readonly #ids = new WeakMap<ContactSource, number>();
  #nextId = 0;

  /**
   * Notes first all contacts that began, then all that ended, each in the order in which they were found. Links are not
   * contacts in this sense. Reads the contacts. Adds events.
   */
  compare(contacts: ContactBuffer, sources: ContactSources, store: ParticleStore, events: EventQueue): void {
    if (!events.has('contactBegin') && !events.has('contactEnd')) {
      if (this.#touching.size > 0) this.#touching.clear(); // clearing allocates, even what is empty
      return;
    }
    const before = this.#touching;
    const now = this.#touchingNow;
    const began: ContactEvent[] = [];
    for (let c = 0; c < contacts.count; c++) {
      if (contacts.source[c] < sources.links.length) continue;
      const key = this.#key(contacts, sources, c);
      if (now.has(key)) continue;
      let event = before.get(key);
      if (event === undefined || !event.a.alive || event.b?.alive === false) {
        event = makeEvent(contacts, sources, store, c);
        began.push(event);
      } else {
        before.delete(key);
      }
      now.set(key, event);
    }
    const ended = [...before.values()];
    before.clear();
    this.#touching = now;
    this.#touchingNow = before;
    for (const event of began) events.add('contactBegin', event);
    for (const event of ended) events.add('contactEnd', event);
  }

  #key(contacts: ContactBuffer, sources: ContactSources, c: number): number {
    const a = contacts.a[c];
    const b = contacts.b[c];
    if (b !== SCENERY) return pairKey(a, b);
    const source = sources.at(contacts.source[c]);
    let id = this.#ids.get(source);
    if (id === undefined) {
      id = this.#nextId++;
      this.#ids.set(source, id);
    }
    return -1 - (id * 0x400_0000 + a);
  }
}

function makeEvent(contacts: ContactBuffer, sources: ContactSources, store: ParticleStore, c: number): ContactEvent {
  const b = contacts.b[c];
  return {
    a: store.handle(contacts.a[c]),
    b: b === SCENERY ? undefined : store.handle(b),
    source: sources.at(contacts.source[c]),
    normalX: contacts.normalX[c],
    normalY: contacts.normalY[c],
    impulse: contacts.impulse[c],
  };
}
