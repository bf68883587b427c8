import { DistanceLink, distanceNow } from '../links/distance-link.ts';
import { requireInteger, requireOneOf, requireOptions, requirePositive } from '../math/checks.ts';
import { checkedEnd, type End } from '../particles/end.ts';
import { Particle } from '../particles/particle.ts';
import { aggregate } from './aggregate.ts';
import { arc } from './arc.ts';
import { checkedShares, type SharedOptions } from './body-options.ts';
import type { BodyPlan } from './body-plan.ts';

/** How a chain is made. */
export interface ChainOptions extends SharedOptions {
  /** Where it begins: a particle that is in the world, or a fixed point `{ x, y }` in metres. */
  from: End;
  /** Where it ends. */
  to: End;
  /** Ends that hang on nothing: there the chain has a particle of its own. They are given as points. @default none */
  free?: 'from' | 'to' | 'both';
  /** How many links, 1 to 10000. Give this or `linkLength`. */
  links?: number;
  /** The greatest length of a link: as many are made as it takes, all of one length. Unit: m. */
  linkLength?: number;
  /** Length in all, no shorter than the way between the ends. Unit: m. @default the distance of the ends */
  length?: number;
  /** What a link is: a cable, which may be slack, or a rod. @default 'cable' */
  kind?: 'cable' | 'rod';
  /** How the mass is spread, one positive number for each of the chain's own particles, in any unit. @default evenly */
  weights?: readonly number[];
}

const MOST_LINKS = 10_000;

/**
 * A chain or rope, to hand to `World.addBody`: particles in a row, joined by cables or rods, from one end to another. The ends
 * are not its own, unless they are free: they stay when the chain is removed, and do not count in its mass. A chain that is
 * longer than the way between its ends starts as an arc that bends down.
 *
 * Under `severity` the default limit of iterations holds some 6 links, off by 1 % of their length at 1/60 s; 10 by some
 * 10 % and 20 fall apart. With `severity({ iterations: 1000 })` 10 links are off by 0.002 %, with 5000 20 links by 0.02 %.
 *
 * @example
 * ```ts
 * world.addBody(chain({ from: { x: -2, y: 3 }, to: { x: 2, y: 3 }, length: 5, links: 20, mass: 2 }));
 * world.addBody(chain({ from: { x: 0, y: 4 }, to: ball, linkLength: 0.2 }));
 * world.addBody(chain({ from: { x: 0, y: 4 }, to: { x: 0, y: 1 }, free: 'to', links: 10 }));
 * ```
 */
export function chain(options: ChainOptions): BodyPlan {
  requireOptions('chain', 'options', options, '{ from: { x: 0, y: 3 }, to: { x: 2, y: 3 }, links: 10 }');
  const { from, to, free, links, linkLength, length, kind = 'cable', weights, ...shared } = options;
  const { particle, giving, mass } = checkedShares('chain', shared);
  const freeFrom = free === 'from' || free === 'both';
  const freeTo = free === 'to' || free === 'both';
  requireOneOf('chain', 'free', free, ['from', 'to', 'both', undefined]);
  requireOneOf('chain', 'kind', kind, ['cable', 'rod']);
  const start = checkedChainEnd('from', from, freeFrom);
  const end = checkedChainEnd('to', to, freeTo);
  const total = checkedLength(start, end, length);
  const count = checkedCount(total, links, linkLength);
  if (kind === 'rod' && count === 1 && total > distanceNow(start, end)) {
    throw new RangeError('chain: a single rod must be as long as the way between its ends. Leave out length.');
  }
  const places = arc(start, end, total, count);
  const first = freeFrom ? 0 : 1;
  const last = freeTo ? count : count - 1;
  const masses = checkedMasses(last - first + 1, mass, weights);
  const each = total / count;
  const limits = { kind, minLength: kind === 'rod' ? each : 0, maxLength: each, ...giving };
  const endAt = (place: number) => (place < first ? start : place > last ? end : place - first);
  return aggregate({
    kind: 'chain',
    closed: false,
    particles: masses.map((own, index) => ({ ...particle, ...places[index + first], mass: own })),
    links: Array.from({ length: count }, (_, link) => ({
      a: endAt(link),
      b: endAt(link + 1),
      join: (a, b) => new DistanceLink('chain', a, b, limits),
    })),
  });
}

function checkedChainEnd(name: string, end: End, free: boolean): End {
  const checked = checkedEnd('chain', name, end);
  if (free && checked instanceof Particle) {
    throw new TypeError(
      `chain: ${name} must be a point { x, y } where that end is free; got a particle. Leave out free, or give its place.`,
    );
  }
  return checked;
}

function checkedLength(start: End, end: End, length: number | undefined): number {
  const distance = distanceNow(start, end);
  const total = length ?? distance;
  requirePositive(
    'chain',
    'length',
    total,
    'metres',
    length === undefined ? 'Its ends are at one place: give one.' : '',
  );
  if (total < distance) {
    throw new RangeError(`chain: length must reach from end to end, at least ${distance} m; got ${total}.`);
  }
  return total;
}

function checkedCount(total: number, links: number | undefined, linkLength: number | undefined): number {
  if ((links === undefined) === (linkLength === undefined)) {
    throw new TypeError('chain: links or linkLength must be given, and not both.');
  }
  if (linkLength === undefined) {
    requireInteger('chain', 'links', links as number, 1, MOST_LINKS);
    return links as number;
  }
  requirePositive('chain', 'linkLength', linkLength, 'metres');
  const count = Math.max(1, Math.ceil((total / linkLength) * (1 - 1e-12))); // 3 m of 0.1 m are 30 links, whatever the rounding
  requireInteger('chain', 'length / linkLength', count, 1, MOST_LINKS);
  return count;
}

function checkedMasses(count: number, mass: number, weights: readonly number[] | undefined): number[] {
  if (count === 0) {
    throw new RangeError(
      'chain: a chain must have a particle of its own; got one link between two ends. Use cable or rod.',
    );
  }
  if (weights === undefined) return Array.from({ length: count }, () => mass / count);
  if (weights.length !== count) {
    throw new RangeError(`chain: weights must have one number for each particle, ${count}; got ${weights.length}.`);
  }
  let sum = 0;
  for (const [index, weight] of weights.entries()) {
    requirePositive('chain', `weights[${index}]`, weight, '');
    sum += weight;
  }
  return weights.map((weight) => (mass * weight) / sum);
}
