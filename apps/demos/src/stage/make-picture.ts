import { CanvasRenderer } from '@mass/canvas2d';
import type { Style } from '@mass/core/view';
import type { Picture } from './picture.ts';
import type { RendererKind } from './renderers.ts';

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
