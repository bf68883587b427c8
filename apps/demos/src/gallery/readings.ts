import type { Readout } from '../scenes/scene.ts';
import type { Stage } from '../stage/stage.ts';
import { find } from './find.ts';

/** How often the numbers change: faster cannot be read. Unit: ms. */
const PERIOD = 250;

/** The numbers under the scene: its own, then how many particles, how fast. */
export class Readings {
  readonly #stage: Stage;
  readonly #list: HTMLElement = find('#statistics');
  readonly #cells = new Map<string, HTMLElement>();

  constructor(stage: Stage) {
    this.#stage = stage;
    this.#show();
    setInterval(() => this.#show(), PERIOD);
  }

  #show(): void {
    const { setup, statistics } = this.#stage;
    let particles = setup.world.particleCount;
    for (const { world } of setup.beside ?? []) particles += world.particleCount;
    const readings: Readout[] = [
      ...(setup.readouts?.() ?? []),
      { label: 'Time', value: setup.world.time, unit: 's', digits: 1 },
      { label: 'Particles', value: particles, digits: 0 },
      { label: 'Step', value: statistics.stepMs, unit: 'ms', digits: 2 },
      { label: 'Frames', value: statistics.framesPerSecond, unit: '/s', digits: 0 },
    ];
    for (const reading of readings) this.#write(reading);
  }

  #write({ label, value, unit, digits = 2 }: Readout): void {
    let cell = this.#cells.get(label);
    if (!cell) {
      const entry = document.createElement('span');
      entry.className = 'reading';
      cell = document.createElement('b');
      entry.append(`${label} `, cell, unit ? ` ${unit}` : '');
      this.#list.append(entry);
      this.#cells.set(label, cell);
    }
    const text = Number.isNaN(value) ? '–' : value.toFixed(digits); // not measured yet
    if (cell.textContent !== text) cell.textContent = text;
  }
}
