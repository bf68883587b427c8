import type { Vec2, World } from '@mass/core';
import { type Built, buildWorld } from './build-world.ts';
import type { WorldPlan } from './plan.ts';
import { DT } from './random-plan.ts';
import { roomAround } from './room.ts';

/** How many steps a world takes. */
const STEPS = 100;

/** How much energy may be gained, as a share. */
const GAIN = 0.05;

/** How far the centre of a thing may be beyond a wall: by rounding, as a share of the room; in a solid wall, as a point in its softness. Unit: m. */
const ROUNDING = 1e-9;
const SOFTNESS = 1e-3;

/** What energy is none: that of rounding. Unit: J/kg. */
const NO_ENERGY = 1e-12;

/** What was wrong with a world. */
export interface Violation {
  readonly kind: 'error' | 'not finite' | 'escape' | 'energy';
  readonly step: number;
  readonly detail: string;
}

/** Steps a world, and tells what was wrong, if anything was. */
export function judge(plan: WorldPlan): Violation | undefined {
  const built = buildWorld(plan);
  const { world, parts } = built;
  const room = roomAround(plan.walls);
  const size = Math.max(room.maxX - room.minX, room.maxY - room.minY);
  const { kind, thickness } = plan.walls;
  const depth = kind === 'half-planes' || kind === 'boxes' ? SOFTNESS : Math.min(SOFTNESS, thickness / 4);
  const allowed = ROUNDING * size + depth;
  const ground = lowest(plan);
  const least = NO_ENERGY * massOf(world);
  let most = energyOf(built, ground);
  for (let step = 1; step <= STEPS; step++) {
    if (step === plan.removal?.step) for (const particle of parts[plan.removal.part]) particle.remove();
    try {
      world.step(DT);
    } catch (error) {
      return { kind: 'error', step, detail: String(error) };
    }
    const { count, alive, x, y } = world.particles;
    for (let i = 0; i < count; i++) {
      if (alive[i] === 0) continue;
      const inside = room.distance(x[i], y[i]);
      if (Number.isNaN(inside)) return { kind: 'not finite', step, detail: `particle ${i}` };
      if (inside < -allowed) return { kind: 'escape', step, detail: `particle ${i} by ${-inside} m` };
    }
    if (plan.overlaps) continue;
    most += workOfBelts(world);
    const energy = energyOf(built, ground);
    if (!(energy <= most * (1 + GAIN) + least)) {
      return { kind: 'energy', step, detail: `${energy / most} times: ${energy} J of ${most} J` };
    }
  }
  return undefined;
}

/** The lowest point of the room: there the potential of gravity is zero. */
function lowest({ gravity, walls }: WorldPlan): Vec2 {
  const heights = walls.corners.map(({ x, y }) => -x * gravity.x - y * gravity.y);
  return walls.corners[heights.indexOf(Math.min(...heights))];
}

function massOf({ particles }: World): number {
  let mass = 0;
  for (let i = 0; i < particles.count; i++) mass += particles.mass[i];
  return mass;
}

/** Motion, gravity and springs. Unit: J. */
function energyOf({ world, springs }: Built, ground: Vec2): number {
  const { count, alive, mass, x, y, vx, vy } = world.particles;
  const { gravity } = world;
  let energy = 0;
  for (let i = 0; i < count; i++) {
    if (alive[i] === 0) continue;
    const height = (ground.x - x[i]) * gravity.x + (ground.y - y[i]) * gravity.y;
    energy += mass[i] * ((vx[i] * vx[i] + vy[i] * vy[i]) / 2 + height);
  }
  for (const spring of springs) energy += spring.energy;
  return energy;
}

/** What moving surfaces did by friction in the last step, as far as they drove. Unit: J. */
function workOfBelts({ contacts }: World): number {
  const { count, tangentImpulse, surfaceSpeed } = contacts;
  let work = 0;
  for (let c = 0; c < count; c++) work += Math.max(0, tangentImpulse[c] * surfaceSpeed[c]);
  return work;
}
