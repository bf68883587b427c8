import { type ParticleOptions, Random, type Vec2 } from '@mass/core';
import type { LinkPlan, ObstaclePlan, PartPlan, SpringPlan, SurfacePlan, WallsPlan, WorldPlan } from './plan.ts';
import { type Room, roomAround } from './room.ts';

/** Steps that a world is made for. Unit: s. */
export const DT: number = 1 / 60;

/** Speeds at the start: of discs and points, and of whatever has edges that collide. Unit: m/s. */
const FASTEST = 500;
const FASTEST_EDGES = 50;

/** The greatest mass of a world in its smallest ones. */
const MASS_RATIO = 10_000;

/**
 * How fast a spring may swing, and how strong a drag may be, for a step to follow it: the energy of a swing wavers by ω times a small step, 4 %.
 * Unit: rad/s, 1/s.
 */
const SWIFTEST_SPRING = 0.15 / DT;
const STRONGEST_DRAG = 0.1 / DT;

/** How many of its lengths a spring may fly in a second: ends that whip past each other turn it faster than small steps can follow. Unit: 1/s. */
const FASTEST_SPRING = 10;

/** What is settled for a whole world before its parts are made. */
interface Style {
  readonly random: Random;
  /** Unit: m. */
  readonly smallest: number;
  readonly largest: number;
  /** Unit: kg. */
  readonly lightest: number;
  readonly massRatio: number;
  /** Unit: m/s. */
  readonly speed: number;
  readonly restitution: () => number;
  readonly friction: () => number;
  readonly damping: number;
  readonly kinds: readonly PartKind[];
  readonly hasEdges: boolean;
}

type PartKind = 'disc' | 'point' | 'pair' | 'chain' | 'pendulum' | 'web' | 'spring' | 'body';

/** A part around the origin, before it has a place. */
interface Draft {
  readonly part: PartPlan;
  /** Of the circle around all of it. Unit: m. */
  readonly radius: number;
}

/** Makes the plan of a world from its seed. */
export function randomPlan(seed: number): WorldPlan {
  const random = new Random(seed);
  const style = randomStyle(random);
  const count = 1 + Math.floor(30 * random.between(0, 1) ** 2);
  const drafts = Array.from({ length: count }, () => randomDraft(style));
  const overlaps = random.between(0, 1) < 0.1;
  const surface = (): SurfacePlan => randomSurface(style);
  const obstacleSizes =
    random.between(0, 1) < 0.4 ? Array.from({ length: random.integer(1, 3) }, () => sizeOf(style)) : [];
  const fill = random.between(0.03, 0.4);
  const area = [...drafts.map(({ radius }) => radius), ...obstacleSizes].reduce((sum, r) => sum + 4 * r * r, 0) / fill;
  const widest = Math.max(...drafts.map(({ radius }) => radius), ...obstacleSizes);
  const walls = randomWalls(random, Math.max(Math.sqrt(area), 4 * widest), surface());
  const room = roomAround(walls);
  const taken: Circle[] = [];
  const obstacles: ObstaclePlan[] = [];
  for (const radius of obstacleSizes) {
    const place = findPlace(random, room, radius, taken);
    if (place === undefined) continue;
    taken.push({ ...place, radius });
    obstacles.push(randomObstacle(random, place, radius, surface()));
  }
  const parts: PartPlan[] = [];
  for (const { part, radius } of drafts) {
    const place = findPlace(random, room, radius, overlaps ? [] : taken);
    if (place === undefined) continue;
    taken.push({ ...place, radius });
    parts.push(moved(part, place));
  }
  const pull = pick(random, [0, 9.81, 9.81, random.between(1, 30)]);
  const tilt = random.between(0, 1) < 0.7 ? 0 : random.between(-Math.PI, Math.PI);
  const removed = random.between(0, 1) < 0.2 && parts.length > 1;
  return {
    seed,
    gravity: { x: pull * Math.sin(tilt), y: -pull * Math.cos(tilt) },
    drag: random.between(0, 1) < 0.2 ? style.lightest * random.between(0, STRONGEST_DRAG) : 0,
    walls,
    obstacles,
    parts,
    overlaps,
    removal: removed ? { part: random.integer(0, parts.length - 1), step: random.integer(1, 99) } : undefined,
  };
}

interface Circle extends Vec2 {
  readonly radius: number;
}

function randomStyle(random: Random): Style {
  const smallest = 10 ** random.between(-2, 1);
  const ratio = random.between(0, 1) < 0.3 ? 1 : 10 ** random.between(0, 2);
  const kinds = pick<readonly PartKind[]>(random, [
    ['disc'],
    ['disc'],
    ['disc', 'point'],
    ['pair', 'chain', 'pendulum', 'web'],
    ['disc', 'pair', 'chain', 'web'],
    ['disc', 'spring'],
    ['body'],
    ['body', 'disc'],
    ['disc', 'point', 'pair', 'chain', 'pendulum', 'web', 'spring', 'body'],
  ]);
  const chains = kinds.includes('chain') && random.between(0, 1) < 0.3;
  const hasEdges = kinds.includes('body') || chains;
  const bounce = pick(random, [0, 1, random.between(0, 1), -1]);
  const grip = pick(random, [0, random.between(0, 1), -1, 3]);
  return {
    random,
    smallest,
    largest: Math.min(100, smallest * ratio),
    lightest: 10 ** random.between(-3, 2),
    massRatio: pick(random, [1, MASS_RATIO, 10 ** random.between(0, 4)]),
    speed: (hasEdges ? FASTEST_EDGES : FASTEST) * 10 ** random.between(-4, 0),
    restitution: () => (bounce < 0 ? random.between(0, 1) : bounce),
    friction: () => (grip < 0 ? random.between(0, 1.5) : grip),
    damping: random.between(0, 1) < 0.2 ? random.between(0.1, 1) : 1,
    kinds,
    hasEdges,
  };
}

function randomDraft(style: Style): Draft {
  const { random } = style;
  const kind = pick(random, style.kinds);
  const velocity = randomVelocity(style);
  if (kind === 'body') return randomBody(style, velocity);
  const size = sizeOf(style);
  switch (kind) {
    case 'disc':
      return loose([randomParticle(style, 0, 0, size, velocity)]);
    case 'point':
      return { ...loose([randomParticle(style, 0, 0, 0, velocity)]), radius: size };
    case 'pair':
      return row(style, 2, size, velocity, []);
    case 'chain':
      return row(style, random.integer(2, 12), size, velocity, style.hasEdges ? ['collides'] : []);
    case 'pendulum':
      return row(style, random.integer(1, 6), size, velocity, ['pinned']);
    case 'spring':
      return springPair(style, size, velocity);
    case 'web':
      return web(style, size, velocity);
  }
}

/** Particles in a row, joined each to the next, at most touching. */
function row(
  style: Style,
  count: number,
  size: number,
  velocity: Vec2,
  traits: readonly ('pinned' | 'collides')[],
): Draft {
  const { random } = style;
  const pitch = size * random.between(2.001, 4);
  const angle = random.between(-Math.PI, Math.PI);
  const pinned = traits.includes('pinned');
  const at = (k: number): Vec2 => ({
    x: pitch * (k - count / 2) * Math.cos(angle),
    y: pitch * (k - count / 2) * Math.sin(angle),
  });
  const particles = Array.from({ length: count }, (_, k) => {
    const own = random.between(0, 1) < 0.3 ? randomVelocity(style) : velocity;
    return randomParticle(style, at(k).x, at(k).y, random.between(0, 1) < 0.1 ? 0 : size, own);
  });
  const links: LinkPlan[] = [];
  const kind = pick(random, ['rod', 'cable'] as const);
  for (let k = 1; k < count; k++) links.push(randomLink(style, kind, k - 1, k, pitch));
  if (pinned) links.push(randomLink(style, kind, 0, at(-1), pitch));
  return loose(particles, links, [], traits.includes('collides'));
}

/** Particles on a grid, joined along its lines, and across some of its fields: loops. */
function web(style: Style, size: number, velocity: Vec2): Draft {
  const { random } = style;
  const wide = random.integer(2, 4);
  const high = random.integer(2, 3);
  const pitch = size * random.between(2.001, 4);
  const kind = pick(random, ['rod', 'cable'] as const);
  const particles: ParticleOptions[] = [];
  const links: LinkPlan[] = [];
  for (let k = 0; k < wide * high; k++) {
    const column = k % wide;
    const line = Math.floor(k / wide);
    const x = (column - (wide - 1) / 2) * pitch;
    particles.push(randomParticle(style, x, (line - (high - 1) / 2) * pitch, size, velocity));
    if (column > 0) links.push(randomLink(style, kind, k - 1, k, pitch));
    if (line > 0) links.push(randomLink(style, kind, k - wide, k, pitch));
    if (column > 0 && line > 0 && random.between(0, 1) < 0.5)
      links.push(randomLink(style, kind, k - wide - 1, k, pitch * Math.SQRT2));
  }
  return loose(particles, links);
}

function springPair(style: Style, size: number, asked: Vec2): Draft {
  const { random } = style;
  const pitch = size * random.between(2.1, 6);
  const share = Math.min(1, (FASTEST_SPRING * pitch) / Math.hypot(asked.x, asked.y));
  const velocity = { x: share * asked.x, y: share * asked.y };
  const particles = [
    randomParticle(style, -pitch / 2, 0, size, velocity),
    randomParticle(style, pitch / 2, 0, size, velocity),
  ];
  const mass = Math.min(...particles.map(({ mass = 1 }) => mass)) / 2;
  const stiffness = mass * random.between(1, SWIFTEST_SPRING) ** 2;
  return loose(particles, [], [{ a: 0, b: 1, stiffness, restLength: pitch * random.between(0.5, 1.5) }]);
}

function randomBody(style: Style, velocity: Vec2): Draft {
  const { random } = style;
  const size = sizeOf(style);
  const radius = size * random.between(0.05, 0.3);
  const { x: _x, y: _y, ...shared } = randomParticle(style, 0, 0, radius, velocity);
  const turn = (style.speed / size) * random.between(-0.3, 0.3);
  const common = { ...shared, x: 0, y: 0, angle: random.between(-3, 3), angularVelocity: turn };
  if (random.between(0, 1) < 0.5) {
    const width = size * random.between(0.5, 2);
    const height = size * random.between(0.5, 2);
    return {
      part: { body: { kind: 'box', width, height, ...common } },
      radius: Math.hypot(width, height) / 2 + radius,
    };
  }
  return {
    part: { body: { kind: 'polygon', sides: random.integer(3, 10), circumradius: size, ...common } },
    radius: size + radius,
  };
}

function loose(
  particles: readonly ParticleOptions[],
  links: readonly LinkPlan[] = [],
  springs: readonly SpringPlan[] = [],
  collides = false,
): Draft {
  let radius = 0;
  for (const { x, y, radius: own = 0 } of particles) radius = Math.max(radius, Math.hypot(x, y) + own);
  return { part: { particles, links, springs, collides }, radius };
}

function randomLink(style: Style, kind: 'rod' | 'cable', a: number, b: number | Vec2, length: number): LinkPlan {
  const { random } = style;
  return {
    kind,
    a,
    b,
    length: length * (kind === 'cable' ? random.between(1, 1.2) : 1),
    compliance: random.between(0, 1) < 0.1 ? 10 ** random.between(-6, -2) / style.lightest : 0,
    damping: random.between(0, 1) < 0.3 ? random.between(0, 1) : 0,
    restitution: random.between(0, 1) < 0.1 ? random.between(0, 1) : 0,
  };
}

function randomParticle(style: Style, x: number, y: number, radius: number, { x: vx, y: vy }: Vec2): ParticleOptions {
  const { lightest, massRatio, random, damping } = style;
  const mass = lightest * massRatio ** random.between(0, 1);
  return { x, y, vx, vy, radius, mass, damping, restitution: style.restitution(), friction: style.friction() };
}

function randomVelocity({ random, speed }: Style): Vec2 {
  const angle = random.between(-Math.PI, Math.PI);
  const fast = speed * random.between(0, 1);
  return { x: fast * Math.cos(angle), y: fast * Math.sin(angle) };
}

function sizeOf({ random, smallest, largest }: Style): number {
  return smallest * (largest / smallest) ** random.between(0, 1);
}

function randomSurface({ random, restitution, friction, speed }: Style): SurfacePlan {
  const moves = random.between(0, 1) < 0.15;
  return {
    restitution: restitution(),
    friction: friction(),
    surfaceSpeed: moves ? random.between(-1, 1) * Math.min(speed, 20) : 0,
  };
}

function randomWalls(random: Random, size: number, surface: SurfacePlan): WallsPlan {
  const kind = pick(random, ['half-planes', 'half-planes', 'segments', 'polyline', 'boxes'] as const);
  const aspect = 2 ** random.between(-0.9, 0.9);
  const turn = random.between(0, 1) < 0.6 ? 0 : random.between(-Math.PI, Math.PI);
  const sides = random.between(0, 1) < 0.7 ? 4 : random.integer(5, 9);
  const corners = Array.from({ length: sides }, (_, k) => {
    const angle = ((k + 0.5) / sides) * 2 * Math.PI;
    const x = size * Math.SQRT1_2 * aspect * Math.cos(angle);
    const y = ((size * Math.SQRT1_2) / aspect) * Math.sin(angle);
    return { x: x * Math.cos(turn) - y * Math.sin(turn), y: x * Math.sin(turn) + y * Math.cos(turn) };
  });
  return { kind, corners, thickness: random.between(0, 1) < 0.5 ? 0 : size * random.between(0.001, 0.1), ...surface };
}

function randomObstacle(random: Random, centre: Vec2, radius: number, surface: SurfacePlan): ObstaclePlan {
  const kind = pick(random, ['disc', 'box', 'segment'] as const);
  const angle = random.between(-Math.PI, Math.PI);
  const x = radius * Math.cos(angle);
  const y = radius * Math.sin(angle);
  if (kind === 'disc') return { kind, centre, radius, ...surface };
  if (kind === 'box')
    return { kind, centre, width: Math.abs(2 * x) + radius / 100, height: Math.abs(2 * y) + radius / 100, ...surface };
  return {
    kind,
    a: { x: centre.x - 0.9 * x, y: centre.y - 0.9 * y },
    b: { x: centre.x + 0.9 * x, y: centre.y + 0.9 * y },
    thickness: radius * random.between(0, 0.1),
    ...surface,
  };
}

/** A place for a circle that keeps clear of the others; undefined where none was found. */
function findPlace(random: Random, room: Room, radius: number, taken: readonly Circle[]): Vec2 | undefined {
  for (let attempt = 0; attempt < 60; attempt++) {
    const x = random.between(room.minX, room.maxX);
    const y = random.between(room.minY, room.maxY);
    if (room.distance(x, y) < radius * 1.001) continue;
    if (taken.some((other) => Math.hypot(other.x - x, other.y - y) < (other.radius + radius) * 1.001)) continue;
    return { x, y };
  }
  return undefined;
}

function moved(part: PartPlan, by: Vec2): PartPlan {
  if ('body' in part) return { body: { ...part.body, ...by } };
  const to = ({ x, y }: Vec2): Vec2 => ({ x: x + by.x, y: y + by.y });
  const end = (b: number | Vec2): number | Vec2 => (typeof b === 'number' ? b : to(b));
  return {
    ...part,
    particles: part.particles.map((particle) => ({ ...particle, ...to(particle) })),
    links: part.links.map((link) => ({ ...link, b: end(link.b) })),
    springs: part.springs.map((spring) => ({ ...spring, b: end(spring.b) })),
  };
}

function pick<T>(random: Random, list: readonly T[]): T {
  return list[random.integer(0, list.length - 1)];
}
