import type { Simulation } from '../world/simulation.ts';

/** How a world is moved on by one step: a value that is imported and passed to `new World({ resolver })`. */
export interface Resolver {
  /** The resolver's name, for messages and readouts. */
  readonly name: string;
  /**
   * Moves the simulation on.
   * @param dt - Duration, more than 0. Unit: s.
   * @returns Whether every position and velocity came out finite.
   */
  step(simulation: Simulation, dt: number): boolean;
  /**
   * Adds what links had to hold in the last step without contacts, in the order of the world's links: asked where some may break.
   * Unit: N·s.
   */
  addLinkImpulses?(simulation: Simulation, impulses: Float64Array): void;
  /** Whether everything sleeps, and nothing has changed since that could wake it: there is nothing to move on. */
  isAtRest?(simulation: Simulation): boolean;
}
