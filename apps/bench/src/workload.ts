import type { Ability, Effort, Engine, Simulation } from './engine.ts';
import type { Scene } from './scene.ts';

/** What Mass is to reach: a share of the best sound peer, or a limit of its own. */
export interface Target {
  readonly ratio?: number;
  readonly limit?: number;
}

/** One number that a workload gives for each engine. */
export interface Measure {
  readonly title: string;
  readonly unit: 'ms' | 'µs' | 'ns' | 's' | 'm' | 'mm' | 'm/s' | '%' | 'B' | 'kB' | '';
  readonly better: 'less' | 'more';
  readonly target?: Target;
}

/** One size, or kind, of a workload. */
export interface Case {
  readonly name: string;
  readonly n: number;
  /** What it asks of an engine besides what the workload does. */
  readonly needs?: readonly Ability[];
  /** Whether `--quick` runs it. */
  readonly quick?: boolean;
  /** Targets that hold for this case alone, by measure. */
  readonly targets?: Readonly<Record<string, Target>>;
}

/** What a workload is given to run an engine with. */
export interface Bench {
  readonly engine: Engine;
  build(scene: Scene, effort?: Effort): Simulation;
  /** Takes steps. */
  run(simulation: Simulation, steps: number): void;
  /** Takes steps and returns the milliseconds of each. What `after` does between two steps is not counted. */
  time(simulation: Simulation, steps: number, after?: (step: number) => void): Float64Array;
}

/** Numbers by the name of their measure. One that is NaN could not be had, such as the time of falling asleep of what never does. */
export type Values = Readonly<Record<string, number>>;

/** A scene, how long it runs, and what is measured: one file each. */
export interface Workload<C extends Case = Case> {
  readonly id: string;
  readonly title: string;
  /** What happens, and how each number is defined. */
  readonly about: string;
  readonly needs: readonly Ability[];
  readonly measures: Readonly<Record<string, Measure>>;
  readonly cases: readonly C[];
  /** The engines that take part; all that can, unless it is given. */
  readonly engines?: readonly string[];
  /** Flags that Node.js is started with. */
  readonly nodeFlags?: readonly string[];
  run(bench: Bench, which: C): Values | Promise<Values>;
  /** Why a result is so wrong that its time says nothing, if it is: it is shown, and is nobody's best. */
  unsound?(values: Values): string | undefined;
}
