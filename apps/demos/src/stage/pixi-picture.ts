import type { Style } from '@mass/core/view';
import { PixiRenderer } from '@mass/pixi';
import { autoDetectRenderer, Container } from 'pixi.js';
import type { Picture } from './picture.ts';

/** A picture by PixiJS. WebGL is asked for, since it is there wherever WebGPU is. */
export async function pixiPicture(style: Style): Promise<Picture> {
  const canvas = document.createElement('canvas');
  const system = await autoDetectRenderer({
    canvas,
    preference: 'webgl',
    antialias: true,
    backgroundAlpha: 0,
    // The stage sizes its canvas by CSS; PixiJS gives it the pixels alone.
    autoDensity: false,
  });
  const root = new Container();
  const renderer = new PixiRenderer(root, { style, renderer: system });
  return {
    canvas,
    renderer,
    draw(world, camera, alpha) {
      renderer.render(world, camera, alpha);
      system.render(root);
    },
    resize: (width, height, pixelRatio) => renderer.resize(width, height, pixelRatio),
    destroy() {
      renderer.destroy();
      root.destroy();
      system.destroy();
    },
  };
}
