import { requireFinite, requireNonNegative } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';
import type { ViewedWorld } from './viewed-world.ts';

/**
 * The particle nearest to a point of the world, for pointers: at most `radius` away from its disc, the least gap first and
 * then the nearest centre. `undefined` when there is none. Unit: m; divide pixels by the camera's `pixelsPerMetre`.
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
  return best < 0 ? undefined : world.particleAt(best);
}
