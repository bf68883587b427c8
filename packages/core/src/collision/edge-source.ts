import type { Link } from '../links/link.ts';
import type { Particle } from '../particles/particle.ts';

/** Something with edges: a body. */
export interface Outline {
  /** Whether the particles, in order, are a ring; else its links are its edges. */
  readonly closed: boolean;
  readonly particles: readonly Particle[];
  /** @internal */
  linksAmong(left: ReadonlySet<Link>): readonly Link[];
}

/** Where edges come from: a world. */
export interface EdgeSource {
  readonly bodies: readonly Outline[];
  readonly links: readonly Link[];
}
