export { PixiRenderer, type PixiRendererOptions } from './pixi-renderer.ts';
