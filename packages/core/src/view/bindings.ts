import type { Body } from '../bodies/body.ts';
import { describe } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';

/**
 * What a game draws in place of particles of its choice, or, with `Body` for `Target`, of bodies. For authors of renderers.
 */
export class Bindings<Drawing, Target extends Particle | Body = Particle> {
  readonly #where: string;
  readonly #drawings = new Map<Target, Drawing>();
  readonly #release: (drawing: Drawing) => void;
  #bound: Uint8Array = new Uint8Array(0);

  /** `where` names the renderer in errors; `release` hears of each drawing that is bound no longer. */
  constructor(where: string, release: (drawing: Drawing) => void = () => {}) {
    this.#where = where;
    this.#release = release;
  }

  /** 1 for each slot in whose place something is drawn, as of the last `prune`. */
  get bound(): Uint8Array {
    return this.#bound;
  }

  /** Binds a drawing to a living particle or body, in place of the one that it had. */
  bind(target: Target, drawing: Drawing): void {
    if (typeof target !== 'object' || target === null || !('alive' in target)) {
      throw new TypeError(
        `${this.#where}.bind: the first argument must be a particle or a body; got ${describe(target)}.`,
      );
    }
    if (!target.alive) {
      const what = isParticle(target) ? 'particle' : 'body';
      throw new Error(
        `${this.#where}.bind: the ${what} must be in its world; it was removed. Ask ${what}.alive first.`,
      );
    }
    if (this.#drawings.get(target) === drawing) return;
    this.unbind(target);
    this.#drawings.set(target, drawing);
  }

  /** Takes the drawing of a particle or body away, if it has one. */
  unbind(target: Target): void {
    const drawing = this.#drawings.get(target);
    if (drawing === undefined) return;
    this.#drawings.delete(target);
    this.#mark(target, 0);
    this.#release(drawing);
  }

  /** Unbinds what is no longer in the world, and marks the slots of the rest. Call it at the start of a frame. */
  prune(particles: ParticleArrays): void {
    if (this.#bound.length < particles.count) this.#bound = new Uint8Array(particles.alive.length);
    this.#bound.fill(0);
    this.#particles = particles;
    this.#drawings.forEach(this.#keep);
  }

  /** Calls back with each bound particle or body, in the order of binding. */
  forEach(callback: (drawing: Drawing, target: Target) => void): void {
    this.#drawings.forEach(callback);
  }

  /** Unbinds everything. */
  clear(): void {
    for (const target of this.#drawings.keys()) this.unbind(target);
  }

  #particles: ParticleArrays | null = null;
  readonly #keep = (_: Drawing, target: Target): void => {
    const first: Particle | undefined = isParticle(target) ? target : target.particles[0];
    if (first?.isIn(this.#particles as ParticleArrays)) this.#mark(target, 1);
    else this.unbind(target);
  };

  #mark(target: Particle | Body, value: number): void {
    const bound = this.#bound;
    if (!isParticle(target)) for (const { slot } of target.particles) bound[slot] = value;
    else if (target.slot < bound.length) bound[target.slot] = value;
  }
}

function isParticle(target: Particle | Body): target is Particle {
  return 'isIn' in target;
}
