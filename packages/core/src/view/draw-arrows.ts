import type { Pose } from '../bodies/body.ts';
import { addArrow } from './arrow.ts';
import type { Frame } from './frame.ts';
import { addCircle } from './geometry.ts';
import { type PathList, type PathPaint, pathKinds } from './path-list.ts';
import { pathPaint } from './ramp.ts';
import type { SceneStyle } from './scene-style.ts';
import type { ArrowStyle } from './scenery-style.ts';
import type { ViewedWorld } from './viewed-world.ts';
import { generatorWithin } from './within.ts';

interface ArrowPaints {
  readonly shaft: PathPaint;
  readonly head: PathPaint;
}

/** Draws what is asked for by hand: velocities, forces, contacts. */
export class ArrowArt {
  readonly #style: SceneStyle;
  readonly #velocity: ArrowPaints | null;
  readonly #force: ArrowPaints | null;
  readonly #contact: ArrowPaints | null;
  readonly #pose: Pose = { x: 0, y: 0, angle: 0 };

  constructor(style: SceneStyle) {
    this.#style = style;
    this.#velocity = style.velocities && arrowPaints(style.velocities);
    this.#force = style.forces && arrowPaints(style.forces);
    this.#contact = style.contacts && arrowPaints(style.contacts);
  }

  draw(world: ViewedWorld, list: PathList, frame: Frame): void {
    const { velocities, forces, contacts } = this.#style;
    const { vx, vy } = world.particles;
    if (contacts && this.#contact) this.#addContacts(world, this.#contact, list, frame);
    if (velocities && this.#velocity) {
      addArrows(vx, vy, velocities, this.#velocity, world, list, frame);
      this.#addBodies(vx, vy, true, velocities, this.#velocity, world, list, frame);
    }
    if (!forces || !this.#force) return;
    for (const each of world.forces) {
      const probe = generatorWithin(each);
      if (!isProbe(probe)) continue;
      addArrows(probe.fx, probe.fy, forces, this.#force, world, list, frame);
      this.#addBodies(probe.fx, probe.fy, false, forces, this.#force, world, list, frame);
    }
  }

  /** One arrow for each body that is drawn by its outline, from its centre: the mean by mass, or the sum. */
  #addBodies(
    valueX: Float64Array,
    valueY: Float64Array,
    mean: boolean,
    { scale, longest }: ArrowStyle,
    { shaft, head }: ArrowPaints,
    { bodies, particles: { mass } }: ViewedWorld,
    list: PathList,
    frame: Frame,
  ): void {
    for (let b = 0; b < bodies.length; b++) {
      const { particles } = bodies[b];
      if (frame.bodyOf[particles[0].slot] !== b + 1) continue;
      let sumX = 0;
      let sumY = 0;
      let weights = 0;
      for (const { slot } of particles) {
        if (mass[slot] === Infinity || slot >= valueX.length) continue;
        const weight = mean ? mass[slot] : 1;
        sumX += weight * valueX[slot];
        sumY += weight * valueY[slot];
        weights += weight;
      }
      if (weights === 0) continue;
      const factor = (scale * frame.scale) / (mean ? weights : 1);
      const { x, y } = bodies[b].pose(frame.alpha, this.#pose);
      const fromX = frame.left + x * frame.scale;
      const fromY = frame.top - y * frame.scale;
      addArrow(list, fromX, fromY, sumX * factor, -sumY * factor, longest, shaft, head);
    }
  }

  /** At each contact that is none of a link's: a point, the normal, and how hard it was pushed along it. */
  #addContacts(world: ViewedWorld, { shaft, head }: ArrowPaints, list: PathList, frame: Frame): void {
    const style = this.#style.contacts;
    if (style === null) return;
    const { count, a, source, normalX, normalY, impulse } = world.contacts;
    const { alive, radius } = world.particles;
    const links = world.links.length;
    for (let c = 0; c < count; c++) {
      const i = a[c];
      if (source[c] < links || alive[i] === 0) continue;
      const nx = normalX[c];
      const ny = -normalY[c];
      const x = frame.x[i] - nx * radius[i] * frame.scale;
      const y = frame.y[i] - ny * radius[i] * frame.scale;
      if (frame.misses(x, y, x, y, style.longest)) continue;
      const pushed = impulse[c] * style.scale * frame.scale;
      if (style.normal > 0 && pushed < style.normal) {
        list.line(x, y, x + nx * style.normal, y + ny * style.normal, shaft);
      }
      addArrow(list, x, y, nx * pushed, ny * pushed, style.longest, shaft, head);
      addCircle(list, x, y, 1.75 * style.width);
      list.end(pathKinds.fill, head);
    }
  }
}

/** One arrow for each particle, from its centre, but for those in whose place a body is drawn. */
function addArrows(
  valueX: Float64Array,
  valueY: Float64Array,
  { scale, longest }: ArrowStyle,
  { shaft, head }: ArrowPaints,
  { particles: { count, alive, mass } }: ViewedWorld,
  list: PathList,
  frame: Frame,
): void {
  const factor = scale * frame.scale;
  const { x, y } = frame;
  for (let i = 0; i < Math.min(count, valueX.length); i++) {
    if (alive[i] === 0 || mass[i] === Infinity || frame.bodyOf[i] > 0) continue;
    if (frame.misses(x[i], y[i], x[i], y[i], longest)) continue;
    addArrow(list, x[i], y[i], valueX[i] * factor, -valueY[i] * factor, longest, shaft, head);
  }
}

function arrowPaints({ color, width, alpha }: Pick<ArrowStyle, 'color' | 'width' | 'alpha'>): ArrowPaints {
  return { shaft: pathPaint(color, alpha, width), head: pathPaint(color, alpha, 0) };
}

function isProbe(generator: object): generator is { readonly fx: Float64Array; readonly fy: Float64Array } {
  return 'fx' in generator && 'fy' in generator && generator.fx instanceof Float64Array;
}
