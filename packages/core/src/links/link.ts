import type { ContactGenerator } from '../contacts/contact-generator.ts';
import type { End } from '../particles/end.ts';
import type { LinkSolver } from './link-solver.ts';

/**
 * Something that joins two ends by contacts. A game's own is made the same way: implement it, hand it to `World.addLink`.
 * It leaves the world with either of its particles, and the two do not collide.
 */
export interface Link extends ContactGenerator {
  readonly a: End;
  readonly b: End;
  /**
   * Makes what keeps links of this kind together in the sub-step resolver: links that name the same function share one solver.
   * A link without is kept by its contacts.
   */
  readonly solver?: () => LinkSolver;
  /**
   * Whether the link breaks now; asked after each step.
   * @param force - What its contacts had to hold during the step. Unit: N.
   */
  breaksAt?(force: number): boolean;
}
