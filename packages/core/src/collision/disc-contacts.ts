import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ContactGenerator } from '../contacts/contact-generator.ts';
import type { ContactKeeper } from '../contacts/contact-keeper.ts';
import { contactKeeper } from '../contacts/solver/make-keeper.ts';
import { requireFunction } from '../math/checks.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { mayTouch } from './filter.ts';
import { NeighbourList } from './neighbour-list.ts';
import { EARLY_SHARE } from './shape-contacts.ts';
import { timeOfTouch } from './swept-discs.ts';

/** Two discs that come nearer by more than this share of their radii while the world looks ahead are followed on their way. */
const FAST_SHARE = 0.02;

/** Which discs collide. */
export interface DiscContactsOptions {
  /**
   * Whether two particles, by slot, collide: asked, on top of their categories and masks, for each pair that is near. It must give the
   * same answer for the two in either order. @default all do
   */
  filter?: (a: number, b: number) => boolean;
}

/**
 * Collision of particles with each other, as discs of their radius. Points (radius 0), two immovable ones, two that sleep, and
 * particles that a link joins do not collide, nor do those whose categories and masks forbid it; sensors only tell. The greater restitution of the two counts, and the geometric mean of their
 * frictions. Contacts come in the order of the slots.
 *
 * @example
 * ```ts
 * world.addContactGenerator(new DiscContacts());
 * ```
 */
export class DiscContacts implements ContactGenerator {
  readonly keeper: () => ContactKeeper = contactKeeper;
  readonly #neighbours = new NeighbourList();
  readonly #filter: ((a: number, b: number) => boolean) | undefined;

  constructor({ filter }: DiscContactsOptions = {}) {
    if (filter !== undefined) requireFunction('DiscContacts', 'filter', filter, '(a, b) => boolean');
    this.#filter = filter;
  }

  /**
   * Reads x, y, vx, vy, radius, inverseMass, restitution, friction, category, mask, sensor, asleep. Adds a contact for each pair that touches, nearly does,
   * or will within the time that the contacts look ahead.
   */
  addContacts(particles: ParticleArrays, contacts: ContactBuffer): void {
    const { x, y, vx, vy, radius, inverseMass, restitution, friction, sensor } = particles;
    const { lookAhead, margin } = contacts;
    this.#neighbours.update(particles, contacts);
    const { x: midX, y: midY, reach } = this.#neighbours.now;
    const { a: first, b: second, count } = this.#neighbours.pairs;
    const room = contacts.reserve(count);
    const { a, b, normalX, normalY, penetration, only } = contacts;
    let c = contacts.count;
    for (let p = 0; p < count; p++) {
      const i = first[p];
      const j = second[p];
      const apartX = midX[i] - midX[j];
      const apartY = midY[i] - midY[j];
      const near = reach[i] + reach[j];
      if (apartX * apartX + apartY * apartY >= near * near) continue;
      if (only !== undefined && only.bySlot[i] + only.bySlot[j] === 0) continue;
      if (inverseMass[i] + inverseMass[j] === 0 && !wakes(particles, i, j)) continue;
      if (!mayTouch(particles, i, j) || this.#filter?.(i, j) === false) continue;
      if (sensor[i] + sensor[j] > 0) {
        tellSensor(particles, contacts, i, j);
        continue;
      }
      const sum = radius[i] + radius[j];
      const dx = x[i] - x[j];
      const dy = y[i] - y[j];
      let distance = Math.sqrt(dx * dx + dy * dy);
      // Concentric discs define no direction: any will do.
      let nx = distance === 0 ? 0 : dx / distance;
      let ny = distance === 0 ? 1 : dy / distance;
      if (distance >= sum * (1 + EARLY_SHARE) + margin) {
        const ux = (vx[i] - vx[j]) * lookAhead;
        const uy = (vy[i] - vy[j]) * lookAhead;
        if (ux * ux + uy * uy > sum * sum * FAST_SHARE * FAST_SHARE) {
          // Fast: the normal is that of the place where they will touch; those that pass by do not.
          const share = timeOfTouch(dx, dy, ux, uy, sum + margin);
          if (!(share <= 1)) continue;
          const tx = dx + ux * share;
          const ty = dy + uy * share;
          const length = Math.sqrt(tx * tx + ty * ty);
          nx = tx / length;
          ny = ty / length;
          distance = dx * nx + dy * ny;
        } else if (distance + ux * nx + uy * ny >= sum + margin) continue;
      }
      if (c === room) {
        contacts.leftOut++;
        continue;
      }
      a[c] = i;
      b[c] = j;
      normalX[c] = nx;
      normalY[c] = ny;
      penetration[c] = sum - distance;
      contacts.restitution[c] = Math.max(restitution[i], restitution[j]);
      contacts.friction[c] = friction[i] === friction[j] ? friction[i] : Math.sqrt(friction[i] * friction[j]);
      c++;
    }
    contacts.finish(c);
  }
}

/** Whether one of two that nothing moves sleeps, and the other comes along: a platform, say. */
function wakes({ asleep, vx, vy }: ParticleArrays, i: number, j: number): boolean {
  return asleep[i] + asleep[j] === 1 && (vx[i] !== 0 || vy[i] !== 0 || vx[j] !== 0 || vy[j] !== 0);
}

/** Tells of two that overlap, one of which is a sensor. */
function tellSensor({ x, y, radius }: ParticleArrays, contacts: ContactBuffer, i: number, j: number): void {
  const dx = x[i] - x[j];
  const dy = y[i] - y[j];
  const distance = Math.sqrt(dx * dx + dy * dy);
  if (distance >= radius[i] + radius[j]) return;
  contacts.addSensor(i, j, distance === 0 ? 0 : dx / distance, distance === 0 ? 1 : dy / distance);
}
