import type { Particle } from '../particles/particle.ts';
import type { SlotList } from '../particles/slot-list.ts';

/** The particles that a force generator acts on: their slots, `slots[0]` to `slots[count - 1]`, all of them alive. */
export interface ForceTargets extends SlotList {
  /** The handle of the target at an index, 0 to `count - 1`. */
  particle(index: number): Particle;
}
