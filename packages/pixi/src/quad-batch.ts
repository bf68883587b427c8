import { ParticleContainer, type Texture } from 'pixi.js';
import { Quad } from './quad.ts';

/** A `ParticleContainer` that is filled anew each frame, without garbage: one draw call, whatever is in it. */
export class QuadBatch {
  readonly container: ParticleContainer<Quad>;
  readonly #pool: Quad[] = [];
  #used = 0;

  constructor(texture: Texture) {
    this.container = new ParticleContainer<Quad>({
      texture,
      dynamicProperties: { vertex: true, position: true, rotation: true, uvs: true, color: true },
      eventMode: 'none',
    });
  }

  /** How many quads the frame has so far. */
  get count(): number {
    return this.#used;
  }

  /** Starts a frame. */
  begin(): void {
    this.#used = 0;
  }

  /** Adds a quad; `color` is 0xrrggbb, `alpha` 0 to 1. Positions and sizes in CSS px, a texture pixel being `scale` of them. */
  add(
    texture: Texture,
    x: number,
    y: number,
    scaleX: number,
    scaleY: number,
    rotation: number,
    color: number,
    alpha: number,
  ): void {
    let quad = this.#pool[this.#used];
    if (quad === undefined) {
      quad = new Quad(texture);
      this.#pool.push(quad);
    }
    this.#used++;
    quad.texture = texture;
    quad.x = x;
    quad.y = y;
    quad.scaleX = scaleX;
    quad.scaleY = scaleY;
    quad.rotation = rotation;
    // pixi wants 0xaabbggrr.
    quad.color = (Math.round(alpha * 255) << 24) | ((color & 255) << 16) | (color & 0xff00) | (color >> 16);
  }

  /** Ends a frame. */
  end(): void {
    const children = this.container.particleChildren;
    const before = children.length;
    if (before > this.#used) children.length = this.#used;
    for (let i = before; i < this.#used; i++) children.push(this.#pool[i]);
  }

  /** Frees the container and its buffers; the texture is not its own. */
  destroy(): void {
    // pixi leaves the index buffer of the batch to its garbage collection, a minute later.
    const gpuData: { [renderer: string]: { geometry?: { indexBuffer?: { destroy(): void } } } } =
      this.container._gpuData;
    const indices = Object.values(gpuData).map((data) => data?.geometry?.indexBuffer);
    this.container.destroy();
    for (const buffer of indices) buffer?.destroy();
    this.container.particleChildren.length = 0;
    this.#pool.length = 0;
    this.#used = 0;
  }
}
