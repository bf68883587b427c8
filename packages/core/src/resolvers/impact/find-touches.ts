import type { Shape } from '../../collision/shape.ts';
import { type ContactBuffer, SCENERY } from '../../contacts/contact-buffer.ts';
import type { Pairs } from './boxes.ts';
import { CLOSING_EPSILON } from './first-touch.ts';
import type { Flight } from './flight.ts';
import type { Places } from './places.ts';
import type { Rests } from './rests.ts';
import { slackOf } from './slack.ts';
import type { Touches } from './touches.ts';

/** At the start of a step this many times the slack is a touch: it may have widened by rounding since they came to rest. */
const WIDER = 4;

/** Finds the pairs that touch or overlap as the step begins, and marks those that rest. Reads the pairs. Adds touches. */
export function findDiscTouches(
  { particles: { x, y, radius } }: Flight,
  pairs: Pairs,
  contacts: ContactBuffer,
  source: number,
  touches: Touches,
  rests: Rests,
): void {
  for (let p = 0; p < pairs.count; p++) {
    const i = pairs.slots[p * 2];
    const j = pairs.slots[p * 2 + 1];
    const dx = x[i] - x[j];
    const dy = y[i] - y[j];
    const reach = radius[i] + radius[j] + WIDER * slackOf(Math.min(radius[i], radius[j]));
    if (dx * dx + dy * dy > reach * reach || contacts.areLinked(i, j)) continue;
    const distance = Math.sqrt(dx * dx + dy * dy);
    const nx = distance === 0 ? 0 : dx / distance; // concentric discs define no direction: any will do
    const ny = distance === 0 ? 1 : dy / distance;
    markIfResting(touches, touches.add(i, j, source, nx, ny), rests);
  }
}

/** The same for static shapes. Reads x, y, radius, inverseMass. Adds touches. */
export function findShapeTouches(
  { particles: { count, x, y, radius, inverseMass } }: Flight,
  shapes: readonly Shape[],
  firstSource: number,
  places: Places,
  touches: Touches,
  rests: Rests,
): void {
  for (let s = 0; s < shapes.length; s++) {
    const shape = shapes[s];
    const { minX, minY, maxX, maxY } = shape;
    for (let i = 0; i < count; i++) {
      if (inverseMass[i] === 0) continue;
      const tolerance = WIDER * slackOf(radius[i]);
      const reach = radius[i] + tolerance;
      if (x[i] < minX - reach || x[i] > maxX + reach || y[i] < minY - reach || y[i] > maxY + reach) continue;
      const found = places.find(shape, x[i], y[i], radius[i], tolerance);
      for (let p = 0; p < found; p++) {
        const c = touches.add(i, SCENERY, firstSource + s, places.normalX[p], places.normalY[p]);
        markIfResting(touches, c, rests);
      }
    }
  }
}

/** A touch rests when it neither opens nor closes faster than a resting one may. */
function markIfResting({ a, b, normalX, normalY, resting }: Touches, c: number, rests: Rests): void {
  const velocity = rests.separatingVelocity(c);
  const slowest = rests.restingSpeed(a[c], b[c], normalX[c], normalY[c]) + CLOSING_EPSILON;
  if (velocity <= CLOSING_EPSILON && -velocity <= slowest) resting[c] = 1;
}
