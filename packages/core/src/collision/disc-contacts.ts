import type { ContactGenerator } from '../contacts/contact-generator.ts';
import type { Contacts } from '../contacts/contacts.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { Grid } from './grid.ts';
import { EARLY_SHARE } from './shape-contacts.ts';

/**
 * Collision of particles with each other, as discs of their radius. Points (radius 0), two immovable ones, and particles
 * that a link joins do not collide. The greater restitution of the two counts.
 *
 * @example
 * ```ts
 * world.addContactGenerator(new DiscContacts());
 * ```
 */
export class DiscContacts implements ContactGenerator {
  readonly #grid = new Grid();

  /** Reads x, y, radius, inverseMass, restitution, friction. Adds a contact for each pair that touches or nearly does. */
  addContacts(particles: ParticleArrays, contacts: Contacts): void {
    const { x, y, radius, restitution, friction } = particles;
    const count = this.#grid.findPairs(particles, EARLY_SHARE);
    const { pairs } = this.#grid;
    for (let p = 0; p < count; p++) {
      const i = pairs[p * 2];
      const j = pairs[p * 2 + 1];
      if (contacts.areLinked(i, j)) continue;
      const dx = x[i] - x[j];
      const dy = y[i] - y[j];
      const distance = Math.sqrt(dx * dx + dy * dy);
      const nx = distance === 0 ? 0 : dx / distance; // concentric discs define no direction: any will do
      const ny = distance === 0 ? 1 : dy / distance;
      const e = Math.max(restitution[i], restitution[j]);
      contacts.add(i, j, nx, ny, radius[i] + radius[j] - distance, e, Math.sqrt(friction[i] * friction[j]));
    }
  }
}
