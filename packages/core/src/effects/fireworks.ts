import {
  describe,
  requireFinite,
  requireInteger,
  requireMass,
  requireNonNegative,
  requireOptions,
  requireOrdered,
  requirePositive,
  requireShare,
  requireVector,
  wrong,
} from '../math/checks.ts';
import { Random } from '../math/random.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { ParticleSpawner } from '../particles/particle-spawner.ts';
import type { SlotList } from '../particles/slot-list.ts';
import type { Effect } from './effect.ts';

/** What a firework leaves behind when its age runs out: so many of another type. */
export interface FireworkPayload {
  type: number;
  /** How many, 1 or more. */
  count: number;
}

/** How the fireworks of one type behave. */
export interface FireworkRule {
  /** The type that the rule is for, 1 to 65535: it becomes the particles' `group`, so that styles can colour by it. */
  type: number;
  /** Shortest and longest life. Unit: s. */
  minAge: number;
  maxAge: number;
  /** Smallest and greatest velocity on top of the parent's, each component on its own. Unit: m/s. */
  minVelocity: Readonly<Vec2>;
  maxVelocity: Readonly<Vec2>;
  /** Share of the velocity kept per second, 0 to 1. */
  damping: number;
  /** Constant acceleration, on top of the world's gravity. Unit: m/s². @default { x: 0, y: 0 } */
  acceleration?: Readonly<Vec2>;
  /** Mass. Unit: kg. @default 1 */
  mass?: number;
  /** Radius. Unit: m. @default 0 */
  radius?: number;
  /** What bursts out of it when its age has run down. @default none */
  payloads?: readonly FireworkPayload[];
}

/** How fireworks are set up. */
export interface FireworksOptions {
  rules: readonly FireworkRule[];
  /** Seed of the random ages and velocities. @default 1 */
  seed?: number;
  /** The line along the bottom from which fireworks start when no place is given. Unit: m. @default from -10 to 10 at 0 */
  ground?: { minX: number; maxX: number; y: number };
}

/**
 * Fireworks: particles with a type and an age that runs down; then the payloads of their type's rule burst out of them,
 * with the parent's velocity and a random one on top. Good for explosions, splashes, smoke and fire, too. Rules may
 * not burst into themselves, not even by way of others: every firework ends.
 *
 * @example
 * ```ts
 * const fireworks = world.addEffect(new Fireworks({ rules: [rocket, spark], seed: 7 }));
 * fireworks.launch(rocket.type);
 * ```
 */
export class Fireworks implements Effect {
  readonly #rules: ReadonlyMap<number, Required<FireworkRule>>;
  readonly #ground: { readonly minX: number; readonly maxX: number; readonly y: number };
  readonly #random: Random;
  #world: ParticleSpawner | undefined;
  /** One more than the generation of the slot's particle when that is one of ours; 0 otherwise. */
  #owned = new Uint32Array(64);
  #bursts = 0;

  constructor(options: FireworksOptions) {
    requireOptions('Fireworks', 'options', options, '{ rules: [rocket, spark] }');
    const { rules, seed = 1, ground = { minX: -10, maxX: 10, y: 0 } } = options;
    this.#rules = checkedRules(rules);
    this.#random = new Random(seed);
    requireOptions('Fireworks', 'ground', ground, '{ minX: -10, maxX: 10, y: 0 }');
    for (const name of ['minX', 'maxX', 'y'] as const)
      requireFinite('Fireworks', `ground.${name}`, ground[name], 'metres');
    requireOrdered('Fireworks', 'ground x', ground.minX, ground.maxX, 'm');
    this.#ground = { ...ground };
  }

  /** How many fireworks have burst into payloads so far. */
  get bursts(): number {
    return this.#bursts;
  }

  attach(world: ParticleSpawner): void {
    if (this.#world !== undefined) throw new Error('World.addEffect: these fireworks are in a world already.');
    this.#world = world;
  }

  detach(): void {
    this.#world = undefined;
    this.#owned.fill(0); // in another world the same slots and generations are other particles
  }

  /**
   * Lets one firework off. Call it between steps.
   * @param type - A type that has a rule.
   * @param at - Where, in m, and with what velocity of its launcher, in m/s. @default a random place along the ground, at rest
   */
  launch(type: number, at?: { x: number; y: number; vx?: number; vy?: number }): void {
    const rule = this.#rules.get(type);
    if (rule === undefined) {
      throw new RangeError(
        `Fireworks.launch: type must have a rule; got ${describe(type)}. Known are ${this.#known()}.`,
      );
    }
    const world = this.#world;
    if (world === undefined) {
      throw new Error('Fireworks.launch: the fireworks must be in a world. Call world.addEffect(fireworks) first.');
    }
    if (at === undefined) {
      const { minX, maxX, y } = this.#ground;
      this.#create(world, rule, minX + (maxX - minX) * this.#random.next(), y, 0, 0);
      return;
    }
    requireVector('Fireworks.launch', 'at', at, 'metres');
    const { vx = 0, vy = 0 } = at;
    requireFinite('Fireworks.launch', 'at.vx', vx, 'metres per second');
    requireFinite('Fireworks.launch', 'at.vy', vy, 'metres per second');
    this.#create(world, rule, at.x, at.y, vx, vy);
  }

  /** Bursts the fireworks whose age has run out. Reads the expired. Adds particles. */
  afterStep(world: ParticleSpawner, expired: SlotList): void {
    for (let e = 0; e < expired.count; e++) {
      const slot = expired.slots[e];
      if (slot < this.#owned.length && this.#owned[slot] === world.generationAt(slot) + 1) this.#burst(world, slot);
    }
  }

  #burst(world: ParticleSpawner, slot: number): void {
    const { x, y, vx, vy, group } = world.particles;
    const payloads = this.#rules.get(group[slot])?.payloads ?? [];
    if (payloads.length > 0) this.#bursts++;
    for (let p = 0; p < payloads.length; p++) {
      const rule = this.#rules.get(payloads[p].type);
      if (rule === undefined) continue;
      for (let c = 0; c < payloads[p].count; c++) this.#create(world, rule, x[slot], y[slot], vx[slot], vy[slot]);
    }
  }

  #create(world: ParticleSpawner, rule: Required<FireworkRule>, x: number, y: number, vx: number, vy: number): void {
    const random = this.#random;
    const { minVelocity, maxVelocity } = rule;
    const slot = world.spawn(x, y, rule.minAge + (rule.maxAge - rule.minAge) * random.next());
    const particles = world.particles;
    particles.vx[slot] = vx + minVelocity.x + (maxVelocity.x - minVelocity.x) * random.next();
    particles.vy[slot] = vy + minVelocity.y + (maxVelocity.y - minVelocity.y) * random.next();
    if (rule.acceleration.x !== 0) particles.ax[slot] = rule.acceleration.x;
    if (rule.acceleration.y !== 0) particles.ay[slot] = rule.acceleration.y;
    particles.mass[slot] = rule.mass;
    particles.inverseMass[slot] = 1 / rule.mass;
    if (rule.damping !== 1) particles.damping[slot] = rule.damping;
    particles.radius[slot] = rule.radius;
    particles.group[slot] = rule.type;
    this.#own(slot, world.generationAt(slot));
  }

  #own(slot: number, generation: number): void {
    if (slot >= this.#owned.length) {
      const owned = new Uint32Array(Math.max(slot + 1, this.#owned.length * 2));
      owned.set(this.#owned);
      this.#owned = owned;
    }
    this.#owned[slot] = generation + 1;
  }

  #known(): string {
    return [...this.#rules.keys()].join(', ');
  }
}

function checkedRules(rules: readonly FireworkRule[]): ReadonlyMap<number, Required<FireworkRule>> {
  if (!Array.isArray(rules) || rules.length === 0) {
    throw wrong('Fireworks', 'rules must be a list of at least one rule', rules);
  }
  const byType = new Map<number, Required<FireworkRule>>();
  for (const rule of rules) {
    const checked = checkedRule(rule);
    if (byType.has(rule.type)) throw new RangeError(`Fireworks: each type has one rule; type ${rule.type} has two.`);
    byType.set(rule.type, checked);
  }
  for (const rule of byType.values()) {
    for (const { type } of rule.payloads) {
      if (!byType.has(type)) {
        throw new RangeError(
          `Fireworks: each payload's type must have a rule; type ${rule.type} bursts into ${type}, without one.`,
        );
      }
    }
    requireEnding(byType, rule.type, []);
  }
  return byType;
}

function checkedRule(rule: FireworkRule): Required<FireworkRule> {
  requireOptions('Fireworks', 'a rule', rule, '{ type: 1, minAge: 1, maxAge: 2, ... }');
  requireInteger('Fireworks', 'type', rule.type, 1, 65535);
  const where = `Fireworks, rule of type ${rule.type}`;
  const { acceleration = { x: 0, y: 0 }, mass = 1, radius = 0, payloads = [] } = rule;
  requirePositive(where, 'minAge', rule.minAge, 'seconds');
  requirePositive(where, 'maxAge', rule.maxAge, 'seconds');
  requireOrdered(where, 'age', rule.minAge, rule.maxAge, 's');
  requireVector(where, 'minVelocity', rule.minVelocity, 'metres per second');
  requireVector(where, 'maxVelocity', rule.maxVelocity, 'metres per second');
  requireOrdered(where, 'velocity.x', rule.minVelocity.x, rule.maxVelocity.x, 'm/s');
  requireOrdered(where, 'velocity.y', rule.minVelocity.y, rule.maxVelocity.y, 'm/s');
  requireShare(where, 'damping', rule.damping);
  requireVector(where, 'acceleration', acceleration, 'metres per second squared');
  requireMass(where, mass);
  requireNonNegative(where, 'radius', radius, 'metres');
  if (!Array.isArray(payloads)) {
    throw wrong(where, 'payloads must be a list such as [{ type: 2, count: 20 }]', payloads);
  }
  for (const payload of payloads) {
    requireOptions(where, 'a payload', payload, '{ type: 2, count: 20 }');
    requireInteger(where, 'count of a payload', payload.count, 1, 1_000_000);
  }
  return copied({ ...rule, acceleration, mass, radius, payloads });
}

/** A copy of its own: a rule that the game changes later changes nothing here. */
function copied(rule: Required<FireworkRule>): Required<FireworkRule> {
  return {
    ...rule,
    minVelocity: { ...rule.minVelocity },
    maxVelocity: { ...rule.maxVelocity },
    acceleration: { ...rule.acceleration },
    payloads: rule.payloads.map((payload) => ({ ...payload })),
  };
}

function requireEnding(
  rules: ReadonlyMap<number, Required<FireworkRule>>,
  type: number,
  above: readonly number[],
): void {
  const path = [...above, type];
  if (above.includes(type)) {
    throw new RangeError(`Fireworks: bursts must end; the types ${path.join(' > ')} go round for ever.`);
  }
  for (const payload of rules.get(type)?.payloads ?? []) requireEnding(rules, payload.type, path);
}
