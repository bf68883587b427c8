import { DampingPowers } from './damping-powers.ts';
import type { MotionArrays } from './motion-arrays.ts';
import { Particle } from './particle.ts';
import type { ParticleSlots } from './particle-slots.ts';

const FIRST_CAPACITY = 64;

/**
 * The particles of one world as typed arrays. A slot is stable for the life of its particle; freed slots are used again,
 * the last freed first, under a new generation. Arrays double when they are full.
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
  /** While a step runs no particle may come or go. */
  locked = false;

  alive: Uint8Array = new Uint8Array(FIRST_CAPACITY);
  generation: Uint32Array = new Uint32Array(FIRST_CAPACITY);
  x: Float64Array = new Float64Array(FIRST_CAPACITY);
  y: Float64Array = new Float64Array(FIRST_CAPACITY);
  previousX: Float64Array = new Float64Array(FIRST_CAPACITY);
  previousY: Float64Array = new Float64Array(FIRST_CAPACITY);
  vx: Float64Array = new Float64Array(FIRST_CAPACITY);
  vy: Float64Array = new Float64Array(FIRST_CAPACITY);
  fx: Float64Array = new Float64Array(FIRST_CAPACITY);
  fy: Float64Array = new Float64Array(FIRST_CAPACITY);
  mass: Float64Array = new Float64Array(FIRST_CAPACITY);
  inverseMass: Float64Array = new Float64Array(FIRST_CAPACITY);
  radius: Float64Array = new Float64Array(FIRST_CAPACITY);
  restitution: Float64Array = new Float64Array(FIRST_CAPACITY);
  friction: Float64Array = new Float64Array(FIRST_CAPACITY);
  lifetime: Float64Array = new Float64Array(FIRST_CAPACITY);
  group: Uint16Array = new Uint16Array(FIRST_CAPACITY);
  asleep: Uint8Array = new Uint8Array(FIRST_CAPACITY);

  readonly dampingPowers: DampingPowers = new DampingPowers();
  accelerated = false;
  damped = false;
  #ax: Float64Array = new Float64Array(FIRST_CAPACITY);
  #ay: Float64Array = new Float64Array(FIRST_CAPACITY);
  #damping: Float64Array = new Float64Array(FIRST_CAPACITY);

  readonly #handles: (Particle | undefined)[] = [];
  #free: Int32Array = new Int32Array(FIRST_CAPACITY);
  #freeCount = 0;

  get ax(): Float64Array {
    this.accelerated = true;
    return this.#ax;
  }

  get ay(): Float64Array {
    this.accelerated = true;
    return this.#ay;
  }

  get damping(): Float64Array {
    this.damped = true;
    return this.#damping;
  }

  /** How many particles fit before the arrays grow. */
  get capacity(): number {
    return this.alive.length;
  }

  /** A new particle at a place, at rest, with the default of everything else; returns its slot. */
  add(x: number, y: number): number {
    this.#requireUnlocked('added');
    const slot = this.#freeCount > 0 ? this.#free[--this.#freeCount] : this.count;
    if (slot === this.count) {
      if (slot === this.capacity) this.#grow(this.capacity * 2);
      this.count++;
    }
    this.living++;
    this.version++;
    this.alive[slot] = 1;
    this.x[slot] = this.previousX[slot] = x;
    this.y[slot] = this.previousY[slot] = y;
    this.vx[slot] = this.vy[slot] = 0;
    this.fx[slot] = this.fy[slot] = 0;
    this.#ax[slot] = this.#ay[slot] = 0;
    this.mass[slot] = this.inverseMass[slot] = 1;
    this.#damping[slot] = 1;
    this.radius[slot] = 0;
    this.restitution[slot] = 0;
    this.friction[slot] = 0;
    this.lifetime[slot] = Infinity;
    this.group[slot] = 0;
    this.asleep[slot] = 0;
    return slot;
  }

  /** Frees a slot that is alive. What stays in it cannot move and is finite. */
  remove(slot: number): void {
    this.#requireUnlocked('removed');
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
    this.#free[this.#freeCount++] = slot;
    if (this.living === 0) this.count = this.#freeCount = 0;
  }

  setLifetime(slot: number, seconds: number): void {
    this.lifetime[slot] = seconds;
    if (seconds < Infinity) this.mortal = true;
  }

  /** The handle of the particle that lives in a slot: the same object each time. */
  handle(slot: number): Particle {
    let handle = this.#handles[slot];
    if (handle === undefined) {
      handle = new Particle(this, slot);
      this.#handles[slot] = handle;
    }
    return handle;
  }

  /** Makes room for `capacity` particles in all. */
  reserve(capacity: number): void {
    if (capacity > this.capacity) this.#grow(capacity);
  }

  #requireUnlocked(verb: string): void {
    if (this.locked) {
      throw new Error(
        `World.step: particles can be ${verb} between steps only; a force generator asked for it within one. ` +
          'Note it down and do it after world.step, or in an effect.',
      );
    }
  }

  #grow(capacity: number): void {
    this.alive = grown(this.alive, new Uint8Array(capacity));
    this.generation = grown(this.generation, new Uint32Array(capacity));
    this.x = grown(this.x, new Float64Array(capacity));
    this.y = grown(this.y, new Float64Array(capacity));
    this.previousX = grown(this.previousX, new Float64Array(capacity));
    this.previousY = grown(this.previousY, new Float64Array(capacity));
    this.vx = grown(this.vx, new Float64Array(capacity));
    this.vy = grown(this.vy, new Float64Array(capacity));
    this.fx = grown(this.fx, new Float64Array(capacity));
    this.fy = grown(this.fy, new Float64Array(capacity));
    this.#ax = grown(this.#ax, new Float64Array(capacity));
    this.#ay = grown(this.#ay, new Float64Array(capacity));
    this.mass = grown(this.mass, new Float64Array(capacity));
    this.inverseMass = grown(this.inverseMass, new Float64Array(capacity));
    this.#damping = grown(this.#damping, new Float64Array(capacity));
    this.radius = grown(this.radius, new Float64Array(capacity));
    this.restitution = grown(this.restitution, new Float64Array(capacity));
    this.friction = grown(this.friction, new Float64Array(capacity));
    this.lifetime = grown(this.lifetime, new Float64Array(capacity));
    this.group = grown(this.group, new Uint16Array(capacity));
    this.asleep = grown(this.asleep, new Uint8Array(capacity));
    this.#free = grown(this.#free, new Int32Array(capacity));
  }
}

function grown<T extends { set(from: T): void }>(from: T, to: T): T {
  to.set(from);
  return to;
}
