import type { Link } from '../links/link.ts';
import type { End } from '../particles/end.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ParticleOptions } from '../particles/particle-options.ts';

/** What a body is made of: see `aggregate`. */
export interface BodyParts {
  /** What it is, for drawing: 'box', 'chain', or a game's own word. */
  readonly kind: string;
  /** The particles as they start, at least one; their places are the shape that `angle` is measured against. */
  readonly particles: readonly ParticleOptions[];
  /** What joins them. */
  readonly links: readonly LinkPlan[];
  /** Whether the particles, in order, are a ring to be filled, or a line. @default true */
  readonly closed?: boolean;
  /** Orientation of the shape as it stands. Unit: rad. @default 0 */
  readonly angle?: number;
}

/** A link of a body before it is in a world. */
export interface LinkPlan {
  /** The place of a particle in the list of parts, a particle that is in the world already, or a fixed point `{ x, y }`. */
  readonly a: number | End;
  readonly b: number | End;
  /** Makes the link, such as `rod`. */
  readonly join: (a: End, b: End) => Link;
}

/** What building needs of a world. */
export interface BodySite {
  readonly particles: ParticleArrays;
  readonly links: readonly Link[];
  addParticle(options: ParticleOptions): Particle;
  removeParticle(particle: Particle): void;
  addLink(link: Link): Link;
}
