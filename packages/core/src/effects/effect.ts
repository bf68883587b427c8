import type { ParticleSpawner } from '../particles/particle-spawner.ts';
import type { SlotList } from '../particles/slot-list.ts';

/** Something that adds and removes particles as time goes by: fireworks, or a game's own emitter. */
export interface Effect {
  /** Called once, when it is added to a world; what it throws keeps it out. */
  attach?(world: ParticleSpawner): void;
  /** Called once, when it is taken out. */
  detach?(): void;
  /**
   * Called at the end of each step, when particles may come and go.
   * @param world - Where to add particles.
   * @param expired - The particles that are removed after this call, since their lifetime ran out: they can still be read.
   * @param dt - Duration of the step. Unit: s.
   */
  afterStep(world: ParticleSpawner, expired: SlotList, dt: number): void;
}
