import type { World } from '@mass/core';
import type { Bounds, Style } from '@mass/core/view';
import { Camera } from '@mass/core/view';
import type { Guide } from '../scenes/scene.ts';
import { type Ink, Overlay } from './overlay.ts';
import type { Picture } from './picture.ts';

/** One world on the page: its picture, what is drawn over it, its camera. A scene of two worlds has two. */
export class Pane {
  readonly element: HTMLElement;
  readonly camera: Camera = new Camera();
  world: World;
  readonly #overlay: Overlay;
  readonly #heading: HTMLElement;
  #picture: Picture;
  #ratio = 1;

  constructor(world: World, picture: Picture, show: Bounds) {
    this.world = world;
    this.#picture = picture;
    this.camera.fit(show);
    this.element = document.createElement('div');
    this.element.className = 'pane';
    const over = document.createElement('canvas');
    over.className = 'overlay';
    this.#overlay = new Overlay(over);
    this.#heading = document.createElement('p');
    this.#heading.className = 'pane-label';
    picture.canvas.className = 'picture';
    this.element.append(picture.canvas, over, this.#heading);
  }

  get picture(): Picture {
    return this.#picture;
  }

  set label(text: string) {
    this.#heading.textContent = text;
  }

  /** Puts another picture in the place of this one, which is freed. */
  replacePicture(picture: Picture): void {
    const old = this.#picture;
    picture.canvas.className = 'picture';
    picture.resize(this.camera.width, this.camera.height, this.#ratio);
    this.#picture = picture;
    old.canvas.replaceWith(picture.canvas);
    old.destroy();
  }

  /** Takes the size that the page gives. Units: CSS px, and device px in each of them. */
  resize(width: number, height: number, ratio: number): void {
    this.#ratio = ratio;
    this.camera.resize(width, height);
    this.#picture.resize(width, height, ratio);
    this.#overlay.resize(width, height, ratio);
  }

  draw(alpha: number, guides: readonly Guide[], ink: Ink): void {
    if (this.camera.width === 0 || this.camera.height === 0) return;
    this.#picture.draw(this.world, this.camera, alpha);
    this.#overlay.draw(guides, this.camera, ink);
  }

  setStyle(style: Style): void {
    this.#picture.renderer.style = style;
  }

  destroy(): void {
    this.#picture.destroy();
    this.element.remove();
  }
}
