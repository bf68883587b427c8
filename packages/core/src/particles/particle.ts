import {
  requireFinite,
  requireFlag,
  requireInteger,
  requireMass,
  requireNonNegative,
  requirePositiveOrInfinite,
  requireShare,
} from '../math/checks.ts';
import type { ParticleSlots } from './particle-slots.ts';

/**
 * A handle on one particle of a world: it reads and writes the particle's numbers where they are stored. There is one
 * handle a particle, so handles can be compared and be keys of a map. Made by `World.addParticle`.
 *
 * Using the handle of a particle that was removed is an error; `alive` tells.
 */
export class Particle {
  /** Where the particle's numbers stand in `world.particles`. */
  readonly slot: number;
  readonly #slots: ParticleSlots;
  readonly #generation: number;

  /** @internal */
  constructor(slots: ParticleSlots, slot: number) {
    this.slot = slot;
    this.#slots = slots;
    this.#generation = slots.generation[slot];
  }

  /** Whether the particle is still in its world. */
  get alive(): boolean {
    return this.#slots.generation[this.slot] === this.#generation;
  }

  /** Horizontal position. Unit: m. */
  get x(): number {
    return this.#of('x').x[this.slot];
  }
  set x(value: number) {
    requireFinite('Particle.x', 'x', value, 'metres');
    this.#change('x').x[this.slot] = value;
  }

  /** Vertical position, up. Unit: m. */
  get y(): number {
    return this.#of('y').y[this.slot];
  }
  set y(value: number) {
    requireFinite('Particle.y', 'y', value, 'metres');
    this.#change('y').y[this.slot] = value;
  }

  /** Horizontal velocity. Unit: m/s. */
  get vx(): number {
    return this.#of('vx').vx[this.slot];
  }
  set vx(value: number) {
    requireFinite('Particle.vx', 'vx', value, 'metres per second');
    this.#change('vx').vx[this.slot] = value;
  }

  /** Vertical velocity. Unit: m/s. */
  get vy(): number {
    return this.#of('vy').vy[this.slot];
  }
  set vy(value: number) {
    requireFinite('Particle.vy', 'vy', value, 'metres per second');
    this.#change('vy').vy[this.slot] = value;
  }

  /** Constant horizontal acceleration, on top of the world's gravity. Unit: m/s². */
  get ax(): number {
    return this.#of('ax').ax[this.slot];
  }
  set ax(value: number) {
    requireFinite('Particle.ax', 'ax', value, 'metres per second squared');
    this.#change('ax').ax[this.slot] = value;
  }

  /** Constant vertical acceleration, on top of the world's gravity. Unit: m/s². */
  get ay(): number {
    return this.#of('ay').ay[this.slot];
  }
  set ay(value: number) {
    requireFinite('Particle.ay', 'ay', value, 'metres per second squared');
    this.#change('ay').ay[this.slot] = value;
  }

  /** Mass, positive; `Infinity` pins the particle: forces and impulses do not move it. Unit: kg. */
  get mass(): number {
    return this.#of('mass').mass[this.slot];
  }
  set mass(value: number) {
    requireMass('Particle.mass', value);
    const slots = this.#change('mass');
    slots.mass[this.slot] = value;
    slots.inverseMass[this.slot] = 1 / value;
  }

  /** One over the mass; 0 for a pinned particle. Set `mass` to change it. Unit: 1/kg. */
  get inverseMass(): number {
    return this.#of('inverseMass').inverseMass[this.slot];
  }

  /** Share of the velocity kept per second: 1 keeps everything, 0 stops the particle at once. */
  get damping(): number {
    return this.#of('damping').damping[this.slot];
  }
  set damping(value: number) {
    requireShare('Particle.damping', 'damping', value, '1 keeps all of the velocity.');
    this.#change('damping').damping[this.slot] = value;
  }

  /** Radius of the disc; 0 is a point. Unit: m. */
  get radius(): number {
    return this.#of('radius').radius[this.slot];
  }
  set radius(value: number) {
    requireNonNegative('Particle.radius', 'radius', value, 'metres');
    this.#change('radius').radius[this.slot] = value;
  }

  /** Share of the closing speed that a hit gives back, 0 to 1; of two that hit the greater counts. */
  get restitution(): number {
    return this.#of('restitution').restitution[this.slot];
  }
  set restitution(value: number) {
    requireShare('Particle.restitution', 'restitution', value);
    this.#change('restitution').restitution[this.slot] = value;
  }

  /** Coefficient of friction, static and kinetic, 0 or more; of two that touch the geometric mean counts. */
  get friction(): number {
    return this.#of('friction').friction[this.slot];
  }
  set friction(value: number) {
    requireNonNegative('Particle.friction', 'friction', value, '');
    this.#change('friction').friction[this.slot] = value;
  }

  /** Time left until the world removes the particle; `Infinity` for ever. Unit: s. */
  get lifetime(): number {
    return this.#of('lifetime').lifetime[this.slot];
  }
  set lifetime(value: number) {
    requirePositiveOrInfinite('Particle.lifetime', 'lifetime', value, 'seconds', 'Use remove() to end it now.');
    this.#of('lifetime').setLifetime(this.slot, value);
  }

  /** A number of the game's own, 0 to 65535, which styles choose by. */
  get group(): number {
    return this.#of('group').group[this.slot];
  }
  set group(value: number) {
    requireInteger('Particle.group', 'group', value, 0, 65535);
    this.#change('group').group[this.slot] = value;
  }

  /** What it is: bits, 0 to 0xffff. Two touch if each has a bit of the other's category in its mask. */
  get category(): number {
    return this.#of('category').category[this.slot];
  }
  set category(value: number) {
    requireInteger('Particle.category', 'category', value, 0, 0xffff);
    this.#change('category').category[this.slot] = value;
  }

  /** What it touches: bits, 0 to 0xffff. */
  get mask(): number {
    return this.#of('mask').mask[this.slot];
  }
  set mask(value: number) {
    requireInteger('Particle.mask', 'mask', value, 0, 0xffff);
    this.#change('mask').mask[this.slot] = value;
  }

  /** Whether it only tells what touches it, and neither pushes nor is pushed. */
  get sensor(): boolean {
    return this.#of('sensor').sensor[this.slot] === 1;
  }
  set sensor(value: boolean) {
    requireFlag('Particle.sensor', 'sensor', value);
    this.#change('sensor').sensor[this.slot] = value ? 1 : 0;
  }

  /** Whether it sleeps: it rests, and the step leaves it out until something touches it, changes it or `wake` is called. */
  get asleep(): boolean {
    return this.#of('asleep').asleep[this.slot] === 1;
  }

  /** Wakes it, and with it all that it rests on or that rests on it. */
  wake(): void {
    this.#change('wake');
  }

  /** Adds a force to the accumulator: it acts during the next step alone. Unit: N. */
  applyForce(fx: number, fy: number): void {
    requireFinite('Particle.applyForce', 'fx', fx, 'newtons');
    requireFinite('Particle.applyForce', 'fy', fy, 'newtons');
    const slots = this.#change('applyForce');
    slots.fx[this.slot] += fx;
    slots.fy[this.slot] += fy;
  }

  /** Changes the velocity at once, by impulse over mass; a pinned particle stays. Unit: N·s. */
  applyImpulse(ix: number, iy: number): void {
    requireFinite('Particle.applyImpulse', 'ix', ix, 'newton-seconds');
    requireFinite('Particle.applyImpulse', 'iy', iy, 'newton-seconds');
    const slots = this.#change('applyImpulse');
    slots.vx[this.slot] += ix * slots.inverseMass[this.slot];
    slots.vy[this.slot] += iy * slots.inverseMass[this.slot];
  }

  /** Takes the particle, and what hangs on it, out of its world. */
  remove(): void {
    this.#of('remove').remove(this.slot);
  }

  /** Whether the particle lives in the world that these arrays belong to. */
  isIn(particles: object): boolean {
    return this.#slots === particles && this.alive;
  }

  /** The slots, to write to: whoever is written to wakes. */
  #change(name: string): ParticleSlots {
    const slots = this.#of(name);
    slots.wake(this.slot);
    return slots;
  }

  #of(member: string): ParticleSlots {
    if (this.#slots.generation[this.slot] !== this.#generation) throwRemoved(member, this.slot);
    return this.#slots;
  }
}

function throwRemoved(member: string, slot: number): never {
  throw new Error(
    `Particle.${member}: the particle must be in its world; the one of slot ${slot} was removed. ` +
      'Ask particle.alive before using a handle that may be out of date.',
  );
}
