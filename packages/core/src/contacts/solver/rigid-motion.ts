import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { ContactBuffer } from '../contact-buffer.ts';
import type { ContactRows } from './contact-rows.ts';
import type { Softness } from './softness.ts';

/**
 * How rigid bodies move, for contacts to change: what pushes a member pushes the body. `read` comes first, then changes, then `write`.
 */
export interface RigidMotion {
  /** Velocity of the centre of mass. Unit: m/s. */
  readonly vx: Float64Array;
  readonly vy: Float64Array;
  /** Angular velocity, counter-clockwise. Unit: rad/s. */
  readonly spin: Float64Array;
  /** Centre of mass. Unit: m. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** Unit: 1/kg, 1/(kg·m²). */
  readonly inverseMass: Float64Array;
  readonly inverseInertia: Float64Array;
  /** The body that a slot belongs to, or -1: it belongs to none, or that sleeps. */
  bodyOf(slot: number): number;
  /** The contacts of the bodies. */
  readonly rows: RowsOfBodies;
  /** Reads the motion off the members. Reads x, y, vx, vy. */
  read(particles: ParticleArrays): void;
  /** Adds to the members what has changed since. Writes vx, vy. */
  write(particles: ParticleArrays): void;
  /** Adds to velocities of its members what an impulse at a place does to a body. Reads x, y. Unit: N·s, m. */
  push(
    body: number,
    impulseX: number,
    impulseY: number,
    atX: number,
    atY: number,
    particles: ParticleArrays,
    vx: Float64Array,
    vy: Float64Array,
  ): void;
}

/** The rows of which one thing or both belong to a rigid body. They come with the bodies. */
export interface RowsOfBodies {
  readonly count: number;
  /** Lists them. Writes which of the rows are here, and their masses. */
  build(contacts: ContactBuffer, rows: ContactRows, bodies: RigidMotion, particles: ParticleArrays): void;
  /** Reads the motion of the bodies, and weighs the rows as they stand. Reads x, y, vx, vy, inverseMass. Writes the masses of the rows. */
  weigh(contacts: ContactBuffer, rows: ContactRows, bodies: RigidMotion, particles: ParticleArrays): void;
  /**
   * One pass over the rows. Writes vx, vy, and the impulses.
   * @param calm - Speed along the normal below which a contact is calm. Unit: m/s.
   * @param begins - Whether the small step begins: with what was done in the last one.
   */
  pass(
    contacts: ContactBuffer,
    rows: ContactRows,
    bodies: RigidMotion,
    particles: ParticleArrays,
    soft: Softness,
    h: number,
    calm: number,
    begins: boolean,
  ): void;
}
