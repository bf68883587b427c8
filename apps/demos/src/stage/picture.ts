import { CanvasRenderer } from '@mass/canvas2d';
import type { Camera, Renderer, Style, ViewedWorld } from '@mass/core/view';
import type { RendererKind } from './renderers.ts';

/** One canvas and the renderer that draws into it: the only place where the stage knows one renderer from another. */
export interface Picture {
  readonly canvas: HTMLCanvasElement;
  readonly renderer: Omit<Renderer, 'bind' | 'unbind'>;
  /** Draws a frame. */
  draw(world: ViewedWorld, camera: Camera, alpha: number): void;
  resize(width: number, height: number, pixelRatio: number): void;
  destroy(): void;
}

/** A picture by Canvas 2D: at once, with nothing to load. */
export function canvasPicture(style: Style): Picture {
  const canvas = document.createElement('canvas');
  const renderer = new CanvasRenderer(canvas, { style });
  return {
    canvas,
    renderer,
    draw: (world, camera, alpha) => renderer.render(world, camera, alpha),
    resize: (width, height, pixelRatio) => renderer.resize(width, height, pixelRatio),
    destroy: () => renderer.destroy(),
  };
}

/** A picture by any renderer. PixiJS is loaded when it is asked for, not before. */
export async function makePicture(kind: RendererKind, style: Style): Promise<Picture> {
  if (kind === 'canvas2d') return canvasPicture(style);
  const { pixiPicture } = await import('./pixi-picture.ts');
  return pixiPicture(style);
}
