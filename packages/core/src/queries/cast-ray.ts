import type { Shape } from '../collision/shape.ts';
import { requireFunction, requireOptions, requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { Particle } from '../particles/particle.ts';
import type { World } from '../world/world.ts';
import { discAlongRay } from './disc-along-ray.ts';
import type { Ray } from './ray.ts';
import { shapeAlongRay } from './shape-along-ray.ts';

/** A ray that ends, and what it may hit. */
export interface RayOptions {
  /** Where it starts. Unit: m. */
  from: Readonly<Vec2>;
  /** Where it ends. Unit: m. */
  to: Readonly<Vec2>;
  /** Whether a particle or a static shape can be hit. @default all can */
  filter?: (target: Particle | Shape) => boolean;
}

/** Where a ray meets something. */
export interface RayHit {
  /** The particle or the static shape that is hit. */
  readonly target: Particle | Shape;
  /** Where. Unit: m. */
  readonly x: number;
  readonly y: number;
  /** Unit normal out of what is hit. */
  readonly normalX: number;
  readonly normalY: number;
  /** Share of the way from start to end, 0 to 1. */
  readonly fraction: number;
}

/**
 * All that a ray meets, each particle and shape once, where it enters: the nearest first, of equally near ones particles by
 * slot before shapes in their order. What the ray starts in is not met. Points, radius 0, are never met.
 *
 * A disc is met exactly, and so is a shape that has a `sweep`, as all of ours do; another is found by steps as long as its surface is
 * far (J. C. Hart, *Sphere Tracing*, 1996), to 10⁻⁹ m.
 */
export function castRay(world: World, options: RayOptions): RayHit[] {
  const hits: RayHit[] = [];
  const { ray, filter } = checked(options);
  const { particles, shapes } = world;
  for (let i = 0; i < particles.count; i++) {
    if (particles.alive[i] !== 1 || particles.radius[i] === 0) continue;
    const fraction = discAlongRay(ray, particles.x[i], particles.y[i], particles.radius[i]);
    if (fraction === undefined) continue;
    const target = world.particleAt(i);
    if (!filter(target)) continue;
    const x = ray.x + ray.dx * fraction;
    const y = ray.y + ray.dy * fraction;
    const normalX = (x - particles.x[i]) / particles.radius[i];
    const normalY = (y - particles.y[i]) / particles.radius[i];
    hits.push({ target, x, y, normalX, normalY, fraction });
  }
  for (const target of shapes) {
    if (!filter(target)) continue;
    const met = shapeAlongRay(ray, target);
    if (met !== undefined) hits.push({ target, ...met });
  }
  return hits.sort((a, b) => a.fraction - b.fraction);
}

/** The nearest of all that a ray meets: see `castRay`. */
export function firstHit(world: World, options: RayOptions): RayHit | undefined {
  return castRay(world, options)[0];
}

function checked(options: RayOptions): { ray: Ray; filter: (target: Particle | Shape) => boolean } {
  requireOptions('castRay', 'options', options, '{ from: { x: 0, y: 0 }, to: { x: 1, y: 0 } }');
  const { from, to, filter = () => true } = options;
  requireVector('castRay', 'from', from, 'metres');
  requireVector('castRay', 'to', to, 'metres');
  requireFunction('castRay', 'filter', filter, 'of a particle or a shape');
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const length = Math.sqrt(dx * dx + dy * dy);
  if (!(length > 0 && length < Infinity)) {
    throw new RangeError(
      `castRay: the ends must be apart, and finitely far; got a length of ${length} m. Use particlesAt to ask of one point.`,
    );
  }
  return { ray: { x: from.x, y: from.y, dx, dy, length }, filter };
}
