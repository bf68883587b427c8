import type { Body, Particle, Pose } from '@mass/core';
import {
  Bindings,
  type Camera,
  DrawList,
  Palette,
  type Renderer,
  Sketch,
  type Style,
  Trails,
  type ViewedWorld,
} from '@mass/core/view';
import type { CanvasContext } from './canvas-context.ts';
import { drawDiscs } from './draw-discs.ts';
import { drawPaths } from './draw-paths.ts';
import { drawTrails } from './draw-trails.ts';

/** What a renderer draws into: a canvas, of the page or of a worker, or its 2D context. */
export type CanvasTarget = HTMLCanvasElement | OffscreenCanvas | CanvasContext;

/**
 * A game's own drawing of a particle. Position and radius are in CSS px, y down; what it changes in the context, paths
 * aside, is put back after it.
 */
export type CanvasDrawing = (context: CanvasContext, x: number, y: number, radius: number, particle: Particle) => void;

/**
 * A game's own drawing of a body. The position of its centre is in CSS px, y down; the angle is one to hand to
 * `context.rotate`. What it changes in the context, paths aside, is put back after it.
 */
export type CanvasBodyDrawing = (context: CanvasContext, x: number, y: number, angle: number, body: Body) => void;

/** How to draw. */
export interface CanvasRendererOptions {
  /** @default blue discs on a transparent ground */
  readonly style?: Style;
}

/**
 * Draws a world into a canvas. The canvas is the renderer's: each `render` paints all of it. Its size on the page is the
 * game's to set, by CSS; `resize` gives it the pixels.
 */
export class CanvasRenderer implements Renderer<CanvasDrawing, CanvasBodyDrawing> {
  readonly #context: CanvasContext;
  readonly #list = new DrawList();
  readonly #bindings = new Bindings<CanvasDrawing>('CanvasRenderer');
  readonly #bodyBindings = new Bindings<CanvasBodyDrawing, Body>('CanvasRenderer');
  readonly #pose: Pose = { x: 0, y: 0, angle: 0 };
  #camera: Camera | null = null;
  #alpha = 1;
  #style: Style;
  #palette: Palette;
  #trails: Trails;
  #sketch: Sketch;
  #width: number;
  #height: number;
  #pixelRatio = 1;
  #destroyed = false;

  /** Throws when the canvas has given out a context of another kind. */
  constructor(target: CanvasTarget, { style = {} }: CanvasRendererOptions = {}) {
    this.#context = contextOf(target);
    this.#style = style;
    this.#palette = new Palette(style);
    this.#trails = new Trails(this.#palette);
    this.#sketch = new Sketch(style, this.#palette);
    this.#width = this.#context.canvas.width;
    this.#height = this.#context.canvas.height;
  }

  get style(): Style {
    return this.#style;
  }
  set style(style: Style) {
    if (style === this.#style) return;
    const palette = new Palette(style);
    this.#sketch = new Sketch(style, palette);
    this.#palette = palette;
    this.#trails = this.#trails.withPalette(palette);
    this.#style = style;
  }

  resize(width: number, height: number, pixelRatio = 1): void {
    requireSize('CanvasRenderer.resize', width, height, pixelRatio);
    this.#width = width;
    this.#height = height;
    this.#pixelRatio = pixelRatio;
  }

  render(world: ViewedWorld, camera: Camera, alpha: number): void {
    if (this.#destroyed) {
      throw new Error('CanvasRenderer.render: the renderer must not be destroyed; it was. Make a new one.');
    }
    const context = this.#context;
    const palette = this.#palette;
    this.#bindings.prune(world.particles);
    this.#bodyBindings.prune(world.particles);
    const hidden = this.#sketch.hide(world, this.#bindings.bound, this.#bodyBindings.bound);
    this.#list.update(world, palette, camera, alpha, hidden);
    this.#sketch.update(world, this.#list, camera, alpha);
    this.#clear();
    context.save();
    drawPaths(context, this.#sketch.ground);
    drawPaths(context, this.#sketch.below);
    if (palette.hasTrails) {
      this.#trails.update(world);
      drawTrails(context, world, this.#list, this.#trails, palette, camera);
    }
    drawDiscs(context, this.#list, palette);
    context.globalAlpha = 1;
    this.#camera = camera;
    this.#alpha = alpha;
    this.#bodyBindings.forEach(this.#drawBoundBody);
    this.#bindings.forEach(this.#drawBound);
    drawPaths(context, this.#sketch.above);
    context.restore();
  }

  bind(particle: Particle, drawing: CanvasDrawing): void;
  bind(body: Body, drawing: CanvasBodyDrawing): void;
  bind(target: Particle | Body, drawing: CanvasDrawing | CanvasBodyDrawing): void {
    if (typeof drawing !== 'function') {
      throw new TypeError(
        'CanvasRenderer.bind: the drawing must be a function (context, x, y, radius, particle) or (context, x, y, angle, body); ' +
          `got ${typeof drawing}.`,
      );
    }
    if (isBody(target)) this.#bodyBindings.bind(target, drawing as CanvasBodyDrawing);
    else this.#bindings.bind(target, drawing as CanvasDrawing);
  }

  unbind(target: Particle | Body): void {
    if (isBody(target)) this.#bodyBindings.unbind(target);
    else this.#bindings.unbind(target);
  }

  destroy(): void {
    if (this.#destroyed) return;
    this.#destroyed = true;
    this.#bindings.clear();
    this.#bodyBindings.clear();
    this.#trails.clear();
    const { canvas } = this.#context;
    this.#context.setTransform(1, 0, 0, 1, 0, 0);
    this.#context.clearRect(0, 0, canvas.width, canvas.height);
  }

  /** Resizing a canvas empties it, so it happens here, where it is painted anew at once. */
  #clear(): void {
    const context = this.#context;
    const { canvas } = context;
    const width = Math.round(this.#width * this.#pixelRatio);
    const height = Math.round(this.#height * this.#pixelRatio);
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    context.setTransform(1, 0, 0, 1, 0, 0);
    const { background } = this.#style;
    if (background === undefined) context.clearRect(0, 0, width, height);
    else {
      context.globalAlpha = 1;
      context.globalCompositeOperation = 'source-over';
      context.fillStyle = background;
      context.fillRect(0, 0, width, height);
    }
    context.setTransform(this.#pixelRatio, 0, 0, this.#pixelRatio, 0, 0);
  }

  readonly #drawBound = (drawing: CanvasDrawing, particle: Particle): void => {
    const { x, y, radius } = this.#list;
    const { slot } = particle;
    this.#context.save();
    drawing(this.#context, x[slot], y[slot], radius[slot], particle);
    this.#context.restore();
  };

  readonly #drawBoundBody = (drawing: CanvasBodyDrawing, body: Body): void => {
    const camera = this.#camera as Camera;
    const { x, y, angle } = body.pose(this.#alpha, this.#pose);
    this.#context.save();
    drawing(this.#context, camera.toScreenX(x), camera.toScreenY(y), -angle, body);
    this.#context.restore();
  };
}

function isBody(target: Particle | Body): target is Body {
  return typeof target === 'object' && target !== null && 'pose' in target;
}

function contextOf(target: CanvasTarget): CanvasContext {
  if (target !== null && typeof target === 'object') {
    if ('fillRect' in target) return target;
    const context = 'getContext' in target ? (target.getContext('2d') as CanvasContext | null) : null;
    if (context !== null) return context;
  }
  throw new TypeError(
    `CanvasRenderer: the target must be a canvas that can give a 2D context, or such a context; got ${String(target)}. ` +
      'A canvas that has given out a WebGL context gives no other.',
  );
}

function requireSize(where: string, width: number, height: number, pixelRatio: number): void {
  if (!(width >= 0 && width < Infinity && height >= 0 && height < Infinity)) {
    throw new RangeError(
      `${where}: width and height must be finite numbers of CSS px, 0 or more; got ${width}, ${height}.`,
    );
  }
  if (!(pixelRatio > 0 && pixelRatio < Infinity)) {
    throw new RangeError(
      `${where}: pixelRatio must be a positive, finite number of device px per CSS px; got ${pixelRatio}. Use devicePixelRatio.`,
    );
  }
}
