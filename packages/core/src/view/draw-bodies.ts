import type { Body, Pose } from '../bodies/body.ts';
import type { Frame } from './frame.ts';
import { addRounded } from './geometry.ts';
import type { Palette } from './palette.ts';
import { type PathList, type PathPaint, pathKinds } from './path-list.ts';
import { pathPaint } from './ramp.ts';
import type { SceneStyle } from './scene-style.ts';
import type { BodyStyle } from './scenery-style.ts';
import type { ViewedWorld } from './viewed-world.ts';

interface BodyPaints {
  readonly fill: PathPaint;
  readonly stroke: PathPaint;
}

/** How far the mark of the orientation reaches, as a share of the way from the centre to the corners. */
const markReach = 0.6;

/** Draws aggregates as filled outlines, in place of the discs and links that they are made of. */
export class BodyArt {
  readonly #style: BodyStyle | null;
  readonly #palette: Palette;
  readonly #paints = new Map<string, BodyPaints>();
  readonly #pose: Pose = { x: 0, y: 0, angle: 0 };
  #points: Float64Array = new Float64Array(16);
  #radii: Float64Array = new Float64Array(8);

  constructor({ bodies }: SceneStyle, palette: Palette) {
    this.#style = bodies;
    this.#palette = palette;
  }

  /** Marks the slots of the bodies that are drawn in place of their discs and links: by their outline, or by the game. */
  hide({ bodies }: ViewedWorld, bound: Uint8Array, bodyOf: Uint32Array): void {
    const outlined = this.#style !== null && !this.#style.skeleton;
    for (let b = 0; b < bodies.length; b++) {
      const { particles } = bodies[b];
      if (bound[particles[0].slot] !== 1 && !(outlined && isOutlined(bodies[b]))) continue;
      for (const particle of particles) bodyOf[particle.slot] = b + 1;
    }
  }

  /** Adds the outline of each body that is a whole ring, but for those that are `bound`. */
  draw(world: ViewedWorld, bound: Uint8Array, list: PathList, frame: Frame): void {
    if (this.#style === null) return;
    for (const body of world.bodies) {
      if (isOutlined(body) && bound[body.particles[0].slot] !== 1) this.#add(body, this.#style, world, list, frame);
    }
  }

  #add(body: Body, style: BodyStyle, world: ViewedWorld, list: PathList, frame: Frame): void {
    const { particles } = body;
    const count = particles.length;
    this.#reserve(count);
    const points = this.#points;
    const radii = this.#radii;
    for (let i = 0; i < count; i++) {
      const { slot } = particles[i];
      points[2 * i] = frame.x[slot];
      points[2 * i + 1] = frame.y[slot];
      radii[i] = world.particles.radius[slot] * frame.scale;
    }
    const { fill, stroke } = this.#paintsOf(style, body.group);
    if (fill.alpha > 0) {
      addRounded(list, points, count, radii);
      list.end(pathKinds.fill, fill);
    }
    if (stroke.width === 0) return;
    for (let i = 0; i < count; i++) radii[i] = Math.max(0, radii[i] - stroke.width / 2);
    addRounded(list, points, count, radii);
    list.end(pathKinds.ring, stroke);
    if (style.mark) this.#addMark(body, count, stroke, list, frame);
  }

  #addMark(body: Body, count: number, paint: PathPaint, list: PathList, frame: Frame): void {
    const pose = body.pose(frame.alpha, this.#pose);
    const x = frame.left + pose.x * frame.scale;
    const y = frame.top - pose.y * frame.scale;
    let reach = 0;
    for (let i = 0; i < count; i++) {
      const dx = this.#points[2 * i] - x;
      const dy = this.#points[2 * i + 1] - y;
      reach += (markReach * Math.sqrt(dx * dx + dy * dy)) / count;
    }
    list.line(x, y, x + reach * Math.cos(pose.angle), y - reach * Math.sin(pose.angle), paint);
  }

  #paintsOf(style: BodyStyle, group: number): BodyPaints {
    const color = style.fill ?? this.#palette.fillOf(group);
    let paints = this.#paints.get(color);
    if (paints === undefined) {
      paints = {
        fill: pathPaint(color, style.fillAlpha, 0),
        stroke: pathPaint(style.stroke ?? color, 1, style.strokeWidth),
      };
      this.#paints.set(color, paints);
    }
    return paints;
  }

  #reserve(count: number): void {
    if (this.#radii.length >= count) return;
    this.#points = new Float64Array(count * 4);
    this.#radii = new Float64Array(count * 2);
  }
}

/** Whether a body is drawn by its outline: what lost a particle is drawn as what is left of it. */
function isOutlined(body: Body): boolean {
  return body.closed && body.whole && body.particles.length > 2;
}
