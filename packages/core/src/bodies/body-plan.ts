import type { Body } from './body.ts';
import type { BodyParts, BodySite } from './body-parts.ts';

/** A body before it is in a world, to hand to `World.addBody`: what builders return. It can be added many times. */
export interface BodyPlan extends BodyParts {
  /** @internal */
  build(where: string, site: BodySite): Body;
}
