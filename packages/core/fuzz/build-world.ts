import {
  Box,
  box,
  cable,
  Disc,
  DiscContacts,
  Drag,
  EdgeContacts,
  HalfPlane,
  type Particle,
  Polyline,
  type Resolver,
  regularPolygon,
  rod,
  Segment,
  type Shape,
  Springs,
  type Vec2,
  World,
} from '@mass/core';
import { isBody, type LoosePlan, type ObstaclePlan, type WallsPlan, type WorldPlan } from './plan.ts';

/** A world that was built from a plan. */
export interface Built {
  readonly world: World;
  readonly springs: Springs;
  /** The particles of each part. */
  readonly parts: readonly (readonly Particle[])[];
}

/** Builds a world from its plan. */
export function buildWorld(plan: WorldPlan, resolver?: Resolver): Built {
  const world = new World({ gravity: plan.gravity, ...(resolver ? { resolver } : {}) });
  for (const wall of wallsOf(plan.walls)) world.addShape(wall);
  for (const obstacle of plan.obstacles) world.addShape(shapeOf(obstacle));
  world.addContactGenerator(new DiscContacts());
  const springs = new Springs();
  const edges = new EdgeContacts(world);
  const parts = plan.parts.map((part) => {
    if (!isBody(part)) return addLoose(world, part, springs, edges);
    const { body } = part;
    return [
      ...world.addBody(body.kind === 'box' ? box(withoutKind(body)) : regularPolygon(withoutKind(body))).particles,
    ];
  });
  if (plan.parts.some((part) => isBody(part) || part.collides)) world.addContactGenerator(edges);
  if (springs.count > 0) world.addForce(springs);
  if (plan.drag > 0) world.addForce(new Drag({ k1: plan.drag }));
  return { world, springs, parts };
}

function addLoose(world: World, part: LoosePlan, springs: Springs, edges: EdgeContacts): Particle[] {
  const particles = part.particles.map((options) => world.addParticle(options));
  const endOf = (b: number | Vec2): Particle | Vec2 => (typeof b === 'number' ? particles[b] : b);
  const links = part.links.map(({ kind, a, b, length, ...giving }) =>
    world.addLink(
      kind === 'rod'
        ? rod(particles[a], endOf(b), { length, compliance: giving.compliance, damping: giving.damping })
        : cable(particles[a], endOf(b), { maxLength: length, ...giving }),
    ),
  );
  if (part.collides) edges.add(links);
  for (const { a, b, ...options } of part.springs) springs.add(particles[a], endOf(b), options);
  return particles;
}

function shapeOf(obstacle: ObstaclePlan): Shape {
  switch (obstacle.kind) {
    case 'disc':
      return new Disc(withoutKind(obstacle));
    case 'box':
      return new Box(withoutKind(obstacle));
    case 'segment':
      return new Segment(withoutKind(obstacle));
  }
}

function wallsOf({ kind, corners, thickness, restitution, friction, surfaceSpeed }: WallsPlan): Shape[] {
  const surface = { restitution, friction, surfaceSpeed };
  if (kind === 'polyline') return [new Polyline({ points: corners, closed: true, thickness, ...surface })];
  return corners.map((a, k) => {
    const b = corners[(k + 1) % corners.length];
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    const ux = (b.x - a.x) / length;
    const uy = (b.y - a.y) / length;
    if (kind === 'half-planes') return new HalfPlane({ point: a, normal: { x: -uy, y: ux }, ...surface });
    if (kind === 'segments') return new Segment({ a, b, thickness, ...surface });
    const deep = length / 4;
    const centre = { x: (a.x + b.x) / 2 + (uy * deep) / 2, y: (a.y + b.y) / 2 - (ux * deep) / 2 };
    return new Box({ centre, width: length + 2 * deep, height: deep, angle: Math.atan2(uy, ux), ...surface });
  });
}

function withoutKind<T extends { readonly kind: string }>({ kind: _, ...others }: T): Omit<T, 'kind'> {
  return others;
}
