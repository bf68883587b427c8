/**
 * The particles as they are stored: one typed array a quantity, one slot a particle. A slot keeps its number for the
 * life of its particle. Read and write the numbers freely; bind the arrays afresh after adding particles, since growth
 * replaces them.
 */
export interface ParticleArrays {
  /** Slots to look at: 0 to `count - 1`. A free slot among them has `alive` 0, no mass to move and no velocity. */
  readonly count: number;
  /** Grows with each particle added or removed: whoever keeps slots looks at them again when it has changed. */
  readonly version: number;
  /** 1 where a particle lives, 0 where the slot is free. Written by the world alone. */
  readonly alive: Uint8Array;
  /** Grows each time a slot is freed: tells one particle of a slot from the next that lives there. */
  readonly generation: Uint32Array;
  /** Position. Unit: m. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** Position before the last step, for drawing between two steps. Bind these two afresh after each step. Unit: m. */
  readonly previousX: Float64Array;
  readonly previousY: Float64Array;
  /** Velocity. Unit: m/s. */
  readonly vx: Float64Array;
  readonly vy: Float64Array;
  /** Force accumulator: the sum of the forces on the particle, cleared by each step. Unit: N. */
  readonly fx: Float64Array;
  readonly fy: Float64Array;
  /** Constant acceleration, on top of the world's gravity. Unit: m/s². */
  readonly ax: Float64Array;
  readonly ay: Float64Array;
  /** Mass, and one over it. An infinite mass has the inverse 0: no force or impulse moves it. Unit: kg, 1/kg. */
  readonly mass: Float64Array;
  readonly inverseMass: Float64Array;
  /** Share of the velocity kept per second, 0 to 1. */
  readonly damping: Float64Array;
  /** Radius of the disc that is drawn and collides; 0 is a point. Unit: m. */
  readonly radius: Float64Array;
  /** Share of the closing speed that a hit gives back, 0 to 1; of two that hit the greater counts. */
  readonly restitution: Float64Array;
  /** Coefficient of friction, static and kinetic, 0 or more; of two that touch the geometric mean counts. */
  readonly friction: Float64Array;
  /** Time left until the world removes the particle; `Infinity` for ever. Set it by the handle. Unit: s. */
  readonly lifetime: Float64Array;
  /** A number of the game's own, 0 to 65535: styles choose by it, the physics never reads it. */
  readonly group: Uint16Array;
  /** What the particle is, and what it touches: bits. Two touch if each has a bit of the other's category in its mask. */
  readonly category: Uint16Array;
  readonly mask: Uint16Array;
  /** 1 where the particle is a sensor: it is told of what it touches, and neither pushes it nor is pushed. */
  readonly sensor: Uint8Array;
  /** 1 where the particle sleeps: it rests, and is left out of the step until something wakes it. Written by the world alone. */
  readonly asleep: Uint8Array;
}
