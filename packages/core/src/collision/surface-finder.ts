import type { ShapeFinder } from './shape.ts';
import { ShapeContacts } from './shape-contacts.ts';

/** The `finder` of our own shapes, each of which tells by itself what is met on the way. */
export function surfaceFinder(known?: ShapeFinder): ShapeFinder {
  return known ?? new ShapeContacts();
}
