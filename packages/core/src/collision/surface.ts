import type { ShapeFinder } from './shape.ts';
import { surfaceFinder } from './surface-finder.ts';
import { checkSurface, type SurfaceOptions } from './surface-options.ts';

export type { SurfaceOptions } from './surface-options.ts';

/** The part that all static shapes share. */
export abstract class Surface {
  readonly restitution: number;
  readonly friction: number;
  /** How fast the surface moves along the tangent (normalY, -normalX). Unit: m/s. */
  readonly surfaceSpeed: number;
  readonly sensor: boolean;
  readonly category: number;
  readonly mask: number;
  readonly filter: ((slot: number) => boolean) | undefined;
  readonly finder: (known?: ShapeFinder) => ShapeFinder = surfaceFinder;

  constructor(where: string, options: SurfaceOptions) {
    checkSurface(where, options);
    this.restitution = options.restitution ?? 0;
    this.friction = options.friction ?? 0;
    this.surfaceSpeed = options.surfaceSpeed ?? 0;
    this.sensor = options.sensor ?? false;
    this.category = options.category ?? 1;
    this.mask = options.mask ?? 0xffff;
    this.filter = options.filter;
  }
}
