import { aggregate, type Body, type Effect, type End, type Link, type Particle, type World } from '@mass/core';
import type { Point } from './scene.ts';

/** A line from point to point that holds nothing: only to be seen. */
const line =
  (kind: string) =>
  (a: End, b: End): Link & { kind: string } => ({ kind, a, b, addContacts() {} });

/**
 * Gives a particle a shape to be seen in: points that go where it goes, as a filled outline or, open, as a line: links of
 * the kind `line-<group>`. The physics sees the particle alone.
 */
export function wear(world: World, wearer: Particle, points: readonly Point[], group: number, closed = true): Body {
  const { x, y } = wearer;
  const particles = points.map((point) => ({
    x: x + point.x,
    y: y + point.y,
    mass: Infinity,
    radius: closed ? 0 : 0.03,
    group,
  }));
  const links = closed ? [] : points.slice(1).map((_, n) => ({ a: n, b: n + 1, join: line(`line-${group}`) }));
  const body = world.addBody(aggregate({ kind: 'outline', particles, links, closed }));
  const follow: Effect = {
    afterStep() {
      for (const [n, point] of body.particles.entries()) {
        point.x = wearer.x + points[n].x;
        point.y = wearer.y + points[n].y;
      }
    },
  };
  world.addEffect(follow);
  return body;
}
