import { FixedTimestep } from '@mass/core';
import type { Camera, Style } from '@mass/core/view';
import type { Palette } from '../scenes/palette.ts';
import { DEFAULT_STEP, stepSetup } from '../scenes/run.ts';
import type { Guide, Scene, Setup, Values } from '../scenes/scene.ts';
import { canvasPicture, makePicture } from './make-picture.ts';
import { Pane } from './pane.ts';
import type { Picture } from './picture.ts';
import { observePixels, type PixelObserver } from './pixel-observer.ts';
import type { RendererKind } from './renderers.ts';
import { Statistics } from './statistics.ts';

/** What a stage starts with. */
export interface StageOptions {
  readonly scene: Scene;
  readonly values: Values;
  readonly seed: number;
  readonly palette: Palette;
  /** Called when something that the stage ran has thrown; it stands still from then on, until it is reset. */
  readonly failed?: (error: unknown) => void;
  /** Called when the stage plays or pauses, is built anew, or changes its renderer. */
  readonly changed?: () => void;
}

/** The longest time between two frames that is caught up with: a tab that was hidden does not run ahead. Unit: s. */
const LONGEST_FRAME = 0.25;

/** The most that one frame steps, however short the scene's step is; what is missing beyond is dropped. Unit: s. */
const CATCH_UP = 1 / 12;

/** A stage that is narrower has no room for words. Unit: CSS px. */
const WORDLESS = 290;

/**
 * A scene on a page: its worlds, their pictures, the loop. It serves a scene's own page and a thumbnail alike, with
 * whichever renderer.
 */
export class Stage {
  readonly scene: Scene;
  readonly clock: FixedTimestep;
  readonly statistics: Statistics = new Statistics();
  /** The parameters as they are now. */
  values: Values;
  seed: number;
  /** Seconds of the world for each second of the reader. */
  speed = 1;
  readonly #host: HTMLElement;
  readonly #options: StageOptions;
  readonly #resizes: PixelObserver;
  readonly #sight: IntersectionObserver;
  readonly #panes: Pane[] = [];
  #setup: Setup;
  #palette: Palette;
  #style: Style;
  #kind: RendererKind = 'canvas2d';
  #wantedKind: RendererKind = 'canvas2d';
  #playing = false;
  #failed = false;
  #inSight = true;
  #fitted = true;
  #destroyed = false;
  #frame = 0;
  #lastTime = Number.NaN;
  /** Where between the last two steps to draw: the last one itself, unless the stage plays. */
  #alpha = 1;
  /** Guides of whoever else draws over a picture: the reader's hand. */
  extraGuides: (pane: Pane) => readonly Guide[] = () => [];

  /** Builds the scene into `host`; it is drawn by Canvas 2D as soon as it is laid out, and stands still until `play`. */
  constructor(host: HTMLElement, options: StageOptions) {
    this.#host = host;
    this.#options = options;
    this.scene = options.scene;
    this.values = { ...options.values };
    this.seed = options.seed;
    this.#palette = options.palette;
    this.#style = this.scene.style(options.palette);
    const step = this.scene.step ?? DEFAULT_STEP;
    this.clock = new FixedTimestep({ step, maxSteps: Math.ceil(CATCH_UP / step) });
    this.#setup = this.scene.build(this.values, this.seed);
    for (const { world, label } of this.#worlds()) {
      const pane = new Pane(world, canvasPicture(this.#style), this.scene.show);
      pane.label = label ?? '';
      this.#panes.push(pane);
      host.append(pane.element);
    }
    this.#paintGround();
    // A resize is drawn before it is painted: nothing flashes, nothing jumps.
    this.#resizes = observePixels((element, width, height, ratio) => {
      this.#panes.find((pane) => pane.element === element)?.resize(width, height, ratio);
      this.#guard(() => this.#draw());
    });
    for (const { element } of this.#panes) this.#resizes.observe(element);
    this.#sight = new IntersectionObserver((entries) => {
      this.#inSight = entries[entries.length - 1].isIntersecting;
      this.invalidate();
    });
    this.#sight.observe(host);
    document.addEventListener('visibilitychange', this.#forgetTime);
  }

  get setup(): Setup {
    return this.#setup;
  }

  /** How the scene is drawn, in the palette of the page. */
  get style(): Style {
    return this.#style;
  }

  get panes(): readonly Pane[] {
    return this.#panes;
  }

  get playing(): boolean {
    return this.#playing;
  }

  /** Whether something threw; a reset mends it. */
  get failed(): boolean {
    return this.#failed;
  }

  get inSight(): boolean {
    return this.#inSight;
  }

  /** The renderer that draws now. */
  get renderer(): RendererKind {
    return this.#kind;
  }

  play(): void {
    if (this.#failed || this.#playing) return;
    this.#playing = true;
    this.#forgetTime();
    this.invalidate();
    this.#options.changed?.();
  }

  pause(): void {
    if (!this.#playing) return;
    this.#playing = false;
    this.statistics.rest();
    this.#options.changed?.();
  }

  /** Pauses, and takes a single step. */
  step(): void {
    this.pause();
    this.clock.reset();
    this.#alpha = 1;
    this.#guard(() => this.#step(this.clock.step));
    this.invalidate();
  }

  /** Runs on without a picture: for a thumbnail that must not move. */
  skip(seconds: number): void {
    this.#guard(() => {
      for (let n = Math.round(seconds / this.clock.step); n > 0; n--) this.#step(this.clock.step);
    });
    this.invalidate();
  }

  /** Builds the scene anew, from `values` and `seed`. What played plays on, and so does what had failed; the camera stays. */
  reset(): void {
    const mended = this.#failed;
    this.#failed = false;
    this.#guard(() => {
      this.#setup = this.scene.build(this.values, this.seed);
      for (const [index, { world, label }] of this.#worlds().entries()) {
        this.#panes[index].world = world;
        this.#panes[index].label = label ?? '';
      }
    });
    this.clock.reset();
    this.#alpha = 1;
    this.#forgetTime();
    this.invalidate();
    if (mended) this.play();
    else this.#options.changed?.();
  }

  /** Changes the renderer. The old picture runs on until the new one is ready. */
  async useRenderer(kind: RendererKind): Promise<void> {
    this.#wantedKind = kind;
    if (kind === this.#kind) return;
    let pictures: Picture[];
    try {
      pictures = await Promise.all(this.#panes.map(() => makePicture(kind, this.#style)));
    } catch (error) {
      this.#fail(error);
      return;
    }
    if (this.#wantedKind !== kind || this.#destroyed) {
      for (const picture of pictures) picture.destroy();
      return;
    }
    this.#kind = kind;
    for (const [index, pane] of this.#panes.entries()) {
      pane.replacePicture(pictures[index]);
      pane.setStyle(this.#style);
    }
    this.#guard(() => this.#draw());
    this.#options.changed?.();
  }

  usePalette(palette: Palette): void {
    this.#palette = palette;
    this.#style = this.scene.style(palette);
    for (const pane of this.#panes) pane.setStyle(this.#style);
    this.#paintGround();
    this.invalidate();
  }

  /** Does something to the scene on the reader's behalf; what it throws is shown as an error of a step is. */
  attempt(work: () => void): void {
    this.#guard(work);
    this.invalidate();
  }

  /** Does what a key of the scene's own does. Returns whether there is such a key. */
  act(key: string | undefined): boolean {
    const action = this.#setup.actions?.find((candidate) => candidate.key === key);
    if (action) this.attempt(action.run);
    return action !== undefined;
  }

  /** Tells that a value was changed which the running scene reads by itself. */
  announce(): void {
    this.invalidate();
    this.#options.changed?.();
  }

  /** Whether the view is as the scene has it. */
  get fitted(): boolean {
    return this.#fitted;
  }

  /** The view as the scene has it. */
  fit(): void {
    this.moveCameras((camera) => camera.fit(this.scene.show));
    this.#fitted = true;
    this.#options.changed?.();
  }

  /** Moves the camera of each pane in the same way. */
  moveCameras(move: (camera: Camera) => void): void {
    for (const { camera } of this.#panes) move(camera);
    this.invalidate();
    if (!this.#fitted) return;
    this.#fitted = false;
    this.#options.changed?.();
  }

  /** Asks for a frame, where none is coming anyway. */
  invalidate(): void {
    if (this.#frame === 0 && !this.#destroyed) this.#frame = requestAnimationFrame(this.#onFrame);
  }

  destroy(): void {
    this.#destroyed = true;
    cancelAnimationFrame(this.#frame);
    document.removeEventListener('visibilitychange', this.#forgetTime);
    this.#resizes.disconnect();
    this.#sight.disconnect();
    for (const pane of this.#panes) pane.destroy();
  }

  readonly #onFrame = (now: number): void => {
    this.#frame = 0;
    this.#guard(() => {
      if (this.#playing && this.#inSight) this.#advance(now);
      this.#draw();
    });
    if (this.#playing && this.#inSight) this.invalidate();
    else this.#forgetTime();
  };

  #advance(now: number): void {
    const elapsed = (now - this.#lastTime) / 1000;
    this.#lastTime = now;
    if (!(elapsed > 0)) return;
    const started = performance.now();
    const steps = this.clock.advance(Math.min(elapsed, LONGEST_FRAME) * this.speed, (dt) => this.#step(dt));
    this.#alpha = Math.min(1, this.clock.alpha);
    this.statistics.frame(elapsed, steps, (performance.now() - started) / 1000);
  }

  #step(dt: number): void {
    stepSetup(this.#setup, dt);
  }

  #draw(): void {
    const width = this.#panes[0].camera.width * this.#panes.length;
    const textSize = width < WORDLESS ? 0 : this.#panes[0].camera.width < 560 ? 10.5 : 13;
    const ink = { palette: this.#palette, style: this.#style, textSize };
    for (const [index, { guides }] of this.#worlds().entries()) {
      const pane = this.#panes[index];
      pane.draw(this.#alpha, [...(guides?.() ?? []), ...this.extraGuides(pane)], ink);
    }
  }

  #worlds(): Pick<Setup, 'world' | 'label' | 'guides'>[] {
    return [this.#setup, ...(this.#setup.beside ?? [])];
  }

  #paintGround(): void {
    this.#host.style.setProperty('--ground', this.#style.background ?? '');
  }

  readonly #forgetTime = (): void => {
    this.#lastTime = Number.NaN;
  };

  #guard(work: () => void): void {
    if (this.#failed) return;
    try {
      work();
    } catch (error) {
      this.#fail(error);
    }
  }

  #fail(error: unknown): void {
    this.#failed = true;
    this.#playing = false;
    if (!this.#options.failed) throw error;
    this.#options.failed(error);
    this.#options.changed?.();
  }
}
