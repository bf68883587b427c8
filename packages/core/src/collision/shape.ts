import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ContactKeeper } from '../contacts/contact-keeper.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { SurfaceOptions } from './surface-options.ts';
import type { SurfaceReport } from './surface-report.ts';
import type { Sweep } from './sweep.ts';

/**
 * Immovable scenery that particles collide with. A game's own is made the same way. It stays where it is and as it is while it is in a
 * world: to move one, take it out and add another.
 */
export interface Shape extends SurfaceOptions {
  readonly restitution: number;
  readonly friction?: number;
  readonly surfaceSpeed?: number;
  readonly sensor?: boolean;
  readonly category?: number;
  readonly mask?: number;
  readonly filter?: ((slot: number) => boolean) | undefined;
  /** Whether it is solid from the front of its normals alone: it then reports nothing to a point behind. @default false */
  readonly oneSided?: boolean;
  /** Of a wall that is solid from both sides. Unit: m. */
  readonly thickness?: number;
  /** The box around the shape, infinite where it has no end: particles farther off are not asked about. Unit: m. */
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
  /** `shapeFinder`: makes what finds the contacts of all shapes of a world, or adds to it what this one needs. */
  readonly finder: (known?: ShapeFinder) => ShapeFinder;
  /**
   * Reports each place of the surface that is nearer than `reach` to a point, or that the point lies behind.
   * @param x - The point. Unit: m.
   * @param y - The point. Unit: m.
   * @param reach - How near a place must be to be reported. Unit: m.
   */
  findSurface(x: number, y: number, reach: number, surface: SurfaceReport): void;
  /**
   * Tells a disc on its way of the flats and the corners that it may meet. A shape without this is walked up to by the distances that it
   * reports: then a part of it that is thinner than half the disc's radius, and only grazed, may be missed.
   */
  sweep?(sweep: Sweep): void;
}

/** Finds the contacts of particles with all the static shapes of a world. */
export interface ShapeFinder {
  /** Makes what keeps the contacts that are found. */
  readonly keeper: () => ContactKeeper;
  /** For shapes without `sweep`: comes with the first of a game's own. */
  walk: ShapeWalk | undefined;
  /**
   * Adds the contacts of this moment, and what sensors find. Writes nothing of the particles.
   * @param firstSource - Number of the first shape among the sources of contacts.
   * @param sensorsAlone - Leaves the contacts out.
   */
  find(
    shapes: readonly Shape[],
    firstSource: number,
    particles: ParticleArrays,
    contacts: ContactBuffer,
    dt: number,
    sensorsAlone?: boolean,
  ): void;
  /** Puts back in front of a surface whose centre has gone through it since the step began. Writes x, y, vx, vy. */
  keepInFront(shapes: readonly Shape[], particles: ParticleArrays, before: Places): void;
}

/** Brings a disc on its way up to a shape that has no `sweep`. */
export interface ShapeWalk {
  /**
   * Tells the sweep where it meets the shape.
   * @param least - Least step: one that grazes a surface would come near in ever shorter ones. Unit: m.
   */
  meet(shape: Shape, sweep: Sweep, least: number): void;
}

/** Where particles were, by slot. Unit: m. */
export interface Places {
  readonly x: Float64Array;
  readonly y: Float64Array;
}
