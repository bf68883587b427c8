/** The contacts of a step, one typed array a quantity, in the order in which they were found; links are among them. */
export interface ContactArrays {
  /** How many contacts there are. */
  readonly count: number;
  /** How many were left out because the world's limit was reached. */
  readonly leftOut: number;
  /** Slot of the first particle. */
  readonly a: Int32Array;
  /** Slot of the second particle, or -1 for immovable scenery. */
  readonly b: Int32Array;
  /** Unit normal, from the second towards the first. */
  readonly normalX: Float64Array;
  readonly normalY: Float64Array;
  /** How deep the two were in each other when the contact was found; negative apart. Unit: m. */
  readonly penetration: Float64Array;
  /** Share of the closing speed that is given back, 0 to 1. */
  readonly restitution: Float64Array;
  /** Coefficient of friction. */
  readonly friction: Float64Array;
  /** How fast the surface of the second moves along the tangent (normalY, -normalX), as a conveyor's does. Unit: m/s. */
  readonly surfaceSpeed: Float64Array;
  /**
   * Where the second is an edge from `b` to another particle: the slot of that one, else -1; and where on the edge the
   * contact lies, 0 at `b` and 1 at that one.
   */
  readonly edgeEnd: Int32Array;
  readonly edgeShare: Float64Array;
  /** Where it comes from: the links are counted first, then the static shapes, then the other contact generators. */
  readonly source: Int32Array;
  /** Sum of the impulses along the normal. Unit: N·s. */
  readonly impulse: Float64Array;
  /** Sum of the impulses of friction on the first, along the tangent (normalY, -normalX). Unit: N·s. */
  readonly tangentImpulse: Float64Array;
}
