import type { DampingPowers } from './damping-powers.ts';
import type { ParticleArrays } from './particle-arrays.ts';

/** The particles as the integrators see them: with word of what no particle has, so that its pass can be left out. */
export interface MotionArrays extends ParticleArrays {
  /** Whether anyone asked for `ax` or `ay`: if not, every constant acceleration is 0. */
  readonly accelerated: boolean;
  /** Whether anyone asked for `damping`: if not, every damping is 1. */
  readonly damped: boolean;
  /** What the dampings come to in a step. */
  readonly dampingPowers: DampingPowers;
}
