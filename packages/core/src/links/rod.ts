import { requirePositive } from '../math/checks.ts';
import { checkedEnds, type End } from '../particles/end.ts';
import { DistanceLink, distanceNow, type GivingOptions } from './distance-link.ts';

/** How a rod is made. */
export interface RodOptions extends GivingOptions {
  /** Length, positive. Unit: m. @default the distance of the ends at the time */
  length?: number;
}

/** A rod: the distance of its two ends stays the same. */
export function rod(a: End, b: End, { length, ...others }: RodOptions = {}): DistanceLink {
  const kept = length ?? distanceNow(...checkedEnds('rod', a, b));
  requirePositive('rod', 'length', kept, 'metres', 'Ends on one place define no direction to hold.');
  return new DistanceLink('rod', a, b, { kind: 'rod', minLength: kept, maxLength: kept, ...others });
}
