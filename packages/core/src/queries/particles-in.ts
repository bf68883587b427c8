import { requireFinite, requireNonNegative, requireOrdered } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';
import type { World } from '../world/world.ts';

/** The particles whose disc covers a point, by slot. Unit: m. */
export function particlesAt(world: World, x: number, y: number): Particle[] {
  return inCircle('particlesAt', world, x, y, 0);
}

/** The particles whose disc touches a circle or lies in it, by slot. Unit: m. */
export function particlesInCircle(world: World, x: number, y: number, radius: number): Particle[] {
  return inCircle('particlesInCircle', world, x, y, radius);
}

/** The particles whose disc touches a box or lies in it, by slot. Unit: m. */
export function particlesInBox(world: World, minX: number, minY: number, maxX: number, maxY: number): Particle[] {
  for (const [name, value] of Object.entries({ minX, minY, maxX, maxY })) {
    requireFinite('particlesInBox', name, value, 'metres');
  }
  requireOrdered('particlesInBox', 'x', minX, maxX, 'm');
  requireOrdered('particlesInBox', 'y', minY, maxY, 'm');
  const { count, alive, x, y, radius } = world.particles;
  const found: Particle[] = [];
  for (let i = 0; i < count; i++) {
    const dx = x[i] - Math.min(Math.max(x[i], minX), maxX);
    const dy = y[i] - Math.min(Math.max(y[i], minY), maxY);
    if (alive[i] === 1 && dx * dx + dy * dy <= radius[i] * radius[i]) found.push(world.particleAt(i));
  }
  return found;
}

function inCircle(where: string, world: World, cx: number, cy: number, reach: number): Particle[] {
  requireFinite(where, 'x', cx, 'metres');
  requireFinite(where, 'y', cy, 'metres');
  requireNonNegative(where, 'radius', reach, 'metres');
  const { count, alive, x, y, radius } = world.particles;
  const found: Particle[] = [];
  for (let i = 0; i < count; i++) {
    const dx = x[i] - cx;
    const dy = y[i] - cy;
    const touching = radius[i] + reach;
    if (alive[i] === 1 && dx * dx + dy * dy <= touching * touching) found.push(world.particleAt(i));
  }
  return found;
}
