import { describe } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';

/** What a game draws in place of the discs of particles of its choice. For authors of renderers. */
export class Bindings<Drawing> {
  readonly #where: string;
  readonly #drawings = new Map<Particle, Drawing>();
  readonly #release: (drawing: Drawing) => void;
  #bound = new Uint8Array(0);

  /** `where` names the renderer in errors; `release` hears of each drawing that is bound no longer. */
  constructor(where: string, release: (drawing: Drawing) => void = () => {}) {
    this.#where = where;
    this.#release = release;
  }

  /** 1 for each slot whose disc is replaced, as of the last `prune`. */
  get bound(): Uint8Array {
    return this.#bound;
  }

  /** Binds a drawing to a living particle, in place of the one that it had. */
  bind(particle: Particle, drawing: Drawing): void {
    if (typeof particle?.isIn !== 'function') {
      throw new TypeError(`${this.#where}.bind: the first argument must be a particle; got ${describe(particle)}.`);
    }
    if (!particle.alive) {
      throw new Error(
        `${this.#where}.bind: the particle must be in its world; it was removed. Ask particle.alive first.`,
      );
    }
    if (this.#drawings.get(particle) === drawing) return;
    this.unbind(particle);
    this.#drawings.set(particle, drawing);
  }

  /** Takes the drawing of a particle away, if it has one. */
  unbind(particle: Particle): void {
    const drawing = this.#drawings.get(particle);
    if (drawing === undefined) return;
    this.#drawings.delete(particle);
    if (particle.slot < this.#bound.length) this.#bound[particle.slot] = 0;
    this.#release(drawing);
  }

  /** Unbinds what is no longer in the world, and marks the slots of the rest. Call it at the start of a frame. */
  prune(particles: ParticleArrays): void {
    if (this.#bound.length < particles.count) this.#bound = new Uint8Array(particles.alive.length);
    this.#bound.fill(0);
    this.#particles = particles;
    this.#drawings.forEach(this.#keep);
  }

  /** Calls back with each bound particle, in the order of binding. */
  forEach(callback: (drawing: Drawing, particle: Particle) => void): void {
    this.#drawings.forEach(callback);
  }

  /** Unbinds everything. */
  clear(): void {
    for (const particle of this.#drawings.keys()) this.unbind(particle);
  }

  #particles: ParticleArrays | null = null;
  readonly #keep = (_: Drawing, particle: Particle): void => {
    if (particle.isIn(this.#particles as ParticleArrays)) this.#bound[particle.slot] = 1;
    else this.unbind(particle);
  };
}
