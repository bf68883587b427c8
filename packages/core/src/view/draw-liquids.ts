import type { LiquidLevel } from '../forces/buoyancy.ts';
import type { ForceGenerator } from '../forces/force-generator.ts';
import type { Hull } from '../forces/hull-table.ts';
import type { Particle } from '../particles/particle.ts';
import type { Frame } from './frame.ts';
import { type PathList, type PathPaint, pathKinds } from './path-list.ts';
import { PaintRamp } from './ramp.ts';
import type { SceneStyle } from './scene-style.ts';

/** What a liquid tells of itself, for drawing. A game's own generator that has `levelAt` is drawn too. */
export interface ToldLiquid {
  /** Height of the surface at a place. Unit: m. */
  levelAt(x: number): number;
  /** A number where the surface is level, else it is looked at in many places; a function also at any time. */
  readonly level?: number | LiquidLevel;
  /** Unit: kg/m³. */
  readonly density?: number;
  /** Particles that are drawn as the box that displaces the liquid. */
  readonly hulls?: ReadonlyMap<Particle, Readonly<Hull>>;
}

/** The box that a liquid is limited to. Unit: m. */
interface Limits {
  readonly minX?: number;
  readonly minY?: number;
  readonly maxX?: number;
  readonly maxY?: number;
}

const nowhere: Limits = {};
/** From one place at which a moving surface is looked at to the next. Unit: CSS px. */
const stride = 4;

/** Draws liquids: a translucent body with a line along its surface. */
export class LiquidArt {
  readonly #fills: PaintRamp<'density'> | null;
  readonly #surfaces: PaintRamp<'density'> | null;
  readonly #noted: unknown[] = [];

  constructor({ liquids }: SceneStyle) {
    const { fill = '', colorBy = null, alpha = 0, surfaceWidth = 0 } = liquids ?? {};
    this.#fills = liquids && new PaintRamp(fill, colorBy, alpha, [0]);
    this.#surfaces = liquids && surfaceWidth > 0 ? new PaintRamp(fill, colorBy, 1, [surfaceWidth]) : null;
  }

  /** Takes note of what the liquids are, and tells whether some looks another way than when this was last called. */
  note(forces: readonly ForceGenerator[], time: number): boolean {
    if (this.#fills === null) return false;
    const noted = this.#noted;
    let changed = false;
    let at = 0;
    for (let f = 0; f < forces.length; f++) {
      const liquid = liquidIn(forces[f]);
      if (liquid === undefined) continue;
      // A level that is not a number may be another one at another time.
      const level = typeof liquid.level === 'number' ? liquid.level : time;
      changed = noted[at] !== liquid || noted[at + 1] !== level || noted[at + 2] !== liquid.density || changed;
      noted[at] = liquid;
      noted[at + 1] = level;
      noted[at + 2] = liquid.density;
      at += 3;
    }
    changed ||= noted.length !== at;
    noted.length = at;
    return changed;
  }

  /** Adds the liquids among the force generators. */
  draw(forces: readonly ForceGenerator[], list: PathList, frame: Frame): void {
    if (this.#fills === null) return;
    for (let f = 0; f < forces.length; f++) {
      const liquid = liquidIn(forces[f]);
      if (liquid === undefined) continue;
      const density = liquid.density ?? 1000;
      this.#add(liquid, limitsOf(forces[f]), this.#fills.at(density), this.#surfaces?.at(density), list, frame);
    }
  }

  #add(
    liquid: ToldLiquid,
    { minX = -Infinity, maxX = Infinity, minY = -Infinity, maxY = Infinity }: Limits,
    fill: PathPaint,
    surface: PathPaint | undefined,
    list: PathList,
    frame: Frame,
  ): void {
    const { left, top, scale, width, height } = frame;
    const from = Math.max(-8, left + minX * scale);
    const to = Math.min(width + 8, left + maxX * scale);
    const bottom = Math.min(height + 8, top - minY * scale);
    const lid = top - maxY * scale;
    if (!(from < to)) return;
    const steps = typeof liquid.level === 'number' ? 1 : Math.ceil((to - from) / stride);
    const { level } = liquid;
    const yAt = (screenX: number): number => {
      const x = (screenX - left) / scale;
      const y = typeof level === 'function' ? level(x, frame.time) : liquid.levelAt(x);
      return Math.max(lid, top - y * scale);
    };
    for (let k = 0; k <= steps; k++) {
      const x = from + ((to - from) * k) / steps;
      list.add(x, Math.min(bottom, yAt(x)));
      list.add(x, bottom);
    }
    list.end(pathKinds.strip, fill);
    if (surface === undefined) return;
    for (let k = 0; k <= steps; k++) {
      const x = from + ((to - from) * k) / steps;
      list.add(x, Math.min(bottom, yAt(x)));
    }
    list.end(pathKinds.line, surface);
  }
}

/** The liquid of a force generator, if it is one, limited or not. */
export function liquidIn(generator: ForceGenerator): ToldLiquid | undefined {
  let inner: ForceGenerator = generator;
  while ('generator' in inner) inner = inner.generator as ForceGenerator;
  return 'levelAt' in inner ? (inner as ForceGenerator & ToldLiquid) : undefined;
}

function limitsOf(generator: ForceGenerator): Limits {
  let inner: ForceGenerator = generator;
  while ('generator' in inner) {
    if ('region' in inner) return inner.region as Limits;
    inner = inner.generator as ForceGenerator;
  }
  return nowhere;
}
