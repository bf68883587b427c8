import { requireFinite, requireNonNegative } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';
import { liquidIn } from './draw-liquids.ts';
import type { ViewedWorld } from './viewed-world.ts';

/**
 * The particle nearest to a point of the world, for pointers: at most `radius` away from its disc, the least gap first and
 * then the nearest centre. Where no disc is so near, that of the box that floats there, or the nearest of the body that the
 * point is in: what is drawn there can be taken hold of. `undefined` when there is none. Unit: m; divide pixels by the
 * camera's `pixelsPerMetre`.
 */
export function pickParticle(world: ViewedWorld, x: number, y: number, radius: number): Particle | undefined {
  requireFinite('pickParticle', 'x', x, 'metres');
  requireFinite('pickParticle', 'y', y, 'metres');
  requireNonNegative('pickParticle', 'radius', radius, 'metres');
  const { count, alive, x: px, y: py, radius: discs } = world.particles;
  let best = -1;
  let bestGap = radius;
  let bestDistance = Infinity;
  for (let i = 0; i < count; i++) {
    if (alive[i] === 0) continue;
    const dx = px[i] - x;
    const dy = py[i] - y;
    const distance = Math.sqrt(dx * dx + dy * dy);
    const gap = Math.max(0, distance - discs[i]);
    if (gap < bestGap || (gap === bestGap && distance < bestDistance)) {
      best = i;
      bestGap = gap;
      bestDistance = distance;
    }
  }
  return best < 0 ? (pickHull(world, x, y) ?? pickBody(world, x, y)) : world.particleAt(best);
}

function pickHull({ forces, particles }: ViewedWorld, x: number, y: number): Particle | undefined {
  let picked: Particle | undefined;
  for (const generator of forces) {
    for (const [particle, { volume, maxDepth }] of liquidIn(generator)?.hulls ?? []) {
      if (!particle.isIn(particles)) continue;
      const inside = Math.abs(x - particle.x) <= volume / (4 * maxDepth) && Math.abs(y - particle.y) <= maxDepth;
      if (inside) picked = particle; // the one on top
    }
  }
  return picked;
}

function pickBody({ bodies }: ViewedWorld, x: number, y: number): Particle | undefined {
  for (const { closed, whole, particles } of [...bodies].reverse()) {
    if (!closed || !whole || !contains(particles, x, y)) continue;
    const distance = (particle: Particle): number => (particle.x - x) ** 2 + (particle.y - y) ** 2;
    return particles.reduce((best, each) => (distance(each) < distance(best) ? each : best));
  }
  return undefined;
}

/** By the number of sides that a ray to the right crosses. */
function contains(corners: readonly Particle[], x: number, y: number): boolean {
  let inside = false;
  for (let i = 0, j = corners.length - 1; i < corners.length; j = i++) {
    const a = corners[j];
    const b = corners[i];
    if (a.y > y === b.y > y) continue;
    if (x < a.x + ((b.x - a.x) * (y - a.y)) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}
