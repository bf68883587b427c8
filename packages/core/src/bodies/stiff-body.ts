import { rod } from '../links/rod.ts';
import { cos, sin } from '../math/trigonometry.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { End } from '../particles/end.ts';
import { aggregate } from './aggregate.ts';
import { type BodyOptions, checkedShares, checkPlacing } from './body-options.ts';
import type { BodyPlan } from './body-plan.ts';
import { braces } from './braces.ts';

/**
 * A body of equal masses at its corners, joined by rods: what box, triangle and polygons are. Each corner starts with the
 * velocity of a rigid body, v + ω × r. Turned by exact sine and cosine, so that every engine builds the same bits.
 * @param corners - Around their mean, which comes to lie at (x, y).
 */
export function stiffBody(
  where: string,
  corners: readonly Readonly<Vec2>[],
  options: BodyOptions,
  kind: string = where,
): BodyPlan {
  const { x, y, angle = 0, angularVelocity = 0, ...shared } = options;
  const { particle, giving, mass } = checkedShares(where, shared);
  checkPlacing(where, options);
  const { vx = 0, vy = 0 } = particle;
  const sine = sin(angle);
  const cosine = cos(angle);
  const particles = corners.map((corner) => {
    const rx = cosine * corner.x - sine * corner.y;
    const ry = sine * corner.x + cosine * corner.y;
    return {
      ...particle,
      x: x + rx,
      y: y + ry,
      vx: vx - angularVelocity * ry,
      vy: vy + angularVelocity * rx,
      mass: mass / corners.length,
    };
  });
  const links = braces(where, corners).map(([a, b]) => ({
    a,
    b,
    join: (p: End, q: End) => rod(p, q, giving),
  }));
  return aggregate({ kind, particles, links, angle });
}
