import { checkedEnds, type End } from '../particles/end.ts';
import { DistanceLink, distanceNow, type GivingOptions } from './distance-link.ts';

/** How a cable is made. */
export interface CableOptions extends GivingOptions {
  /** Greatest distance of the ends, positive. Unit: m. @default the distance of the ends at the time */
  maxLength?: number;
  /** Share of the speed given back when it snaps taut, 0 to 1. @default 0 */
  restitution?: number;
}

/** A cable: the distance of its two ends stays at or below a length; slack below it. */
export function cable(a: End, b: End, { maxLength, ...others }: CableOptions = {}): DistanceLink {
  return new DistanceLink('cable', a, b, {
    kind: 'cable',
    minLength: 0,
    maxLength: maxLength ?? distanceNow(...checkedEnds('cable', a, b)),
    ...others,
  });
}
