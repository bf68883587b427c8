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
import { Container, type Renderer as PixiSystem, Sprite, Texture } from 'pixi.js';
import { Atlas } from './atlas.ts';
import { drawDiscs } from './draw-discs.ts';
import { drawPaths } from './draw-paths.ts';
import { drawTrails } from './draw-trails.ts';
import { QuadBatch } from './quad-batch.ts';
import { Swatches } from './swatches.ts';
import { Triangles } from './triangles.ts';

/** How to draw. */
export interface PixiRendererOptions {
  /** @default blue discs on a transparent ground */
  readonly style?: Style;
  /** The game's pixi renderer: then `resize` resizes it too, and its resolution is the one drawn for. */
  readonly renderer?: PixiSystem;
}

/**
 * Draws a world into a container of the game's own PixiJS application. `render` puts everything in place; the pixels come
 * when the application renders, by its ticker or by `app.render()`. One unit of the container is one CSS px. All discs,
 * outlines and trails together are one draw call; the ground, what lies under the discs, and arrows are one each.
 */
export class PixiRenderer implements Renderer<Container> {
  readonly #root = new Container({ label: 'mass', eventMode: 'passive' });
  readonly #background = new Sprite({ texture: Texture.WHITE, visible: false, eventMode: 'none' });
  readonly #layer = new Container({ label: 'mass bound' });
  readonly #atlas = new Atlas();
  readonly #batch: QuadBatch = new QuadBatch(this.#atlas.solid);
  readonly #swatches = new Swatches();
  readonly #ground = new Triangles(this.#swatches);
  readonly #below = new Triangles(this.#swatches);
  readonly #above = new Triangles(this.#swatches);
  readonly #list = new DrawList();
  readonly #bindings: Bindings<Container>;
  readonly #bodyBindings: Bindings<Container, Body>;
  readonly #pose: Pose = { x: 0, y: 0, angle: 0 };
  #camera: Camera | null = null;
  #alpha = 1;
  readonly #renderer: PixiSystem | undefined;
  #style: Style;
  #palette: Palette;
  #trails: Trails;
  #sketch: Sketch;
  #groundVersion = -1;
  #groundRatio = 0;
  #size: { width: number; height: number; pixelRatio: number } | null = null;
  #pixelRatio = 1;
  #destroyed = false;

  constructor(container: Container, { style = {}, renderer }: PixiRendererOptions = {}) {
    if (typeof container?.addChild !== 'function') {
      throw new TypeError(
        `PixiRenderer: the container must be a PixiJS Container, such as app.stage; got ${container}.`,
      );
    }
    this.#style = style;
    this.#palette = new Palette(style);
    this.#trails = new Trails(this.#palette);
    this.#sketch = new Sketch(style, this.#palette);
    this.#renderer = renderer;
    const release = (drawing: Container): void => {
      if (drawing.parent === this.#layer) this.#layer.removeChild(drawing);
    };
    this.#bindings = new Bindings('PixiRenderer', release);
    this.#bodyBindings = new Bindings('PixiRenderer', release);
    this.#root.addChild(this.#background, this.#ground.mesh, this.#below.mesh);
    this.#root.addChild(this.#batch.container, this.#layer, this.#above.mesh);
    container.addChild(this.#root);
  }

  get style(): Style {
    return this.#style;
  }
  set style(style: Style) {
    if (style === this.#style) return;
    const palette = new Palette(style);
    this.#sketch = new Sketch(style, palette);
    this.#groundVersion = -1;
    this.#palette = palette;
    this.#trails = this.#trails.withPalette(palette);
    this.#style = style;
  }

  resize(width: number, height: number, pixelRatio = 1): void {
    if (!(width >= 0 && width < Infinity && height >= 0 && height < Infinity)) {
      throw new RangeError(
        `PixiRenderer.resize: width and height must be finite numbers of CSS px, 0 or more; got ${width}, ${height}.`,
      );
    }
    if (!(pixelRatio > 0 && pixelRatio < Infinity)) {
      throw new RangeError(
        `PixiRenderer.resize: pixelRatio must be a positive, finite number of device px per CSS px; got ${pixelRatio}. Use devicePixelRatio.`,
      );
    }
    this.#size = { width, height, pixelRatio };
  }

  render(world: ViewedWorld, camera: Camera, alpha: number): void {
    if (this.#destroyed) {
      throw new Error('PixiRenderer.render: the renderer must not be destroyed; it was. Make a new one.');
    }
    const palette = this.#palette;
    this.#bindings.prune(world.particles);
    this.#bodyBindings.prune(world.particles);
    const hidden = this.#sketch.hide(world, this.#bindings.bound, this.#bodyBindings.bound);
    this.#list.update(world, palette, camera, alpha, hidden);
    this.#sketch.update(world, this.#list, camera, alpha);
    this.#applySize();
    this.#paintBackground(camera);
    if (palette.hasTrails) this.#trails.update(world);
    this.#fill(world, camera);
    if (this.#atlas.full) {
      this.#atlas.reset();
      this.#fill(world, camera);
    }
    this.#atlas.end();
    this.#drawSketch();
    if (this.#swatches.full) {
      this.#swatches.reset();
      this.#groundVersion = -1;
      this.#drawSketch();
    }
    this.#swatches.end();
    this.#camera = camera;
    this.#alpha = alpha;
    this.#bodyBindings.forEach(this.#placeBody);
    this.#bindings.forEach(this.#place);
  }

  /**
   * Draws a sprite, or any other container, where the particle or body is. Its position is set, and for a body its rotation;
   * all else of it is the game's.
   */
  bind(target: Particle | Body, drawing: Container): void {
    if (typeof drawing?.addChild !== 'function') {
      throw new TypeError(
        `PixiRenderer.bind: the drawing must be a PixiJS Container or Sprite; got ${typeof drawing}.`,
      );
    }
    if (isBody(target)) this.#bodyBindings.bind(target, drawing);
    else this.#bindings.bind(target, drawing);
    this.#layer.addChild(drawing);
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
    this.#root.removeFromParent();
    this.#batch.container.removeFromParent();
    this.#batch.destroy();
    for (const triangles of [this.#ground, this.#below, this.#above]) triangles.destroy();
    this.#background.destroy();
    this.#layer.destroy();
    this.#root.destroy();
    this.#atlas.destroy();
    this.#swatches.destroy();
  }

  /** The ground is left as it is until it looks another way. */
  #drawSketch(): void {
    const { ground, below, above } = this.#sketch;
    const ratio = this.#pixelRatio;
    if (this.#groundVersion !== ground.version || this.#groundRatio !== ratio) {
      this.#groundVersion = ground.version;
      this.#groundRatio = ratio;
      drawPaths(this.#ground, ground, ratio);
    }
    drawPaths(this.#below, below, ratio);
    drawPaths(this.#above, above, ratio);
  }

  #fill(world: ViewedWorld, camera: Camera): void {
    const batch = this.#batch;
    batch.begin();
    if (this.#palette.hasTrails) {
      drawTrails(batch, this.#atlas, world, this.#list, this.#trails, this.#palette, camera, this.#pixelRatio);
    }
    drawDiscs(batch, this.#atlas, this.#list, this.#palette, this.#pixelRatio);
    batch.end();
  }

  /** Resizing a renderer empties its canvas, so it waits until there is something new to show. */
  #applySize(): void {
    const renderer = this.#renderer;
    if (this.#size !== null) {
      const { width, height, pixelRatio } = this.#size;
      this.#size = null;
      this.#pixelRatio = pixelRatio;
      renderer?.resize(width, height, pixelRatio);
    }
    if (renderer) this.#pixelRatio = renderer.resolution;
  }

  #paintBackground({ width, height }: Camera): void {
    const { background } = this.#style;
    const sprite = this.#background;
    sprite.visible = background !== undefined;
    if (background === undefined) return;
    sprite.tint = background;
    sprite.width = width;
    sprite.height = height;
  }

  readonly #place = (drawing: Container, particle: Particle): void => {
    if (drawing.destroyed) {
      this.#bindings.unbind(particle);
      return;
    }
    drawing.position.set(this.#list.x[particle.slot], this.#list.y[particle.slot]);
  };
  readonly #placeBody = (drawing: Container, body: Body): void => {
    if (drawing.destroyed) {
      this.#bodyBindings.unbind(body);
      return;
    }
    const camera = this.#camera as Camera;
    const { x, y, angle } = body.pose(this.#alpha, this.#pose);
    drawing.position.set(camera.toScreenX(x), camera.toScreenY(y));
    drawing.rotation = -angle;
  };
}

function isBody(target: Particle | Body): target is Body {
  return typeof target === 'object' && target !== null && 'pose' in target;
}
