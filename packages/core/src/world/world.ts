import { Bodies } from '../bodies/bodies.ts';
import type { Body } from '../bodies/body.ts';
import type { BodyPlan } from '../bodies/body-plan.ts';
import type { Shape } from '../collision/shape.ts';
import type { ContactArrays } from '../contacts/contact-arrays.ts';
import { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ContactGenerator } from '../contacts/contact-generator.ts';
import { ContactSources } from '../contacts/contact-sources.ts';
import type { Effect } from '../effects/effect.ts';
import type { ForceGenerator } from '../forces/force-generator.ts';
import { ForceRegistry } from '../forces/force-registry.ts';
import type { Link } from '../links/link.ts';
import {
  describe,
  requireFinite,
  requireFunction,
  requireInteger,
  requireNonNegative,
  requireOptions,
  requirePositiveOrInfinite,
  requireVector,
} from '../math/checks.ts';
import { Members } from '../math/members.ts';
import type { Vec2 } from '../math/vec2.ts';
import { requireMember } from '../particles/membership.ts';
import { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { checkParticleOptions, type ParticleOptions, writeParticle } from '../particles/particle-options.ts';
import type { ParticleSpawner } from '../particles/particle-spawner.ts';
import { ParticleStore } from '../particles/particle-store.ts';
import type { Resolver } from '../resolvers/resolver.ts';
import { substep } from '../resolvers/substep/substep.ts';
import { Checkpoint } from './checkpoint.ts';
import { ContactWatch } from './contact-watch.ts';
import { EventQueue, type WorldEvents } from './events.ts';
import { Expiry } from './expiry.ts';
import { nonFiniteError, requireLifetimes } from './finite.ts';
import { type Integrator, semiImplicitEuler } from './integrators.ts';
import { LinkBreaker } from './link-breaker.ts';
import type { Simulation } from './simulation.ts';

/** How a world is made. */
export interface WorldOptions {
  /** Acceleration of everything that has a finite mass. Unit: m/s². @default { x: 0, y: 0 } */
  gravity?: Readonly<Vec2>;
  /** How velocities and positions are brought on. @default semiImplicitEuler */
  integrator?: Integrator;
  /** How contacts and links are kept. @default substep() */
  resolver?: Resolver;
  /** The most contacts that a step may have; those left out are counted in `contacts.leftOut`. @default Infinity */
  contactLimit?: number;
  /** How many particles to make room for at once; more are always welcome. @default 64 */
  capacity?: number;
}

/** Particles, the forces on them, and the step that moves them on. */
export class World implements ParticleSpawner {
  readonly #store = new ParticleStore();
  readonly #forces = new ForceRegistry(this.#store);
  readonly #sources = new ContactSources(this.#store);
  readonly #effects = new Members<Effect>('an effect', 'afterStep(world, expired, dt)');
  readonly #bodies = new Bodies(this);
  readonly #events = new EventQueue();
  readonly #simulation: { -readonly [Part in keyof Simulation]: Simulation[Part] };
  readonly #resolver: Resolver;
  readonly #expiry = new Expiry();
  readonly #contactWatch = new ContactWatch();
  readonly #linkBreaker = new LinkBreaker();
  #stepCount = 0;
  #stepping = false;

  constructor(options: WorldOptions = {}) {
    requireOptions('World', 'options', options, '{ gravity: { x: 0, y: -9.81 } }');
    const { gravity = { x: 0, y: 0 }, integrator = semiImplicitEuler, resolver = substep() } = options;
    const { contactLimit = Infinity, capacity = 64 } = options;
    requireVector('World', 'gravity', gravity, 'metres per second squared');
    requireFunction('World', 'integrator', integrator, 'such as semiImplicitEuler');
    requireFunction('World', 'resolver.step', resolver?.step, 'of a resolver such as substep()');
    if (contactLimit !== Infinity) requireInteger('World', 'contactLimit', contactLimit, 0, 0x4000_0000);
    requireInteger('World', 'capacity', capacity, 0, 0x100_0000);
    this.#store.reserve(capacity + 1);
    this.#resolver = resolver;
    this.#simulation = {
      particles: this.#store,
      forces: this.#forces,
      sources: this.#sources,
      contacts: new ContactBuffer(contactLimit),
      integrate: integrator,
      gravity: Object.freeze({ x: gravity.x, y: gravity.y }),
      time: 0,
      before: new Checkpoint(),
    };
  }

  /** Acceleration of everything that has a finite mass. Unit: m/s². */
  get gravity(): Readonly<Vec2> {
    return this.#simulation.gravity;
  }
  set gravity(value: Readonly<Vec2>) {
    requireVector(this.#toChange('World.gravity'), 'gravity', value, 'metres per second squared');
    this.#simulation.gravity = Object.freeze({ x: value.x, y: value.y });
  }

  /** The sum of all steps so far. Unit: s. */
  get time(): number {
    return this.#simulation.time;
  }

  /** How many steps were taken. */
  get stepCount(): number {
    return this.#stepCount;
  }

  /** How many particles live in the world. */
  get particleCount(): number {
    return this.#store.living;
  }

  /** How many of them sleep: at rest, and left out of the step until something touches or changes them. */
  get sleepingCount(): number {
    return this.#store.sleeping;
  }

  /** The particles' numbers themselves, as typed arrays. */
  get particles(): ParticleArrays {
    return this.#store;
  }

  /** The force generators, in the order in which they run. */
  get forces(): readonly ForceGenerator[] {
    return this.#forces.list;
  }

  /** The links, without those that lost an end. */
  get links(): readonly Link[] {
    return this.#sources.links;
  }

  /** The static shapes. */
  get shapes(): readonly Shape[] {
    return this.#sources.shapes.list;
  }

  /** The bodies that have a particle left. */
  get bodies(): readonly Body[] {
    return this.#bodies.list;
  }

  /** The contacts of the last step, as typed arrays: to read. */
  get contacts(): Readonly<ContactArrays> {
    return this.#simulation.contacts;
  }

  /** Adds a particle. A number that makes no sense is a RangeError, and nothing is added. */
  addParticle(options: ParticleOptions): Particle {
    checkParticleOptions('World.addParticle', options);
    const slot = this.#store.add(options.x, options.y);
    writeParticle(this.#store, slot, options);
    return this.#store.handle(slot);
  }

  /** Takes a particle out of the world, and with it what hangs on it. */
  removeParticle(particle: Particle): void {
    requireMember('World.removeParticle', particle, this.#store);
    this.#store.remove(particle.slot);
  }

  /** The handle of the particle that lives in a slot. */
  particleAt(slot: number): Particle {
    if (!Number.isInteger(slot) || this.#store.alive[slot] !== 1) {
      throw new RangeError(`World.particleAt: slot must be one where a particle lives; got ${describe(slot)}.`);
    }
    return this.#store.handle(slot);
  }

  spawn(x: number, y: number, lifetime: number = Infinity): number {
    requireFinite('World.spawn', 'x', x, 'metres');
    requireFinite('World.spawn', 'y', y, 'metres');
    requirePositiveOrInfinite('World.spawn', 'lifetime', lifetime, 'seconds');
    const slot = this.#store.add(x, y);
    writeParticle(this.#store, slot, plain);
    this.#store.setLifetime(slot, lifetime);
    return slot;
  }

  generationAt(slot: number): number {
    return this.#store.generation[slot];
  }

  /**
   * Has a force act on particles from the next step on: on those given, or without a list on all, those to come included.
   * A generator that is in the world already gets the particles on top of those it has.
   * @returns The generator.
   */
  addForce<T extends ForceGenerator>(generator: T, particles?: Iterable<Particle>): T {
    this.#forces.add(this.#store.betweenSteps('World.addForce'), generator, particles);
    return generator;
  }

  /** Frees particles of a force, or, without a list, takes the force out of the world. */
  removeForce(generator: ForceGenerator, particles?: Iterable<Particle>): void {
    this.#forces.remove(this.#toChange('World.removeForce'), generator, particles);
  }

  /** Joins two ends from the next step on. @returns The link. */
  addLink<T extends Link>(link: T): T {
    const where = this.#store.betweenSteps('World.addLink');
    for (const end of [link?.a, link?.b]) {
      if (end instanceof Particle) requireMember(where, end, this.#store);
    }
    this.#sources.addLink(where, link);
    wakeEnds(link);
    return link;
  }

  /** Takes a link out of the world. */
  removeLink(link: Link): void {
    this.#sources.removeLink(this.#store.betweenSteps('World.removeLink'), link);
    wakeEnds(link);
  }

  /** Builds a body, such as `box({ … })`, whole or, where it cannot be, not at all. @returns The body. */
  addBody(plan: BodyPlan): Body {
    return this.#bodies.add(this.#store.betweenSteps('World.addBody'), plan);
  }

  /** Takes a body out of the world: its particles and all that hangs on them. */
  removeBody(body: Body): void {
    this.#bodies.remove(this.#store.betweenSteps('World.removeBody'), body);
  }

  /** Adds immovable scenery. @returns The shape. */
  addShape<T extends Shape>(shape: T): T {
    this.#sources.addShape(this.#toChange('World.addShape'), shape);
    return shape;
  }

  /** Takes scenery out of the world. */
  removeShape(shape: Shape): void {
    this.#sources.shapes.remove(this.#toChange('World.removeShape'), shape);
  }

  /** Adds something that finds contacts, such as `DiscContacts`. @returns The generator. */
  addContactGenerator<T extends ContactGenerator>(generator: T): T {
    this.#sources.addGenerator(this.#toChange('World.addContactGenerator'), generator);
    return generator;
  }

  /** Takes a contact generator out of the world. */
  removeContactGenerator(generator: ContactGenerator): void {
    this.#sources.generators.remove(this.#toChange('World.removeContactGenerator'), generator);
  }

  /** Adds something that makes particles as time goes by. @returns The effect. */
  addEffect<T extends Effect>(effect: T): T {
    this.#effects.check(this.#store.betweenSteps('World.addEffect'), effect);
    effect.attach?.(this);
    this.#effects.add('World.addEffect', effect);
    return effect;
  }

  /** Takes an effect out of the world; the particles that it made stay. */
  removeEffect(effect: Effect): void {
    this.#effects.remove(this.#store.betweenSteps('World.removeEffect'), effect);
    effect.detach?.();
  }

  /**
   * Has a function called after each step for all that happened in it: first the contacts that began, then those that
   * ended, the links that broke, the particles that expired. The world can be changed from there.
   * @returns A function that ends it.
   */
  on<Name extends keyof WorldEvents>(name: Name, listener: (event: WorldEvents[Name]) => void): () => void {
    return this.#events.on(name, listener);
  }

  /** Wakes every particle: to be called when numbers of sleeping ones were written straight into `particles`. */
  wake(): void {
    this.#store.wakeAll();
  }

  /**
   * Moves the world on. A step that fails, by a number that is no longer finite or an error in a game's own force, link or
   * contact generator, is undone before the error is thrown.
   * @param dt - Duration, 0 or more; 0 changes nothing. The same each time is best: see `FixedTimestep`. Unit: s.
   */
  step(dt: number): void {
    const where = this.#store.betweenSteps('World.step');
    if (this.#stepping) throw new Error(`${where}: a step must end before the next; an effect or a listener took one.`);
    requireNonNegative(where, 'dt', dt, 'seconds', 'Time runs forward only.');
    if (dt === 0) return;
    if (!this.#resolver.isAtRest?.(this.#simulation)) {
      this.#simulation.before.save(this.#store);
      this.#resolve(dt);
      this.#simulation.before.commit(this.#store);
    }
    this.#simulation.time += dt;
    this.#stepCount++;
    this.#expiry.age(this.#store, dt);
    this.#tellOthers(dt);
  }

  #resolve(dt: number): void {
    const store = this.#store;
    store.locked = true;
    try {
      requireLifetimes(store);
      if (!this.#resolver.step(this.#simulation, dt)) throw nonFiniteError(this.#simulation, dt);
    } catch (error) {
      this.#simulation.before.restore(store);
      throw error;
    } finally {
      store.locked = false;
    }
  }

  /** Events and effects, which may change the world. Whatever they throw, what expired is removed. */
  #tellOthers(dt: number): void {
    const { contacts } = this.#simulation;
    this.#stepping = true;
    try {
      this.#contactWatch.compare(contacts, this.#sources, this.#store, this.#events);
      this.#linkBreaker.breakLinks(this.#simulation, this.#resolver, this.#events, dt);
      this.#expiry.note(this.#store, this.#events);
      this.#runEffects(dt);
      this.#events.tell();
    } finally {
      this.#expiry.removeFrom(this.#store);
      this.#stepping = false;
    }
  }

  #runEffects(dt: number): void {
    const effects = this.#effects.list;
    const { length } = effects; // one that is added meanwhile runs from the next step on
    for (let e = 0; e < length; e++) {
      if (this.#effects.has(effects[e])) effects[e].afterStep(this, this.#expiry, dt);
    }
  }

  /** For what may move anything: all that sleeps wakes. */
  #toChange(where: string): string {
    this.#store.betweenSteps(where);
    this.#store.wakeAll();
    return where;
  }
}

/** A particle of which nothing was told. */
const plain = {};

/** What hangs on a link that comes or goes wakes. */
function wakeEnds({ a, b }: Link): void {
  for (const end of [a, b]) if (end instanceof Particle && end.alive) end.wake();
}
