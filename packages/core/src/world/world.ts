import type { Effect } from '../effects/effect.ts';
import type { ForceGenerator } from '../forces/force-generator.ts';
import { ForceRegistry } from '../forces/force-registry.ts';
import {
  describe,
  requireFinite,
  requireInteger,
  requireNonNegative,
  requirePositiveOrInfinite,
  requireVector,
} from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ParticleOptions } from '../particles/particle-options.ts';
import { checkParticleOptions, writeParticle } from '../particles/particle-options.ts';
import type { ParticleSpawner } from '../particles/particle-spawner.ts';
import { ParticleStore } from '../particles/particle-store.ts';
import { Checkpoint } from './checkpoint.ts';
import { Expiry } from './expiry.ts';
import { nonFiniteError, nonFiniteForceError } from './finite.ts';
import { type Integrator, semiImplicitEuler } from './integrators.ts';

/** How a world is made. */
export interface WorldOptions {
  /** Acceleration of everything that has a finite mass. Unit: m/s². @default { x: 0, y: 0 } */
  gravity?: Readonly<Vec2>;
  /** How velocities and positions are brought on. @default semiImplicitEuler */
  integrator?: Integrator;
  /** How many particles to make room for at once; more are always welcome. @default 64 */
  capacity?: number;
}

/** Particles, the forces on them, and the step that moves them on. */
export class World implements ParticleSpawner {
  readonly #store = new ParticleStore();
  readonly #forces = new ForceRegistry(this.#store);
  readonly #checkpoint = new Checkpoint();
  readonly #expiry = new Expiry();
  readonly #effects: Effect[] = [];
  readonly #integrate: Integrator;
  #gravity: Readonly<Vec2>;
  #time = 0;
  #stepCount = 0;

  constructor({ gravity = { x: 0, y: 0 }, integrator = semiImplicitEuler, capacity = 64 }: WorldOptions = {}) {
    requireVector('World', 'gravity', gravity, 'metres per second squared');
    requireInteger('World', 'capacity', capacity, 0, 0x100_0000);
    if (typeof integrator !== 'function') {
      throw new TypeError(
        `World: integrator must be an integrator such as semiImplicitEuler; got ${describe(integrator)}.`,
      );
    }
    this.#gravity = Object.freeze({ x: gravity.x, y: gravity.y });
    this.#integrate = integrator;
    this.#store.reserve(capacity);
  }

  /** Acceleration of everything that has a finite mass. Unit: m/s². */
  get gravity(): Readonly<Vec2> {
    return this.#gravity;
  }
  set gravity(value: Readonly<Vec2>) {
    requireVector('World.gravity', 'gravity', value, 'metres per second squared');
    this.#gravity = Object.freeze({ x: value.x, y: value.y });
  }

  /** The sum of all steps so far. Unit: s. */
  get time(): number {
    return this.#time;
  }

  /** How many steps were taken. */
  get stepCount(): number {
    return this.#stepCount;
  }

  /** How many particles live in the world. */
  get particleCount(): number {
    return this.#store.living;
  }

  /** The particles' numbers themselves, as typed arrays. */
  get particles(): ParticleArrays {
    return this.#store;
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
    this.#requireMember('World.removeParticle', particle);
    this.#store.remove(particle.slot);
  }

  /** The handle of the particle that lives in a slot. */
  particleAt(slot: number): Particle {
    if (this.#store.alive[slot] !== 1) {
      throw new RangeError(`World.particleAt: slot must be one where a particle lives; got ${describe(slot)}.`);
    }
    return this.#store.handle(slot);
  }

  spawn(x: number, y: number, lifetime: number = Infinity): number {
    requireFinite('World.spawn', 'x', x, 'metres');
    requireFinite('World.spawn', 'y', y, 'metres');
    requirePositiveOrInfinite('World.spawn', 'lifetime', lifetime, 'seconds');
    const slot = this.#store.add(x, y);
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
    this.#requireBetweenSteps('World.addForce');
    if (typeof generator?.apply !== 'function') {
      throw new TypeError(
        `World.addForce: a force generator must have a method apply(particles, targets, dt); got ${describe(generator)}. ` +
          'Wrap a function of one particle in forEachParticle.',
      );
    }
    this.#forces.add(generator, particles && this.#requireMembers('World.addForce', particles));
    return generator;
  }

  /** Frees particles of a force, or, without a list, takes the force out of the world. */
  removeForce(generator: ForceGenerator, particles?: Iterable<Particle>): void {
    this.#requireBetweenSteps('World.removeForce');
    if (!this.#forces.has(generator)) {
      throw new Error(`World.removeForce: the force must be in the world; ${describe(generator)} is not.`);
    }
    if (particles !== undefined && this.#forces.actsOnAll(generator)) {
      throw new Error(
        'World.removeForce: the force acts on all particles; single ones cannot be freed of it. ' +
          'Add it with a list of particles instead.',
      );
    }
    this.#forces.remove(generator, particles && [...particles]);
  }

  /** Adds something that makes particles as time goes by. @returns The effect. */
  addEffect<T extends Effect>(effect: T): T {
    this.#requireBetweenSteps('World.addEffect');
    if (typeof effect?.afterStep !== 'function') {
      throw new TypeError(
        `World.addEffect: an effect must have a method afterStep(world, expired, dt); got ${describe(effect)}.`,
      );
    }
    if (this.#effects.includes(effect)) throw new Error('World.addEffect: the effect is in the world already.');
    effect.attach?.(this);
    this.#effects.push(effect);
    return effect;
  }

  /** Takes an effect out of the world; the particles that it made stay. */
  removeEffect(effect: Effect): void {
    this.#requireBetweenSteps('World.removeEffect');
    const index = this.#effects.indexOf(effect);
    if (index < 0) throw new Error(`World.removeEffect: the effect must be in the world; ${describe(effect)} is not.`);
    this.#effects.splice(index, 1);
    effect.detach?.();
  }

  /**
   * Moves the world on. A step that fails, by a number that is no longer finite or an error in a game's own force, is undone
   * before the error is thrown.
   * @param dt - Duration, 0 or more; 0 changes nothing. The same each time is best: see `FixedTimestep`. Unit: s.
   */
  step(dt: number): void {
    this.#requireBetweenSteps('World.step');
    requireNonNegative('World.step', 'dt', dt, 'seconds', 'Time runs forward only.');
    if (dt === 0) return;
    this.#checkpoint.save(this.#store);
    this.#move(dt);
    this.#checkpoint.commit(this.#store);
    this.#time += dt;
    this.#stepCount++;
    this.#expiry.age(this.#store, dt);
    this.#runEffects(dt);
    this.#expiry.removeFrom(this.#store);
  }

  #move(dt: number): void {
    const store = this.#store;
    store.locked = true;
    try {
      this.#forces.apply(dt);
      const finite = this.#integrate(store, this.#gravity, dt);
      if (!finite) throw this.#nonFiniteError(dt);
    } catch (error) {
      this.#checkpoint.restore(store);
      throw error;
    } finally {
      store.locked = false;
    }
  }

  #nonFiniteError(dt: number): Error {
    const error = nonFiniteError(this.#store);
    this.#checkpoint.restore(this.#store);
    return nonFiniteForceError(this.#forces, dt) ?? error;
  }

  #runEffects(dt: number): void {
    const effects = this.#effects;
    for (let e = 0; e < effects.length; e++) effects[e].afterStep(this, this.#expiry, dt);
  }

  #requireBetweenSteps(where: string): void {
    if (this.#store.locked) {
      throw new Error(`${where}: this must be called between steps; a force generator called it within one.`);
    }
  }

  #requireMember(where: string, particle: Particle): void {
    if (!(particle instanceof Particle)) {
      throw new TypeError(`${where}: a particle must be what World.addParticle returned; got ${describe(particle)}.`);
    }
    if (!particle.isIn(this.#store)) {
      const why = particle.alive ? 'it lives in another world' : 'it was removed';
      throw new Error(`${where}: the particle must be in this world; ${why}.`);
    }
  }

  #requireMembers(where: string, particles: Iterable<Particle>): Particle[] {
    if (typeof particles?.[Symbol.iterator] !== 'function') {
      throw new TypeError(
        `${where}: particles must be a list of particles; got ${describe(particles)}. Put it in [ ].`,
      );
    }
    const members = [...particles];
    for (const particle of members) this.#requireMember(where, particle);
    return members;
  }
}
