/** What a new particle is made of. Only the position is asked for; all else has a default. */
export interface ParticleOptions {
  /** Position. Unit: m. */
  x: number;
  y: number;
  /** Velocity. Unit: m/s. @default 0 */
  vx?: number;
  vy?: number;
  /** Constant acceleration, on top of the world's gravity. Unit: m/s². @default 0 */
  ax?: number;
  ay?: number;
  /** Mass, positive; `Infinity` pins the particle: no force or impulse moves it. Unit: kg. @default 1 */
  mass?: number;
  /** Share of the velocity kept per second, 0 to 1. @default 1 */
  damping?: number;
  /** Radius of the disc, 0 or more. Unit: m. @default 0 */
  radius?: number;
  /** Time until the world removes the particle, more than 0. Unit: s. @default Infinity */
  lifetime?: number;
  /** A number of the game's own, 0 to 65535, for styles. @default 0 */
  group?: number;
}
