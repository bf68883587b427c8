/**
 * What one of the two phases works on. The number of a contact is (u_a - u_b)·n less its penetration: the least is the most
 * severe. For velocities u is the velocity and the penetration 0; for penetrations u is how far the phase has moved things.
 */
export interface Phase {
  /** u of each slot, x and y in turn; scenery, after all others, has 0. */
  readonly u: Float64Array;
  /** Of each slot, scenery included. Unit: 1/kg. */
  readonly inverseMass: Float64Array;
  /** Of each contact. */
  readonly penetration: Float64Array;
  /** A contact whose number is no less than minus this comes out at 0. */
  readonly resting: Float64Array;
  /** Any other comes out at minus its number times this. */
  readonly restitution: Float64Array;
  /** Sum of what went along the normal, times mass. */
  readonly impulse: Float64Array;
}
