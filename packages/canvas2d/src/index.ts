export {
  type CanvasBodyDrawing,
  type CanvasDrawing,
  CanvasRenderer,
  type CanvasRendererOptions,
  type CanvasTarget,
} from './canvas-renderer.ts';
