import type { Stage } from '../stage/stage.ts';
import { find } from './find.ts';

/** Play, pause, step, reset, and the scene's own actions, each a button with its key on it. */
export class Transport {
  readonly #stage: Stage;
  readonly #play: HTMLElement = find('#play');

  constructor(stage: Stage) {
    this.#stage = stage;
    this.#play.addEventListener('click', () => this.togglePlaying());
    find('#step').addEventListener('click', () => stage.step());
    find('#reset').addEventListener('click', () => stage.reset());
    for (const button of document.querySelectorAll<HTMLElement>('[data-key]')) {
      button.addEventListener('click', () => stage.act(button.dataset['key']));
    }
    this.update();
    this.paint();
  }

  togglePlaying(): void {
    if (this.#stage.playing) this.#stage.pause();
    else this.#stage.play();
  }

  /** Shows what the stage does. */
  update(): void {
    const { playing } = this.#stage;
    this.#play.dataset['playing'] = String(playing);
    this.#play.title = `${playing ? 'Pause' : 'Play'} (space)`;
    const text = this.#play.querySelector('.text');
    if (text) text.textContent = playing ? 'Pause' : 'Play';
  }

  /** Gives the keys of actions the colour of what they bring forth. */
  paint(): void {
    for (const button of document.querySelectorAll<HTMLElement>('[data-group]')) {
      const fill = this.#stage.style.groups?.[Number(button.dataset['group'])]?.fill;
      if (fill) button.style.setProperty('--swatch', fill);
    }
  }
}
