import { describe, requireFinite, requireFunction, requireOptions } from '../math/checks.ts';
import { checkedEnd, type End } from '../particles/end.ts';
import { Particle } from '../particles/particle.ts';
import { checkParticleOptions } from '../particles/particle-options.ts';
import { Body } from './body.ts';
import type { BodyParts, BodySite, LinkPlan } from './body-parts.ts';
import type { BodyPlan } from './body-plan.ts';

/**
 * A body of any particles and links, to hand to `World.addBody`: what `box`, `polygon` and `chain` are made by, and a game's own
 * builder.
 *
 * @example
 * ```ts
 * const ends = [{ x: -1, y: 2, mass: 5 }, { x: 1, y: 2, mass: 5 }];
 * world.addBody(aggregate({ kind: 'dumb-bell', particles: ends, links: [{ a: 0, b: 1, join: rod }], closed: false }));
 * ```
 */
export function aggregate(parts: BodyParts): BodyPlan {
  requireOptions('aggregate', 'a body', parts, "{ kind: 'bar', particles: […], links: […] }");
  const { kind, particles, links, closed = true, angle = 0 } = parts;
  return { kind, particles, links, closed, angle, build };
}

/** Checks all of a plan, then builds it. Should a game's own `join` throw, what was built by then is taken out again. */
function build(this: BodyParts, where: string, site: BodySite): Body {
  checkParts(where, this, site.particles);
  const particles: Particle[] = [];
  try {
    for (const options of this.particles) particles.push(site.addParticle(options));
    const links = this.links.map(({ a, b, join }) => join(endOf(a, particles), endOf(b, particles)));
    for (const link of links) site.addLink(link);
    return new Body(site, this, particles, links);
  } catch (error) {
    for (const particle of particles.reverse()) site.removeParticle(particle);
    throw error;
  }
}

function endOf(end: number | End, particles: readonly Particle[]): End {
  return typeof end === 'number' ? particles[end] : end;
}

function checkParts(where: string, parts: BodyParts, particles: object): void {
  if (!Array.isArray(parts.particles) || parts.particles.length === 0 || !Array.isArray(parts.links)) {
    throw new TypeError(
      `${where}: a body must have a list of particles, at least one, and a list of links; got ${describe(parts.particles)} and ${describe(parts.links)}.`,
    );
  }
  requireFinite(where, 'angle', parts.angle ?? 0, 'radians');
  for (const [index, options] of parts.particles.entries()) {
    checkParticleOptions(`${where}, particle ${index} of the ${parts.kind}`, options);
  }
  for (const [index, link] of parts.links.entries()) {
    checkLink(`${where}, link ${index} of the ${parts.kind}`, link, parts.particles.length, particles);
  }
}

function checkLink(where: string, link: LinkPlan, count: number, particles: object): void {
  requireOptions(where, 'a link', link, '{ a: 0, b: 1, join: rod }');
  requireFunction(where, 'join', link.join, 'such as rod');
  for (const [name, end] of [
    ['a', link.a],
    ['b', link.b],
  ] as const) {
    if (typeof end !== 'number') {
      checkedEnd(where, name, end);
      if (end instanceof Particle && !end.isIn(particles)) {
        throw new Error(`${where}: ${name} must be a particle of this world; it lives in another.`);
      }
    } else if (!(Number.isInteger(end) && end >= 0 && end < count)) {
      throw new RangeError(`${where}: ${name} must be the place of a particle, 0 to ${count - 1}; got ${end}.`);
    }
  }
  if (link.a === link.b || (typeof link.a !== 'number' && typeof link.b !== 'number')) {
    throw new TypeError(`${where}: a link must have two ends, and one of the body's own particles at one of them.`);
  }
}
