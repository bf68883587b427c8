import type { ContactKeeper } from '../contact-keeper.ts';
import { ContactSolver } from './contact-solver.ts';

/** Makes what keeps contacts in the sub-step resolver: the `keeper` of all that finds contacts, a game's own included. */
export function contactKeeper(): ContactKeeper {
  return new ContactSolver();
}
