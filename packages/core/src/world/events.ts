import type { ContactSource } from '../contacts/contact-sources.ts';
import type { Link } from '../links/link.ts';
import { describe, requireFunction } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';

/** Two particles, or a particle and scenery, that touch. */
export interface ContactEvent {
  readonly a: Particle;
  /** The other particle; undefined where it is scenery. */
  readonly b: Particle | undefined;
  /** What found the contact: the static shape that was touched, a sensor too, or the contact generator. */
  readonly source: ContactSource;
  /** Unit normal, towards `a`. */
  readonly normalX: number;
  readonly normalY: number;
  /** How hard they hit in the step in which the contact began; 0 where one is a sensor. Unit: N·s. */
  readonly impulse: number;
}

/** What a world tells, by name, and what comes with it. */
export interface WorldEvents {
  /** Two began to touch, or a particle came to a sensor. */
  contactBegin: ContactEvent;
  /** Two touch no more, or one of them was removed; the event is the one that began it. */
  contactEnd: ContactEvent;
  /** A link gave way and was taken out. */
  linkBroke: { readonly link: Link; readonly force: number };
  /** A particle's lifetime ran out: it is removed after the listeners were told. */
  particleExpired: { readonly particle: Particle };
}

type Listener<Name extends keyof WorldEvents> = (event: WorldEvents[Name]) => void;

/** Who listens to what, and what is still to be told. */
export class EventQueue {
  readonly #listeners: { [Name in keyof WorldEvents]: Listener<Name>[] } = {
    contactBegin: [],
    contactEnd: [],
    linkBroke: [],
    particleExpired: [],
  };
  /** Listeners that are to be told, and each one's event. */
  #waiting: ((event: never) => void)[] = [];
  #events: unknown[] = [];

  /** Adds a listener; the function returned takes it out again. */
  on<Name extends keyof WorldEvents>(name: Name, listener: Listener<Name>): () => void {
    const listeners = this.#listeners[name];
    if (listeners === undefined) {
      const known = Object.keys(this.#listeners).join(', ');
      throw new RangeError(`World.on: the event must be one of ${known}; got ${describe(name)}.`);
    }
    requireFunction('World.on', 'the listener', listener, 'of one event');
    listeners.push(listener);
    return () => {
      const index = listeners.indexOf(listener);
      if (index >= 0) listeners.splice(index, 1);
    };
  }

  /** Whether anyone listens. */
  has(name: keyof WorldEvents): boolean {
    return this.#listeners[name].length > 0;
  }

  /** Notes what is to be told. Listeners of one event are told in the order in which they came. */
  add<Name extends keyof WorldEvents>(name: Name, event: WorldEvents[Name]): void {
    const listeners = this.#listeners[name];
    for (let l = 0; l < listeners.length; l++) {
      this.#waiting.push(listeners[l]);
      this.#events.push(event);
    }
  }

  /** Tells everything, in the order in which it was noted. What is left when a listener throws is dropped. */
  tell(): void {
    if (this.#waiting.length === 0) return;
    const waiting = this.#waiting;
    const events = this.#events;
    this.#waiting = [];
    this.#events = [];
    for (let w = 0; w < waiting.length; w++) waiting[w](events[w] as never);
  }
}
