/**
 * Where contact generators put what they find. A contact joins a particle to another, or to immovable scenery; its normal
 * is a unit vector seen from the first particle: the direction in which the first is pushed.
 */
export interface Contacts {
  /** How many contacts there are so far. */
  readonly count: number;
  /**
   * How far ahead to look: whatever may come into touch within this time should be added too, with its penetration, which is
   * then negative, so that nothing passes through in a step. Unit: s.
   */
  readonly lookAhead: number;
  /**
   * Adds a contact.
   * @param a - Slot of the first particle.
   * @param b - Slot of the second, or -1 for immovable scenery.
   * @param normalX - Unit normal, from the second towards the first.
   * @param normalY - Unit normal, from the second towards the first.
   * @param penetration - How deep the two are in each other; 0 touching, negative apart. Unit: m.
   * @param restitution - Share of the closing speed that is given back, 0 to 1.
   * @param friction - Coefficient of friction, 0 or more. Default 0.
   * @param surfaceSpeed - How fast the second's surface moves along the tangent (normalY, -normalX). Default 0. Unit: m/s.
   */
  add(
    a: number,
    b: number,
    normalX: number,
    normalY: number,
    penetration: number,
    restitution: number,
    friction?: number,
    surfaceSpeed?: number,
  ): void;
  /**
   * Tells of two that touch and do not push each other, because one of them is a sensor: for `contactBegin` and `contactEnd` alone.
   * @param a - Slot of the first particle.
   * @param b - Slot of the second, or -1 for immovable scenery.
   * @param normalX - Unit normal, towards the first.
   * @param normalY - Unit normal, towards the first.
   */
  addSensor(a: number, b: number, normalX: number, normalY: number): void;
  /** Whether a link joins two particles, by slot: such pairs are held by the link and do not collide. */
  areLinked(a: number, b: number): boolean;
}
