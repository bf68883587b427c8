import type { Buoyancy, Particle, World } from '@mass/core';
import type { Palette } from './palette.ts';
import type { Guide } from './scene.ts';

/** The colour of what floats. */
export function wood({ dark }: Palette): string {
  return dark ? '#e0b264' : '#d9a24b';
}

/** A float: an upright box, 1 m thick, for which buoyancy is exact. Units: kg, m. */
export interface Float {
  readonly mass: number;
  readonly width: number;
  readonly height: number;
}

/** Adds a float; what falls to the ground lands on the box's lower edge. */
export function addFloat(
  world: World,
  liquids: readonly Buoyancy[],
  { mass, width, height }: Float,
  place: { readonly x: number; readonly y: number; readonly group?: number; readonly damping?: number },
): Particle {
  const particle = world.addParticle({ ...place, mass, radius: height / 2 });
  for (const liquid of liquids) liquid.setHull(particle, { volume: width * height, maxDepth: height / 2 });
  return particle;
}

/** How deep a float draws at rest, m / (ρ·A); more than its height where it sinks. Units: kg/m³, m. */
export function draught({ mass, width }: Float, density: number): number {
  return mass / (density * width);
}

/** Height of a float's centre at rest in a liquid whose surface is at 0, above ground that is so deep. Unit: m. */
export function restingHeight(float: Float, density: number, depth: number): number {
  const deep = draught(float, density);
  return deep < float.height ? float.height / 2 - deep : float.height / 2 - depth;
}

/** The outline of a box around a place, dotted: where something belongs. */
export function outline(x: number, y: number, { width, height }: Pick<Float, 'width' | 'height'>): Guide {
  const [left, right, low, high] = [x - width / 2, x + width / 2, y - height / 2, y + height / 2];
  const points = [left, low, right, low, right, high, left, high, left, low];
  return { kind: 'curve', points, dashed: true, tone: 'ink' };
}

/** Tells when nothing has moved for a while: then a scene may begin again without taking anything out of a hand. */
export class Stillness {
  readonly #seconds: number;
  #lasted = 0;

  constructor(seconds: number) {
    this.#seconds = seconds;
  }

  /** Looks at a world before a step. Returns whether it has been still for long enough, and then starts counting anew. */
  has(world: World, dt: number): boolean {
    const { count, alive, vx, vy } = world.particles;
    let fastest = 0;
    for (let i = 0; i < count; i++) if (alive[i] === 1) fastest = Math.max(fastest, Math.abs(vx[i]), Math.abs(vy[i]));
    this.#lasted = fastest < 0.01 ? this.#lasted + dt : 0;
    if (this.#lasted < this.#seconds) return false;
    this.#lasted = 0;
    return true;
  }
}
