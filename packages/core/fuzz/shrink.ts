import { judge, type Violation } from './judge.ts';
import { isBody, type PartPlan, type WorldPlan } from './plan.ts';

/** How many smaller worlds are tried. */
const MOST_TRIES = 600;

/** Leaves out of a failing world what it fails without, in the same way. */
export function shrink(plan: WorldPlan, { kind }: Violation): WorldPlan {
  let tries = 0;
  for (let smaller = true; smaller; ) {
    smaller = false;
    for (const candidate of candidates(plan)) {
      if (tries++ > MOST_TRIES) return plan;
      if (judge(candidate)?.kind !== kind) continue;
      plan = candidate;
      smaller = true;
      break;
    }
  }
  return plan;
}

function* candidates(plan: WorldPlan): Generator<WorldPlan> {
  const { parts, obstacles, walls, gravity } = plan;
  if (plan.removal) yield { ...plan, removal: undefined };
  else {
    for (let half = Math.ceil(parts.length / 2); half > 1; half = Math.ceil(half / 2)) {
      for (let p = 0; p < parts.length; p += half)
        yield { ...plan, parts: [...parts.slice(0, p), ...parts.slice(p + half)] };
    }
    for (let p = 0; p < parts.length; p++) yield { ...plan, parts: parts.filter((_, k) => k !== p) };
  }
  for (let o = 0; o < obstacles.length; o++) yield { ...plan, obstacles: obstacles.filter((_, k) => k !== o) };
  if (plan.drag > 0) yield { ...plan, drag: 0 };
  if (gravity.x !== 0 || gravity.y !== 0) yield { ...plan, gravity: { x: 0, y: 0 } };
  if (walls.kind !== 'half-planes') yield { ...plan, walls: { ...walls, kind: 'half-planes', thickness: 0 } };
  for (const name of ['restitution', 'friction', 'surfaceSpeed'] as const) {
    if (walls[name] !== 0) yield { ...plan, walls: { ...walls, [name]: 0 } };
  }
  for (let p = 0; p < parts.length; p++) {
    for (const part of simpler(parts[p])) yield { ...plan, parts: parts.map((other, k) => (k === p ? part : other)) };
  }
}

function* simpler(part: PartPlan): Generator<PartPlan> {
  if (isBody(part)) {
    const { body } = part;
    for (const [name, value] of Object.entries({ ...REST, angularVelocity: 0 })) {
      if (body[name as keyof typeof body] !== value) yield { body: { ...body, [name]: value } };
    }
    return;
  }
  const { particles, links, springs } = part;
  const last = particles.length - 1;
  if (last > 0) {
    const without = ({ a, b }: { a: number; b: unknown }): boolean => a !== last && b !== last;
    yield {
      ...part,
      particles: particles.slice(0, last),
      links: links.filter(without),
      springs: springs.filter(without),
    };
  }
  for (let l = 0; l < links.length; l++) yield { ...part, links: links.filter((_, k) => k !== l) };
  for (let s = 0; s < springs.length; s++) yield { ...part, springs: springs.filter((_, k) => k !== s) };
  if (part.collides) yield { ...part, collides: false };
  for (const [name, value] of Object.entries(REST)) {
    if (particles.some((particle) => particle[name as keyof typeof REST] !== value))
      yield { ...part, particles: particles.map((particle) => ({ ...particle, [name]: value })) };
  }
  for (const [name, value] of Object.entries({ compliance: 0, damping: 0, restitution: 0 })) {
    if (links.some((link) => link[name as 'compliance'] !== value))
      yield { ...part, links: links.map((link) => ({ ...link, [name]: value })) };
  }
}

/** What is simplest. */
const REST = { vx: 0, vy: 0, friction: 0, restitution: 0, damping: 1 };
