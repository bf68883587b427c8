import { BufferImageSource, Texture } from 'pixi.js';

const columns = 256;
const rows = 16;
const capacity = (columns / 2) * rows;

/**
 * Colours as a texture: of each a pair of texture pixels, one without and one with the colour. A triangle whose corners lie
 * between the two is covered by that share, so that a mesh has many colours and soft edges, without a shader of its own.
 */
export class Swatches {
  readonly texture: Texture;
  readonly #source: BufferImageSource;
  #image = new Uint8Array(columns * rows * 4);
  readonly #places = new Map<number, number>();
  #dirty = true;
  #full = false;

  constructor() {
    this.#source = new BufferImageSource({
      resource: this.#image,
      width: columns,
      height: rows,
      format: 'rgba8unorm',
      alphaMode: 'premultiplied-alpha',
      scaleMode: 'linear',
      addressMode: 'clamp-to-edge',
      autoGarbageCollect: false,
      label: 'mass swatches',
    });
    this.texture = new Texture({ source: this.#source, label: 'mass swatches' });
  }

  /** Whether a colour was asked for that had no room: draw the frame again after `reset`. */
  get full(): boolean {
    return this.#full;
  }

  /** The place of a colour 0xrrggbb at an opacity. */
  place(rgb: number, alpha: number): number {
    const opacity = Math.round(alpha * 255);
    const key = rgb * 256 + opacity;
    const found = this.#places.get(key);
    if (found !== undefined) return found;
    const place = this.#places.size;
    if (place === capacity) {
      this.#full = true;
      return 0;
    }
    this.#places.set(key, place);
    const at = (2 * place + 1) * 4;
    for (let channel = 0; channel < 3; channel++) {
      this.#image[at + channel] = Math.round((((rgb >> (16 - 8 * channel)) & 255) * opacity) / 255);
    }
    this.#image[at + 3] = opacity;
    this.#dirty = true;
    return place;
  }

  /** Where in the texture a colour is absent, across; `full` is one `pitch` farther. */
  u(place: number): number {
    return (2 * (place % (columns / 2)) + 0.5) / columns;
  }

  v(place: number): number {
    return (Math.floor(place / (columns / 2)) + 0.5) / rows;
  }

  /** From where a colour is absent to where it is full. */
  readonly pitch: number = 1 / columns;

  /** Forgets every colour. */
  reset(): void {
    this.#places.clear();
    this.#image.fill(0);
    this.#full = false;
    this.#dirty = true;
  }

  /** Ends a frame: new colours go to the graphics card. */
  end(): void {
    if (this.#dirty) this.#source.update();
    this.#dirty = false;
  }

  /** Frees the texture. */
  destroy(): void {
    this.texture.destroy();
    // Unloaded, not destroyed: pixi's mesh shader keeps hold of the last texture that it drew, and would warn.
    this.#source.unload();
    this.#image = new Uint8Array(0);
    this.#source.resource = this.#image;
  }
}
