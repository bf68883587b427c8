import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ContactSources } from '../contacts/contact-sources.ts';
import type { ForceRegistry } from '../forces/force-registry.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import type { Checkpoint } from './checkpoint.ts';
import type { Integrator } from './integrators.ts';

/** All that a resolver moves on in a step: a world, as seen from inside. */
export interface Simulation {
  readonly particles: ParticleStore;
  readonly forces: ForceRegistry;
  /** Links, static shapes and contact generators. */
  readonly sources: ContactSources;
  readonly contacts: ContactBuffer;
  readonly integrate: Integrator;
  readonly gravity: Readonly<Vec2>;
  /** Time of the world when the step began. Unit: s. */
  readonly time: number;
  /** Positions and velocities as they were when the step began. */
  readonly before: Checkpoint;
}
