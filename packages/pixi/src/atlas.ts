import { BufferImageSource, Rectangle, Texture } from 'pixi.js';
import { bakeLine, bakeRing } from './bake.ts';

/** Sizes in each doubling of the radius: a shape is never scaled by more than 4.5 %, so its edge stays as sharp as baked. */
const sizesPerOctave = 8;
const smallestSize = -8; // a radius of half a texture pixel
const largestSize = 64; // of 256, half as many on the screen; what is larger is scaled up, and its edge softens
/** Texture pixels to a device pixel: at 1 the soft edge as baked and the one of sampling would add up to a blur. */
const oversampling = 2;
const gap = 1;
const discs = 0;
const rings = 1;
const lines = 2;
const firstExtent = 512;
const lastExtent = 2048;

/** Up to this radius a ring of the atlas has the width that was asked for. Unit: device px. */
export const largestRing = 64;

/** A shape in the atlas. */
export interface AtlasEntry {
  readonly texture: Texture;
  /** Outer radius of a disc or ring, width of a line, as baked. Unit: texture pixels. */
  readonly size: number;
}

/**
 * White discs, rings and lines of many sizes in one texture, baked when first asked for. It grows; once it is as large as
 * it may be and full, the frame is to be drawn again, from an empty atlas that gets only what the frame needs.
 */
export class Atlas {
  /** A fully covered spot, for lines and rectangles: 1 texture pixel square. */
  readonly solid: Texture;
  readonly #source: BufferImageSource;
  #image: Uint8Array;
  #extent = firstExtent;
  readonly #entries = new Map<number, AtlasEntry>();
  #shelfX = 0;
  #shelfY = 0;
  #shelfHeight = 0;
  #dirty = false;
  #full = false;

  constructor() {
    this.#image = new Uint8Array(this.#extent * this.#extent * 4);
    this.#source = makeSource(this.#image, this.#extent);
    this.solid = new Texture({ source: this.#source, frame: new Rectangle(1, 1, 1, 1), label: 'mass solid' });
    this.reset();
  }

  /** How many shapes are baked. */
  get size(): number {
    return this.#entries.size;
  }

  /** Whether something was asked for that had no room. */
  get full(): boolean {
    return this.#full;
  }

  /** Forgets every shape. */
  reset(): void {
    for (const { texture } of this.#entries.values()) texture.destroy();
    this.#entries.clear();
    this.#image.fill(0);
    for (let row = 0; row < 3; row++) this.#image.fill(255, row * this.#extent * 4, row * this.#extent * 4 + 12);
    this.#shelfX = 4;
    this.#shelfY = 0;
    this.#shelfHeight = 4;
    this.#full = false;
    this.#dirty = true;
  }

  /** Ends a frame: what was baked goes to the graphics card. */
  end(): void {
    if (this.#dirty) this.#source.update();
    this.#dirty = false;
  }

  /** A disc of about so many device pixels' radius. */
  disc(radius: number): AtlasEntry {
    return this.#entry(discs, sizeOf(radius), 0);
  }

  /** A ring of about so many device pixels' outer radius, and width. */
  ring(radius: number, width: number): AtlasEntry {
    return this.#entry(rings, sizeOf(radius), eighthsOf(width));
  }

  /** A piece of a horizontal line of about so many device pixels' width: 1 texture pixel long, to be stretched. */
  line(width: number): AtlasEntry {
    return this.#entry(lines, 0, eighthsOf(width));
  }

  /** Frees the texture. */
  destroy(): void {
    for (const { texture } of this.#entries.values()) texture.destroy();
    this.#entries.clear();
    this.solid.destroy();
    // Unloaded, not destroyed: pixi's particle shader keeps hold of the last texture that it drew, and would warn.
    this.#source.unload();
    this.#image = new Uint8Array(0);
    this.#source.resource = this.#image;
  }

  #entry(kind: number, size: number, eighths: number): AtlasEntry {
    const key = (kind * 256 + size - smallestSize) * 1024 + eighths;
    const found = this.#entries.get(key);
    if (found !== undefined) return found;
    const entry =
      kind === lines ? this.#bakeLine(eighths / 8) : this.#bakeRing(2 ** (size / sizesPerOctave), eighths / 8);
    if (entry === undefined) return this.#nearest(kind, key);
    this.#entries.set(key, entry);
    return entry;
  }

  #bakeRing(radius: number, width: number): AtlasEntry | undefined {
    const side = 2 * Math.ceil(radius + 1);
    const frame = this.#place(side, side);
    if (frame === undefined) return undefined;
    const inner = width > 0 ? Math.max(0, radius - width) : 0;
    bakeRing(this.#image, this.#extent, frame.x, frame.y, side, inner, radius);
    return { texture: new Texture({ source: this.#source, frame, label: 'mass disc' }), size: radius };
  }

  #bakeLine(width: number): AtlasEntry | undefined {
    const height = 2 * Math.ceil(width / 2 + 1);
    const frame = this.#place(3, height);
    if (frame === undefined) return undefined;
    bakeLine(this.#image, this.#extent, frame.x, frame.y, 3, height, width);
    frame.x += 1; // the columns beside it keep the ends from fading
    frame.width = 1;
    return { texture: new Texture({ source: this.#source, frame, label: 'mass line' }), size: width };
  }

  /** Room for a rectangle: on this shelf, on the next, or after growing. */
  #place(width: number, height: number): Rectangle | undefined {
    if (this.#shelfX + width > this.#extent) {
      this.#shelfX = 0;
      this.#shelfY += this.#shelfHeight;
      this.#shelfHeight = 0;
    }
    while (this.#shelfX + width > this.#extent || this.#shelfY + height > this.#extent) {
      if (this.#extent === lastExtent) {
        this.#full = true;
        return undefined;
      }
      this.#grow();
    }
    const frame = new Rectangle(this.#shelfX, this.#shelfY, width, height);
    this.#shelfX += width + gap;
    this.#shelfHeight = Math.max(this.#shelfHeight, height + gap);
    this.#dirty = true;
    return frame;
  }

  #grow(): void {
    const from = this.#extent;
    const to = from * 2;
    const image = new Uint8Array(to * to * 4);
    for (let row = 0; row < from; row++)
      image.set(this.#image.subarray(row * from * 4, (row + 1) * from * 4), row * to * 4);
    this.#image = image;
    this.#extent = to;
    this.#source.resource = image;
    this.#source.resize(to, to); // the textures hear of it
  }

  /** Of a full atlas: the shape of the same kind whose size is nearest. */
  #nearest(kind: number, key: number): AtlasEntry {
    let best: AtlasEntry = { texture: this.solid, size: 0.5 };
    let least = Infinity;
    for (const [other, entry] of this.#entries) {
      const distance = Math.abs(other - key);
      if (distance >= least || Math.floor(other / (256 * 1024)) !== kind) continue;
      least = distance;
      best = entry;
    }
    return best;
  }
}

function sizeOf(radius: number): number {
  return Math.min(largestSize, Math.max(smallestSize, Math.round(Math.log2(radius * oversampling) * sizesPerOctave)));
}

function eighthsOf(width: number): number {
  return Math.min(1023, Math.max(1, Math.round(width * oversampling * 8)));
}

function makeSource(resource: Uint8Array, extent: number): BufferImageSource {
  return new BufferImageSource({
    resource,
    width: extent,
    height: extent,
    format: 'rgba8unorm',
    alphaMode: 'premultiplied-alpha',
    scaleMode: 'linear',
    addressMode: 'clamp-to-edge',
    autoGarbageCollect: false,
    label: 'mass atlas',
  });
}
