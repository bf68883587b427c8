import type { BoxBodyOptions, BoxOptions, DiscOptions, ParticleOptions, RegularPolygonOptions, Vec2 } from '@mass/core';

/** A world as plain data, so that it can be printed, and made smaller piece by piece. */
export interface WorldPlan {
  readonly seed: number;
  readonly gravity: Vec2;
  /** Drag of the air, in proportion to the speed. Unit: kg/s. */
  readonly drag: number;
  readonly walls: WallsPlan;
  readonly obstacles: readonly ObstaclePlan[];
  readonly parts: readonly PartPlan[];
  /** Whether things start in each other: then what energy it takes to part them is not known. */
  readonly overlaps: boolean;
  /** A part that is taken out again on the way. */
  readonly removal: { readonly part: number; readonly step: number } | undefined;
}

/** What all surfaces have. */
export interface SurfacePlan {
  readonly restitution: number;
  readonly friction: number;
  /** Unit: m/s. */
  readonly surfaceSpeed: number;
}

/** A convex room, made in one of four ways. */
export interface WallsPlan extends SurfacePlan {
  readonly kind: 'half-planes' | 'segments' | 'polyline' | 'boxes';
  /** Counter-clockwise. Unit: m. */
  readonly corners: readonly Vec2[];
  /** Of segments and polylines. Unit: m. */
  readonly thickness: number;
}

export type ObstaclePlan =
  | ({ readonly kind: 'disc' } & DiscOptions)
  | ({ readonly kind: 'box' } & BoxOptions)
  | ({ readonly kind: 'segment'; readonly a: Vec2; readonly b: Vec2; readonly thickness: number } & SurfacePlan);

/** Things that hang together. */
export type PartPlan = LoosePlan | BodyPlan;

export interface LoosePlan {
  readonly particles: readonly ParticleOptions[];
  readonly links: readonly LinkPlan[];
  readonly springs: readonly SpringPlan[];
  /** Whether its links collide with other things. */
  readonly collides: boolean;
}

/** A body, with an outline that collides. */
export interface BodyPlan {
  readonly body: ({ readonly kind: 'box' } & BoxBodyOptions) | ({ readonly kind: 'polygon' } & RegularPolygonOptions);
}

export interface LinkPlan {
  readonly kind: 'rod' | 'cable';
  /** Which particle of the part. */
  readonly a: number;
  /** Which other, or a fixed point. */
  readonly b: number | Vec2;
  /** Unit: m. */
  readonly length: number;
  /** Unit: m/N. */
  readonly compliance: number;
  readonly damping: number;
  readonly restitution: number;
}

export interface SpringPlan {
  readonly a: number;
  readonly b: number | Vec2;
  /** Unit: N/m. */
  readonly stiffness: number;
  /** Unit: m. */
  readonly restLength: number;
}

/** Whether a part is a body. */
export function isBody(part: PartPlan): part is BodyPlan {
  return 'body' in part;
}
