import type { ShapeFinder } from './shape.ts';
import { surfaceFinder } from './surface-finder.ts';
import { SurfaceWalk } from './surface-walk.ts';

/**
 * Makes what finds the contacts of particles with shapes: the `finder` of each of a game's own. It comes with the shapes, so that a game
 * without any does not load it.
 * @param known - What the world has already, if it has other shapes.
 */
export function shapeFinder(known?: ShapeFinder): ShapeFinder {
  const finder = surfaceFinder(known);
  finder.walk ??= new SurfaceWalk();
  return finder;
}
