import { requireFinite, requireFunction, requireOptions } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';
import type { World } from '../world/world.ts';

/** Which particle is looked for. */
export interface NearestOptions {
  /** How far off the edge of its disc may be, 0 or more. Unit: m. @default Infinity */
  maxDistance?: number;
  /** Whether a particle counts. @default all do */
  filter?: (particle: Particle) => boolean;
}

/**
 * The particle the edge of whose disc is nearest to a point, or undefined where there is none. Inside a disc the distance is
 * negative, so that of two that cover the point the one with the farther edge wins; of equally near ones the lower slot.
 * Unit: m.
 */
export function nearestParticle(
  world: World,
  x: number,
  y: number,
  options: NearestOptions = {},
): Particle | undefined {
  requireOptions('nearestParticle', 'options', options, '{ maxDistance: 1 }');
  const { maxDistance = Infinity, filter = () => true } = options;
  requireFinite('nearestParticle', 'x', x, 'metres');
  requireFinite('nearestParticle', 'y', y, 'metres');
  if (!(maxDistance >= 0)) {
    throw new RangeError(`nearestParticle: maxDistance must be a number of metres, 0 or more; got ${maxDistance}.`);
  }
  requireFunction('nearestParticle', 'filter', filter, 'of a particle');
  const particles = world.particles;
  let least = maxDistance;
  let found: Particle | undefined;
  for (let i = 0; i < particles.count; i++) {
    if (particles.alive[i] !== 1) continue;
    const dx = particles.x[i] - x;
    const dy = particles.y[i] - y;
    const distance = Math.sqrt(dx * dx + dy * dy) - particles.radius[i];
    if (found === undefined ? distance > least : distance >= least) continue;
    const particle = world.particleAt(i);
    if (!filter(particle)) continue;
    least = distance;
    found = particle;
  }
  return found;
}
