import { requireShare } from '../math/checks.ts';
import type { Camera } from './camera.ts';
import { interpolate } from './interpolate.ts';
import type { Palette } from './palette.ts';
import type { ViewedWorld } from './viewed-world.ts';

/**
 * The discs of one frame: where each is on the screen, and which to draw in which order, sorted by paint. A renderer walks
 * `order` from `starts[p]` to `starts[p + 1]` for each paint `p`. Made once, filled anew each frame; it allocates only when
 * the world has grown. For authors of renderers.
 */
export class DrawList {
  /** Screen position by slot, of every living particle. Unit: CSS px. */
  x: Float64Array = new Float64Array(0);
  y: Float64Array = new Float64Array(0);
  /** Outer radius by slot, an outline included, for the slots in `order`. Unit: CSS px. */
  radius: Float64Array = new Float64Array(0);
  /** Class by slot, as the palette has it. */
  classes: Uint16Array = new Uint16Array(0);
  /** Slots to draw, first to last. */
  order: Uint32Array = new Uint32Array(0);
  /** Where in `order` each paint starts; one entry more than there are paints. */
  starts: Uint32Array = new Uint32Array(0);
  #paints = new Uint32Array(0);

  /** Looks at the world again. `hidden` is 1 for slots whose disc is not drawn. Discs outside the view are left out. */
  update(world: ViewedWorld, palette: Palette, camera: Camera, alpha: number, hidden: Uint8Array): void {
    requireShare('Renderer.render', 'alpha', alpha, 'FixedTimestep.alpha is such a share.');
    const particles = world.particles;
    this.#reserve(particles.count, palette.paints.length);
    interpolate(particles, alpha, this.x, this.y);
    palette.assign(particles, this.classes, this.#paints);
    this.#place(particles.count, particles.radius, palette, camera);
    this.#sort(particles.count, particles.alive, hidden, camera);
  }

  #reserve(slots: number, paints: number): void {
    if (this.x.length < slots) {
      const size = Math.max(64, Math.ceil(slots * 1.5));
      this.x = new Float64Array(size);
      this.y = new Float64Array(size);
      this.radius = new Float64Array(size);
      this.classes = new Uint16Array(size);
      this.order = new Uint32Array(size);
      this.#paints = new Uint32Array(size);
    }
    if (this.starts.length !== paints + 1) this.starts = new Uint32Array(paints + 1);
  }

  #place(count: number, discs: Float64Array, { paints, minRadius }: Palette, camera: Camera): void {
    const { x, y, radius, classes } = this;
    const paintOf = this.#paints;
    const scale = camera.pixelsPerMetre;
    const left = camera.toScreenX(0);
    const top = camera.toScreenY(0);
    for (let i = 0; i < count; i++) {
      x[i] = left + x[i] * scale;
      y[i] = top - y[i] * scale;
      // An outline lies inside the disc, so that a disc is at least as large as its outline.
      radius[i] = Math.max(discs[i] * scale, minRadius[classes[i]], paints[paintOf[i]].strokeWidth);
    }
  }

  /** A counting sort: slots by paint, in order of slot within each. */
  #sort(count: number, alive: Uint8Array, hidden: Uint8Array, { width, height }: Camera): void {
    const { x, y, radius, order, starts } = this;
    const paintOf = this.#paints;
    starts.fill(0);
    for (let i = 0; i < count; i++) {
      const r = radius[i] + 1;
      const seen =
        alive[i] === 1 && !(hidden[i] === 1) && x[i] > -r && y[i] > -r && x[i] < width + r && y[i] < height + r;
      if (seen) starts[paintOf[i]]++;
      else paintOf[i] = 0xffffffff;
    }
    let total = 0;
    for (let p = 0; p < starts.length; p++) {
      total += starts[p];
      starts[p] = total;
    }
    for (let i = count - 1; i >= 0; i--) {
      if (paintOf[i] !== 0xffffffff) order[--starts[paintOf[i]]] = i;
    }
  }
}
