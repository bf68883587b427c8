import type { World } from '@mass/core';
import type { Action } from './scene.ts';

/** Begins a scene again and again, until the reader takes hold of something. */
export class Again {
  /** Begins again at once. */
  readonly action: Action;
  readonly #worlds: readonly World[];
  readonly #seconds: number;
  readonly #forces: number;
  #touched = false;
  #begun = 0;

  /** `begin` puts everything where it starts; it is called after each `seconds` of the worlds' time, and by the key. */
  constructor(worlds: readonly World[], seconds: number, key: string, label: string, begin: () => void) {
    this.#worlds = worlds;
    this.#seconds = seconds;
    this.#forces = this.#countForces();
    const run = (): void => {
      this.#begun = worlds[0].time;
      begin();
    };
    this.action = { key, label, run };
  }

  /** Whether the reader has had something in hand: a hand is one more force. */
  get touched(): boolean {
    return this.#touched;
  }

  /** To be called before each step. */
  beforeStep(): void {
    this.#touched ||= this.#countForces() > this.#forces;
    if (!this.#touched && this.#worlds[0].time - this.#begun > this.#seconds) this.action.run();
  }

  #countForces(): number {
    return this.#worlds.reduce((sum, { forces }) => sum + forces.length, 0);
  }
}
