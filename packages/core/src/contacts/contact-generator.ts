import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ContactKeeper } from './contact-keeper.ts';
import type { Contacts } from './contacts.ts';

/**
 * Something that finds contacts: collision detection is one, and so are links. A game's own is made the same way:
 * implement `addContacts`, hand it to `World.addContactGenerator`.
 */
export interface ContactGenerator {
  /**
   * `contactKeeper`: makes what keeps contacts in the sub-step resolver. One of those that find contacts in a world must have it, and all
   * of ours do but links: a game's own only where there is no other.
   */
  readonly keeper?: () => ContactKeeper;
  /**
   * Adds the contacts of this moment. Writes nothing of the particles.
   * @param particles - Position, velocity, radius, ... of every particle.
   * @param contacts - Where to add them.
   * @param dt - Duration of the step. Unit: s.
   */
  addContacts(particles: ParticleArrays, contacts: Contacts, dt: number): void;
}
