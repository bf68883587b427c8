import { growColumns } from '../math/columns.ts';
import { DampingPowers } from './damping-powers.ts';
import type { MotionArrays } from './motion-arrays.ts';
import { Particle } from './particle.ts';
import type { ParticleSlots } from './particle-slots.ts';

const FIRST_CAPACITY = 64;

const numbers = (): Float64Array => new Float64Array(FIRST_CAPACITY);

/**
 * The particles of one world as typed arrays. A slot is stable for the life of its particle; freed slots are used again,
 * the last freed first, under a new generation. Arrays double when they are full. There is always a slot after the last one: it
 * is at rest at the origin and of infinite mass, as scenery is.
 */
export class ParticleStore implements ParticleSlots, MotionArrays {
  count = 0;
  /** How many particles live. */
  living = 0;
  /** How many particles were removed so far: lists of what hangs on particles compare it. */
  removals = 0;
  /** Grows with each particle added or removed: lists of slots compare it to know when they are out of date. */
  version = 0;
  /** Whether some particle may have a finite lifetime. */
  mortal = false;
  /** How many particles sleep; and a number that grows with each that falls asleep or wakes. */
  sleeping = 0;
  sleepVersion = 0;
  /** Grows with whatever may wake a particle: a world all of which sleeps need not be stepped until it does. */
  changes = 0;
  /** While a step runs no particle may come or go. */
  locked = false;

  alive: Uint8Array = new Uint8Array(FIRST_CAPACITY);
  generation: Uint32Array = new Uint32Array(FIRST_CAPACITY);
  x: Float64Array = numbers();
  y: Float64Array = numbers();
  previousX: Float64Array = numbers();
  previousY: Float64Array = numbers();
  vx: Float64Array = numbers();
  vy: Float64Array = numbers();
  fx: Float64Array = numbers();
  fy: Float64Array = numbers();
  mass: Float64Array = numbers();
  inverseMass: Float64Array = numbers();
  radius: Float64Array = numbers();
  restitution: Float64Array = numbers();
  friction: Float64Array = numbers();
  lifetime: Float64Array = numbers();
  group: Uint16Array = new Uint16Array(FIRST_CAPACITY);
  category: Uint16Array = new Uint16Array(FIRST_CAPACITY);
  mask: Uint16Array = new Uint16Array(FIRST_CAPACITY);
  sensor: Uint8Array = new Uint8Array(FIRST_CAPACITY);
  asleep: Uint8Array = new Uint8Array(FIRST_CAPACITY);

  readonly dampingPowers: DampingPowers = new DampingPowers();
  accelerated = false;
  damped = false;
  readonly #own = { ax: numbers(), ay: numbers(), damping: numbers(), free: new Int32Array(FIRST_CAPACITY) };

  readonly #handles: (Particle | undefined)[] = [];
  #freeCount = 0;

  get ax(): Float64Array {
    this.accelerated = true;
    return this.#own.ax;
  }

  get ay(): Float64Array {
    this.accelerated = true;
    return this.#own.ay;
  }

  get damping(): Float64Array {
    this.damped = true;
    return this.#own.damping;
  }

  /** How many particles fit before the arrays grow. */
  get capacity(): number {
    return this.alive.length;
  }

  /** A new particle at a place; returns its slot. All else is for `writeParticle` to say. */
  add(x: number, y: number): number {
    this.betweenSteps('World.addParticle');
    const slot = this.#freeCount > 0 ? this.#own.free[--this.#freeCount] : this.count++;
    if (this.count === this.capacity) this.reserve(this.capacity * 2);
    this.living++;
    this.changes++;
    this.version++;
    this.alive[slot] = 1;
    this.x[slot] = this.previousX[slot] = x;
    this.y[slot] = this.previousY[slot] = y;
    this.fx[slot] = this.fy[slot] = 0;
    this.#own.ax[slot] = this.#own.ay[slot] = 0;
    this.#own.damping[slot] = 1;
    this.asleep[slot] = 0;
    return slot;
  }

  /** Frees a slot that is alive. What stays in it cannot move and is finite. */
  remove(slot: number): void {
    this.betweenSteps('World.removeParticle');
    this.wake(slot);
    this.living--;
    this.removals++;
    this.version++;
    this.generation[slot]++;
    this.#handles[slot] = undefined;
    this.alive[slot] = 0;
    this.x[slot] = this.previousX[slot] = 0;
    this.y[slot] = this.previousY[slot] = 0;
    this.vx[slot] = this.vy[slot] = 0;
    this.fx[slot] = this.fy[slot] = 0;
    this.mass[slot] = Infinity;
    this.inverseMass[slot] = 0;
    this.radius[slot] = 0;
    this.lifetime[slot] = Infinity;
    this.asleep[slot] = 0;
    this.#own.free[this.#freeCount++] = slot;
    if (this.living === 0) this.count = this.#freeCount = 0;
  }

  /** Puts a particle to sleep: it keeps its place as if its mass were infinite. */
  sleep(slot: number): void {
    this.asleep[slot] = 1;
    this.inverseMass[slot] = 0;
    this.vx[slot] = this.vy[slot] = 0;
    this.sleeping++;
    this.sleepVersion++;
  }

  wake(slot: number): void {
    this.changes++;
    if (this.asleep[slot] === 0) return;
    this.asleep[slot] = 0;
    this.inverseMass[slot] = 1 / this.mass[slot];
    this.sleeping--;
    this.sleepVersion++;
  }

  /** Wakes every particle. */
  wakeAll(): void {
    this.changes++;
    for (let slot = 0; slot < this.count && this.sleeping > 0; slot++) this.wake(slot);
  }

  setLifetime(slot: number, seconds: number): void {
    this.lifetime[slot] = seconds;
    if (seconds < Infinity) this.mortal = true;
  }

  /** The handle of the particle that lives in a slot: the same object each time. */
  handle(slot: number): Particle {
    this.#handles[slot] ??= new Particle(this, slot);
    return this.#handles[slot];
  }

  /** Makes room for `capacity` particles in all. */
  reserve(capacity: number): void {
    if (capacity <= this.capacity) return;
    growColumns(this, capacity);
    growColumns(this.#own, capacity);
  }

  /** Throws within a step. Returns `where`, for what else may be wrong there. */
  betweenSteps(where: string): string {
    if (!this.locked) return where;
    throw new Error(
      `${where}: this must be called between steps; a force generator called it within one. ` +
        'Note it down and do it after world.step, or in an effect.',
    );
  }
}
