import type { Stage } from '../stage/stage.ts';

/** Keys that work anywhere on the page, except where somebody types or what has the focus means something else by them. */
export class Keyboard {
  readonly #stage: Stage;
  readonly #togglePlaying: () => void;

  constructor(stage: Stage, togglePlaying: () => void) {
    this.#stage = stage;
    this.#togglePlaying = togglePlaying;
    window.addEventListener('keydown', (event) => this.#press(event));
  }

  #press(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.composedPath()[0];
    if (target instanceof Element && target.matches('input:not([type="radio"]), textarea, select')) return;
    const run = this.#meaning(event, target);
    if (!run) return;
    event.preventDefault();
    run();
  }

  #meaning({ key, repeat }: KeyboardEvent, target: EventTarget | undefined): (() => void) | undefined {
    const stage = this.#stage;
    // On a button, a link or a choice the space bar and Enter have a meaning already, and on a choice so have the arrows.
    const pressable = target instanceof Element && target.closest('button, a, summary, input') !== null;
    if (key === 'Enter' && (pressable || repeat)) return undefined;
    if (key.startsWith('Arrow') && target instanceof HTMLInputElement) return undefined;
    if (stage.setup.actions?.some((action) => action.key === key)) return () => stage.act(key);
    if (key === '.') return () => stage.step();
    if (repeat) return undefined;
    if (key === 'r') return () => stage.reset();
    if (key === '0') return () => stage.fit();
    if (key === ' ' && !pressable) return this.#togglePlaying;
    return undefined;
  }
}
