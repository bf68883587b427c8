import type { ShapeFinder } from './shape.ts';
import { ShapeContacts } from './shape-contacts.ts';

/**
 * Makes what finds the contacts of particles with shapes: the `finder` of every shape, a game's own included. So a game without
 * shapes does not load it.
 */
export function shapeFinder(): ShapeFinder {
  return new ShapeContacts();
}
