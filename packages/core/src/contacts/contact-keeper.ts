import type { Vec2 } from '../math/vec2.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import type { ContactBuffer, SomeSlots } from './contact-buffer.ts';
import type { RigidMotion } from './solver/rigid-motion.ts';

/** What contacts are found and kept among: a world, as seen from here. */
export interface ContactScene {
  readonly particles: ParticleStore;
  readonly contacts: ContactBuffer;
  readonly gravity: Readonly<Vec2>;
  /** All that finds contacts. */
  readonly sources: {
    readonly links: readonly unknown[];
    gather(contacts: ContactBuffer, dt: number, without: boolean, only?: SomeSlots): void;
  };
}

/**
 * Keeps contacts in the small steps of the sub-step resolver, from their discovery to their impulses. It comes with what finds
 * contacts, so that a game without does not load it.
 */
export interface ContactKeeper {
  /**
   * Finds the contacts of the step. Reads the particles, links, shapes and generators. Writes the contacts.
   * @param ahead - How far ahead to look. Unit: s.
   */
  find(scene: ContactScene, ahead: number): void;
  /**
   * Begins the step with them. Reads the contacts and particles.
   * @param dt - Duration of the step. Unit: s.
   * @param h - Duration of a small step. Unit: s.
   * @param bodies - Rigid bodies that links make.
   */
  begin(scene: ContactScene, dt: number, h: number, bodies: RigidMotion | undefined): void;
  /** Looks for more contacts, within the step, of what may go where none were looked for. */
  findMore(scene: ContactScene, rest: number): void;
  /**
   * Begins a small step with what the contacts did in the last one. Writes vx, vy.
   * @param first - Whether it is the first of the step.
   */
  repeat(scene: ContactScene, first: boolean): void;
  /** One pass over the contacts. Reads x, y. Writes vx, vy. */
  solve(scene: ContactScene): void;
  /** Undoes by position what moved particles into scenery since. Writes x, y. */
  keepOut(scene: ContactScene): void;
  /** Takes out the speed by which penetrations were undone, then gives back what hits give back. Reads x, y. Writes vx, vy. */
  relax(scene: ContactScene): void;
  /** Keeps the impulses for the next step. Reads the contacts. */
  keep(scene: ContactScene): void;
}
