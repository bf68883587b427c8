import type { ForceGenerator } from '../forces/force-generator.ts';
import { liquidIn } from './draw-liquids.ts';
import type { Frame } from './frame.ts';
import type { Palette } from './palette.ts';
import { type PathList, type PathPaint, pathKinds } from './path-list.ts';
import { pathPaint } from './ramp.ts';
import type { SceneStyle } from './scene-style.ts';
import type { ViewedWorld } from './viewed-world.ts';

/** Draws particles that have a hull in a liquid as the upright box for which its buoyancy is exact. */
export class HullArt {
  readonly #shown: boolean;
  readonly #palette: Palette;
  readonly #paints = new Map<string, PathPaint>();

  constructor({ liquids }: SceneStyle, palette: Palette) {
    this.#shown = liquids?.hulls === true;
    this.#palette = palette;
  }

  /** Marks the slots of those particles. */
  hide(forces: readonly ForceGenerator[], hidden: Uint8Array): void {
    if (!this.#shown) return;
    for (let f = 0; f < forces.length; f++) {
      const hulls = liquidIn(forces[f])?.hulls;
      if (hulls) for (const particle of hulls.keys()) if (particle.alive) hidden[particle.slot] = 1;
    }
  }

  /** Adds the boxes. */
  draw({ forces, particles }: ViewedWorld, bound: Uint8Array, list: PathList, frame: Frame): void {
    if (!this.#shown) return;
    for (let f = 0; f < forces.length; f++) {
      const hulls = liquidIn(forces[f])?.hulls;
      if (hulls === undefined) continue;
      for (const [particle, { volume, maxDepth }] of hulls) {
        if (!particle.isIn(particles) || bound[particle.slot] === 1) continue;
        const halfWidth = (volume / (4 * maxDepth)) * frame.scale;
        const halfHeight = maxDepth * frame.scale;
        const x = frame.x[particle.slot];
        const y = frame.y[particle.slot];
        list.add(x - halfWidth, y - halfHeight);
        list.add(x + halfWidth, y - halfHeight);
        list.add(x + halfWidth, y + halfHeight);
        list.add(x - halfWidth, y + halfHeight);
        list.end(pathKinds.fill, this.#paintOf(particle.group));
      }
    }
  }

  #paintOf(group: number): PathPaint {
    const color = this.#palette.fillOf(group);
    let paint = this.#paints.get(color);
    if (paint === undefined) {
      paint = pathPaint(color, 1, 0);
      this.#paints.set(color, paint);
    }
    return paint;
  }
}
