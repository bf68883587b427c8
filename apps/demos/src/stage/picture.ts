import type { Camera, Renderer, ViewedWorld } from '@mass/core/view';

/** One canvas and the renderer that draws into it: the only place where the stage knows one renderer from another. */
export interface Picture {
  readonly canvas: HTMLCanvasElement;
  readonly renderer: Omit<Renderer, 'bind' | 'unbind'>;
  /** Draws a frame. */
  draw(world: ViewedWorld, camera: Camera, alpha: number): void;
  resize(width: number, height: number, pixelRatio: number): void;
  destroy(): void;
}
