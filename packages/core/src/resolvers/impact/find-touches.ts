import { mayPush, mayPushShape } from '../../collision/filter.ts';
import type { Shape } from '../../collision/shape.ts';
import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import type { Pairs } from './boxes.ts';
import type { Flight } from './flight.ts';
import type { Places } from './places.ts';
import { nearOf } from './slack.ts';
import type { Touches } from './touches.ts';

/** Finds the pairs that touch, overlap or nearly touch now. Reads the pairs, x, y, radius. Adds touches. */
export function findDiscTouches(
  { particles }: Flight,
  pairs: Pairs,
  contacts: ContactBuffer,
  source: number,
  touches: Touches,
  crowded: boolean,
): void {
  const { x, y, radius } = particles;
  for (let p = 0; p < pairs.count; p++) {
    const i = pairs.slots[p * 2];
    const j = pairs.slots[p * 2 + 1];
    const dx = x[i] - x[j];
    const dy = y[i] - y[j];
    const reach = radius[i] + radius[j] + nearOf(Math.min(radius[i], radius[j]), crowded);
    if (dx * dx + dy * dy > reach * reach || contacts.areLinked(i, j) || !mayPush(particles, i, j)) continue;
    touches.addDiscs(i, j, source, particles);
  }
}

/** The same for static shapes. Reads x, y, radius, inverseMass. Adds touches. */
export function findShapeTouches(
  { particles }: Flight,
  shapes: readonly Shape[],
  firstSource: number,
  places: Places,
  touches: Touches,
  crowded: boolean,
): void {
  const { count, x, y, radius, inverseMass } = particles;
  for (let s = 0; s < shapes.length; s++) {
    const shape = shapes[s];
    const { minX, minY, maxX, maxY } = shape;
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0) continue;
      const near = nearOf(radius[i], crowded);
      const reach = radius[i] + near;
      if (x[i] < minX - reach || x[i] > maxX + reach || y[i] < minY - reach || y[i] > maxY + reach) continue;
      if (!mayPushShape(particles, i, shape)) continue;
      const { gap, normalX, normalY } = places;
      const found = places.find(shape, x[i], y[i], radius[i], near);
      for (let p = 0; p < found; p++) {
        touches.addPlace(i, firstSource + s, particles, gap[p], normalX[p], normalY[p]);
      }
    }
  }
}
