import { type ContactBuffer, SCENERY } from '../contacts/contact-buffer.ts';
import type { ContactSource, ContactSources } from '../contacts/contact-sources.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import type { ContactEvent, EventQueue } from './events.ts';

/** A contact that goes on: between the same two, found by the same source. */
interface Touch {
  readonly event: ContactEvent;
  /** The step in which it was found last. */
  step: number;
}

/** Compares the contacts of a step with those of the step before: which began, which ended? */
export class ContactWatch {
  /** All that touch, in the order in which they began. */
  #touches: Touch[] = [];
  /** The same, by the lower slot of the two. */
  readonly #bySlot: (Touch[] | undefined)[] = [];
  #step = 0;

  /**
   * Notes first all contacts that began, then all that ended, each in the order in which they were found. Links are not
   * contacts in this sense. Reads the contacts. Adds events.
   */
  compare(contacts: ContactBuffer, sources: ContactSources, store: ParticleStore, events: EventQueue): void {
    if (!events.has('contactBegin') && !events.has('contactEnd')) {
      this.#forget();
      return;
    }
    this.#step++;
    const links = sources.links.length;
    for (let c = 0; c < contacts.count; c++) {
      if (contacts.source[c] >= links) this.#find(contacts, sources.at(contacts.source[c]), store, events, c);
    }
    this.#end(events);
  }

  #find(contacts: ContactBuffer, source: ContactSource, store: ParticleStore, events: EventQueue, c: number): void {
    const a = store.handle(contacts.a[c]);
    const b = contacts.b[c] === SCENERY ? undefined : store.handle(contacts.b[c]);
    const slot = lowerSlot(a, b);
    this.#bySlot[slot] ??= [];
    const touches = this.#bySlot[slot];
    for (let t = 0; t < touches.length; t++) {
      if (!isBetween(touches[t].event, a, b, source)) continue;
      touches[t].step = this.#step;
      return;
    }
    const touch = { event: makeEvent(contacts, source, store, c), step: this.#step };
    touches.push(touch);
    this.#touches.push(touch);
    events.add('contactBegin', touch.event);
  }

  /** Notes and forgets what was not found in this step. */
  #end(events: EventQueue): void {
    const touches = this.#touches;
    let kept = 0;
    for (let t = 0; t < touches.length; t++) {
      const touch = touches[t];
      if (touch.step === this.#step) {
        touches[kept++] = touch;
        continue;
      }
      const ofSlot = this.#bySlot[lowerSlot(touch.event.a, touch.event.b)];
      ofSlot?.splice(ofSlot.indexOf(touch), 1);
      events.add('contactEnd', touch.event);
    }
    touches.length = kept;
  }

  #forget(): void {
    if (this.#touches.length === 0) return;
    this.#touches.length = 0;
    this.#bySlot.length = 0;
  }
}

function lowerSlot(a: Particle, b: Particle | undefined): number {
  return b === undefined || a.slot < b.slot ? a.slot : b.slot;
}

function isBetween(event: ContactEvent, a: Particle, b: Particle | undefined, source: ContactSource): boolean {
  if (b === undefined) return event.a === a && event.b === undefined && event.source === source;
  return (event.a === a && event.b === b) || (event.a === b && event.b === a);
}

function makeEvent(contacts: ContactBuffer, source: ContactSource, store: ParticleStore, c: number): ContactEvent {
  const b = contacts.b[c];
  return {
    a: store.handle(contacts.a[c]),
    b: b === SCENERY ? undefined : store.handle(b),
    source,
    normalX: contacts.normalX[c],
    normalY: contacts.normalY[c],
    impulse: contacts.impulse[c],
  };
}
