import type { Scene } from './scene.ts';

/** A scene that an engine has built. Positions are read into arrays of the harness, which computes all qualities from them. */
export interface Simulation {
  step(): void;
  /** x and y of each disc, in the order of the scene. Unit: m. */
  readPositions(into: Float64Array): void;
  /** vx and vy of each disc. Unit: m/s. */
  readVelocities(into: Float64Array): void;
  /** x and y of the four corners of each crate, counter-clockwise. Unit: m. */
  readCorners?(into: Float64Array): void;
}

/** How hard an engine is told to work: 1 is what its documentation recommends, 2 is twice the sub-steps or iterations. */
export type Effort = number;

/** Builds a scene. */
export type Build = (scene: Scene, effort: Effort) => Simulation;

/** What a workload may ask of an engine. */
export type Ability = 'collide' | 'links' | 'crates' | 'bars' | 'sleep';

/** An engine and how it is used here. */
export interface Engine {
  /** Its name on the command line and in the tables. */
  readonly id: string;
  /** The npm package whose version is reported; none for what is written by hand here. */
  readonly package?: string;
  /** Where its step runs. */
  readonly language: 'TypeScript' | 'JavaScript' | 'WASM';
  /** How it is set up, for a reader who wants to disagree. */
  readonly settings: readonly string[];
  /** What it cannot do, and why: workloads that ask for it leave the engine out and say so. */
  readonly cannot?: Readonly<Partial<Record<Ability, string>>>;
  /** Loads the package. */
  load(): Promise<Build>;
}
