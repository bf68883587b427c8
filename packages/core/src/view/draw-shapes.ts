import type { Shape } from '../collision/shape.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { Frame } from './frame.ts';
import { addCircle, addRounded, clipToHalfPlane } from './geometry.ts';
import { addHatching } from './hatch.ts';
import { type PathList, type PathPaint, pathKinds } from './path-list.ts';
import { Points } from './points.ts';
import { pathPaint } from './ramp.ts';
import type { SceneStyle } from './scene-style.ts';

/**
 * What a shape may tell of itself, for drawing. A game's own shape that tells an `outline`, its corners in order, is drawn
 * as that polygon; one that tells nothing is not drawn.
 */
interface ToldShape extends Shape {
  readonly outline?: readonly Readonly<Vec2>[];
  readonly corners?: readonly Readonly<Vec2>[];
  readonly points?: readonly Readonly<Vec2>[];
  readonly closed?: boolean;
  readonly thickness?: number;
  readonly a?: Readonly<Vec2>;
  readonly b?: Readonly<Vec2>;
  readonly centre?: Readonly<Vec2>;
  readonly radius?: number;
  readonly point?: Readonly<Vec2>;
  readonly normal?: Readonly<Vec2>;
}

/** A little more than 1: browsers draw lines of 1 px and less by a rule of their own, lighter where they slant. */
const hatchWidth = 1.1;
/** How far past the edge of the view scenery without end is drawn. Unit: CSS px. */
const beyond = 8;

/** Draws static shapes: a fill, hatching on the solid side, and the surface. */
export class ShapeArt {
  readonly #fill: PathPaint | null;
  readonly #stroke: PathPaint | null;
  readonly #hatch: PathPaint | null;
  readonly #spacing: number;
  readonly #view = new Float64Array(8);
  readonly #clipped = new Float64Array(12);
  readonly #ring = new Points();
  readonly #chain = new Points();
  readonly #inner = new Points();
  #radii: Float64Array = new Float64Array(16);

  constructor({ shapes }: SceneStyle) {
    const { fill = null, stroke = null, hatch = null } = shapes ?? {};
    this.#fill = fill === null || !shapes ? null : pathPaint(fill, shapes.fillAlpha, 0);
    this.#stroke = stroke === null || !shapes?.strokeWidth ? null : pathPaint(stroke, 1, shapes.strokeWidth);
    this.#hatch = hatch === null || !shapes ? null : pathPaint(hatch, shapes.hatchAlpha, hatchWidth, true);
    this.#spacing = shapes?.hatchSpacing ?? 0;
  }

  /** Adds the shapes, in order. */
  draw(shapes: readonly Shape[], list: PathList, frame: Frame): void {
    for (let s = 0; s < shapes.length; s++) {
      const shape: ToldShape = shapes[s];
      const { left, top, scale } = frame;
      const x0 = left + shape.minX * scale;
      const y0 = top - shape.maxY * scale;
      if (frame.misses(x0, y0, left + shape.maxX * scale, top - shape.minY * scale, beyond)) continue;
      this.#add(shape, list, frame);
    }
  }

  #add(shape: ToldShape, list: PathList, frame: Frame): void {
    const { a, b, points, point, normal, centre, radius, thickness } = shape;
    const corners = shape.outline ?? shape.corners ?? (thickness === undefined ? points : undefined);
    if (corners) this.#addPolygon(corners, list, frame);
    else if (points) this.#addChain(points, shape.closed === true, thickness ?? 0, list, frame);
    else if (a && b) this.#addChain([a, b], false, thickness ?? 0, list, frame);
    else if (centre && radius) this.#addDisc(centre, radius, list, frame);
    else if (point && normal) this.#addHalfPlane(point, normal, list, frame);
  }

  #addPolygon(corners: readonly Readonly<Vec2>[], list: PathList, frame: Frame): void {
    const ring = this.#ring.clear();
    for (const { x, y } of corners) ring.add(frame.left + x * frame.scale, frame.top - y * frame.scale);
    this.#finish(list, frame, true);
  }

  #addDisc(centre: Readonly<Vec2>, radius: number, list: PathList, frame: Frame): void {
    const { left, top, scale } = frame;
    addCircle(this.#ring.clear(), left + centre.x * scale, top - centre.y * scale, radius * scale);
    this.#finish(list, frame, true);
  }

  #addHalfPlane(point: Readonly<Vec2>, normal: Readonly<Vec2>, list: PathList, frame: Frame): void {
    const { width, height, left, top, scale } = frame;
    const view = this.#view;
    view[0] = view[6] = -beyond;
    view[1] = view[3] = -beyond;
    view[2] = view[4] = width + beyond;
    view[5] = view[7] = height + beyond;
    const px = left + point.x * scale;
    const py = top - point.y * scale;
    const count = clipToHalfPlane(view, 4, px, py, normal.x, -normal.y, this.#clipped);
    if (count < 3) return;
    const ring = this.#ring.clear();
    for (let i = 0; i < count; i++) ring.add(this.#clipped[2 * i], this.#clipped[2 * i + 1]);
    this.#finish(list, frame, false);
    if (this.#stroke === null) return;
    // Along the surface, from the place nearest to the middle of the view, as far as the view can reach.
    const along = (width / 2 - px) * normal.y + (height / 2 - py) * normal.x;
    const x = px + along * normal.y;
    const y = py + along * normal.x;
    const reach = width + height + beyond;
    const inset = this.#stroke.width / 2;
    const dx = -normal.x * inset; // the line lies within the solid
    const dy = normal.y * inset;
    list.line(
      x - reach * normal.y + dx,
      y - reach * normal.x + dy,
      x + reach * normal.y + dx,
      y + reach * normal.x + dy,
      this.#stroke,
    );
  }

  /** A wall along points: a line, or, where it is thick, the outline of one. */
  #addChain(points: readonly Readonly<Vec2>[], closed: boolean, thickness: number, list: PathList, frame: Frame): void {
    const { left, top, scale } = frame;
    const width = thickness * scale;
    const chain = this.#chain.clear();
    for (const { x, y } of points) chain.add(left + x * scale, top - y * scale);
    const line = this.#stroke ?? this.#fill;
    if (width <= (line?.width || 1)) {
      chain.copyTo(list);
      if (line) list.end(closed ? pathKinds.ring : pathKinds.line, line);
      return;
    }
    const { data, count } = chain;
    if (closed) {
      this.#addBand(chain, width, list, frame);
      return;
    }
    for (let k = count - 2; k > 0; k--) chain.add(data[2 * k], data[2 * k + 1]);
    addRounded(this.#ring.clear(), chain.data, chain.count, this.#grow(chain.count, width / 2));
    this.#finish(list, frame, true);
  }

  /** A thick wall around: along its outer side, across, back along its inner side, and across again. */
  #addBand(chain: Points, width: number, list: PathList, frame: Frame): void {
    const { data, count } = chain;
    const ring = this.#ring.clear();
    const inner = this.#inner.clear();
    addRounded(ring, data, count, this.#grow(count, width / 2));
    addRounded(inner, data, count, this.#grow(count, width / 2), true);
    ring.add(ring.data[0], ring.data[1]);
    for (let k = inner.count; k >= 0; k--) {
      const at = 2 * (k % inner.count);
      ring.add(inner.data[at], inner.data[at + 1]);
    }
    this.#finish(list, frame, false);
    if (this.#stroke === null) return;
    for (const inwards of [false, true]) {
      addRounded(list, data, count, this.#grow(count, (width - this.#stroke.width) / 2), inwards);
      list.end(pathKinds.ring, this.#stroke);
    }
  }

  #grow(count: number, radius: number): Float64Array {
    if (this.#radii.length < count) this.#radii = new Float64Array(2 * count);
    return this.#radii.fill(radius);
  }

  /** Paints the ring of points. */
  #finish(list: PathList, frame: Frame, outlined: boolean): void {
    const ring = this.#ring;
    if (this.#fill !== null && this.#fill.alpha > 0) {
      ring.copyTo(list);
      list.end(pathKinds.fill, this.#fill);
    }
    if (this.#hatch !== null && this.#hatch.alpha > 0) addHatching(list, ring, this.#spacing, frame, this.#hatch);
    if (!outlined || this.#stroke === null) return;
    ring.copyTo(list);
    list.end(pathKinds.ring, this.#stroke);
  }
}
