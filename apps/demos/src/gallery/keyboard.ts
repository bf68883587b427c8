import type { Stage } from '../stage/stage.ts';

/** Keys that work anywhere on the page, except where somebody types or a button has the focus. */
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
    if (target instanceof Element && target.matches('input, textarea, select')) return;
    const run = this.#meaning(event, target);
    if (!run) return;
    event.preventDefault();
    run();
  }

  #meaning({ key, repeat }: KeyboardEvent, target: EventTarget | undefined): (() => void) | undefined {
    const stage = this.#stage;
    // On a button, a link or a choice the space bar and Enter have a meaning already.
    const pressable =
      target instanceof Element && target.closest('button, a, summary, wa-radio, [role="radio"]') !== null;
    if (key === 'Enter' && (pressable || repeat)) return undefined;
    if (stage.setup.actions?.some((action) => action.key === key)) return () => stage.act(key);
    if (key === '.') return () => stage.step();
    if (repeat) return undefined;
    if (key === 'r') return () => stage.reset();
    if (key === '0') return () => stage.fit();
    if (key === ' ' && !pressable) return this.#togglePlaying;
    return undefined;
  }
}
