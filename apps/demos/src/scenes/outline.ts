import { aggregate, type End, type Link, type Particle, type World } from '@mass/core';
import type { Point } from './scene.ts';

/** A line from point to point that holds nothing: only to be seen. */
const line =
  (kind: string) =>
  (a: End, b: End): Link & { kind: string } => ({ kind, a, b, addContacts() {} });

/**
 * Gives a particle a shape to be seen in: points that go where it goes, as a filled outline or, open, as a line: links of
 * the kind `line-<group>`. The physics sees the particle alone, and a pull on a point is a pull on it. The world must have no
 * gravity: the particle's weight is an acceleration of its own.
 * @returns What brings the points along at once, for when the particle was put somewhere.
 */
export function wear(
  world: World,
  wearer: Particle,
  points: readonly Point[],
  group: number,
  closed = true,
): () => void {
  const { x, y, mass } = wearer;
  const body = world.addBody(
    aggregate({
      kind: 'outline',
      particles: points.map((at) => ({ x: x + at.x, y: y + at.y, mass, radius: closed ? 0 : 0.03, group })),
      links: closed ? [] : points.slice(1).map((_, n) => ({ a: n, b: n + 1, join: line(`line-${group}`) })),
      closed,
    }),
  );
  let { vx, vy } = wearer;
  const follow = (): void => {
    ({ vx, vy } = wearer);
    for (const [n, point] of body.particles.entries()) {
      Object.assign(point, { x: wearer.x + points[n].x, y: wearer.y + points[n].y, vx, vy });
    }
  };
  world.addEffect({
    afterStep() {
      for (const point of body.particles) {
        wearer.vx += point.vx - vx;
        wearer.vy += point.vy - vy;
      }
      follow();
    },
  });
  return follow;
}
