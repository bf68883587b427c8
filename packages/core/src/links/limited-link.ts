import type { Link } from './link.ts';

/** A link that keeps the distance of its ends between a least and a greatest, as the solver of forests reads it. */
export interface LimitedLink extends Link {
  /** Smallest distance of the ends. Unit: m. */
  readonly minLength: number;
  /** Greatest distance of the ends. Unit: m. */
  readonly maxLength: number;
  /** How far it gives for each newton beyond its limits. Unit: m/N. */
  readonly compliance: number;
  /** Share of the closing speed given back at either limit, 0 to 1. */
  readonly restitution: number;
  /** How much it calms what swings on it, 0 to 1. */
  readonly damping: number;
}
