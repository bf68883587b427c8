import type { Camera } from './camera.ts';
import { completeStyle } from './complete-style.ts';
import { ArrowArt } from './draw-arrows.ts';
import { BodyArt } from './draw-bodies.ts';
import { HullArt } from './draw-hulls.ts';
import { LinkArt } from './draw-links.ts';
import { LiquidArt } from './draw-liquids.ts';
import type { DrawList } from './draw-list.ts';
import { ShapeArt } from './draw-shapes.ts';
import { SpringArt } from './draw-springs.ts';
import { Frame } from './frame.ts';
import type { Palette } from './palette.ts';
import { PathList } from './path-list.ts';
import { PinMarks } from './pin-marks.ts';
import type { Style } from './style.ts';
import type { ViewedWorld } from './viewed-world.ts';

/**
 * All of a world that is neither disc nor trail, as lines and polygons on the screen: three layers, two under the discs and
 * one above. Made anew for each style, filled anew each frame. For authors of renderers.
 */
export class Sketch {
  /** Liquids and static shapes. It is filled anew only when it looks another way: compare its `version`. */
  readonly ground: PathList = new PathList();
  /** Bodies, links, springs, pins. */
  readonly below: PathList = new PathList();
  /** Contacts, velocities, forces. */
  readonly above: PathList = new PathList();
  readonly #frame = new Frame();
  readonly #liquids: LiquidArt;
  readonly #shapes: ShapeArt;
  readonly #bodies: BodyArt;
  readonly #hulls: HullArt;
  readonly #springs: SpringArt;
  readonly #links: LinkArt;
  readonly #pins: PinMarks;
  readonly #arrows: ArrowArt;
  readonly #drawnShapes: unknown[] = [];
  readonly #drawnView = new Float64Array(5);
  #hidden: Uint8Array = new Uint8Array(0);
  #bound: Uint8Array = new Uint8Array(0);
  #boundBodies: Uint8Array = new Uint8Array(0);
  #seenWorld: ViewedWorld | null = null;
  #seenTime = 0;
  #seenSteps = 0;
  #dt = 0;

  /** The palette is the one of the same style. */
  constructor(style: Style, palette: Palette) {
    const complete = completeStyle(style);
    this.#liquids = new LiquidArt(complete);
    this.#shapes = new ShapeArt(complete);
    this.#bodies = new BodyArt(complete, palette);
    this.#hulls = new HullArt(complete, palette);
    this.#springs = new SpringArt(complete);
    this.#links = new LinkArt(complete);
    this.#pins = new PinMarks(complete);
    this.#arrows = new ArrowArt(complete);
  }

  /**
   * 1 for each slot whose disc is not drawn: it is `bound`, or an outline takes its place. `boundBodies` is 1 for those of
   * bodies in whose place the game draws. Comes before the discs.
   */
  hide(world: ViewedWorld, bound: Uint8Array, boundBodies: Uint8Array): Uint8Array {
    const { count, alive } = world.particles;
    const frame = this.#frame;
    if (this.#hidden.length < count) {
      this.#hidden = new Uint8Array(alive.length);
      frame.bodyOf = new Uint32Array(alive.length);
    }
    frame.bodyOf.fill(0);
    this.#bound = bound;
    this.#boundBodies = boundBodies;
    this.#bodies.hide(world, boundBodies, frame.bodyOf);
    const hidden = this.#hidden;
    for (let i = 0; i < count; i++) hidden[i] = bound[i] === 1 || frame.bodyOf[i] > 0 ? 1 : 0;
    this.#hulls.hide(world.forces, hidden);
    return hidden;
  }

  /** Draws the layers anew. Comes after the discs, whose places it uses. */
  update(world: ViewedWorld, discs: DrawList, camera: Camera, alpha: number): void {
    const frame = this.#frame;
    frame.set(world, discs, camera, alpha);
    frame.time = this.#timeOf(world, alpha);
    this.#updateGround(world, camera);
    const { below, above } = this;
    below.clear();
    above.clear();
    this.#pins.begin(world.particles);
    this.#hulls.draw(world, this.#bound, below, frame);
    this.#bodies.draw(world, this.#boundBodies, below, frame);
    this.#links.draw(world.links, below, frame, this.#pins);
    this.#springs.draw(world.forces, below, frame, this.#pins);
    this.#pins.draw(below, frame);
    this.#arrows.draw(world, above, frame);
  }

  #updateGround({ forces, shapes }: ViewedWorld, camera: Camera): void {
    const moved = this.#noteView(camera);
    const changed = this.#noteShapes(shapes);
    const flowed = this.#liquids.note(forces, this.#frame.time);
    if (!moved && !changed && !flowed && this.ground.version > 0) return;
    this.ground.clear();
    this.#liquids.draw(forces, this.ground, this.#frame);
    this.#shapes.draw(shapes, this.ground, this.#frame);
  }

  /** The time between the last two steps that is drawn: a step is as long as those since the last frame were. */
  #timeOf(world: ViewedWorld, alpha: number): number {
    const { time, stepCount } = world;
    const steps = stepCount - this.#seenSteps;
    if (world !== this.#seenWorld) this.#dt = 0;
    else if (steps > 0) this.#dt = (time - this.#seenTime) / steps;
    this.#seenWorld = world;
    this.#seenSteps = stepCount;
    this.#seenTime = time;
    return time - (1 - alpha) * this.#dt;
  }

  #noteView({ x, y, pixelsPerMetre, width, height }: Camera): boolean {
    const view = this.#drawnView;
    const same =
      view[0] === x && view[1] === y && view[2] === pixelsPerMetre && view[3] === width && view[4] === height;
    view[0] = x;
    view[1] = y;
    view[2] = pixelsPerMetre;
    view[3] = width;
    view[4] = height;
    return !same;
  }

  /** A game's own shape may move: what tells an outline is drawn each time. */
  #noteShapes(shapes: ViewedWorld['shapes']): boolean {
    const drawn = this.#drawnShapes;
    let changed = drawn.length !== shapes.length;
    drawn.length = shapes.length;
    for (let s = 0; s < shapes.length; s++) {
      if (drawn[s] !== shapes[s] || 'outline' in shapes[s]) changed = true;
      drawn[s] = shapes[s];
    }
    return changed;
  }
}
