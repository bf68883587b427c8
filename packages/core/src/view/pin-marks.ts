import { type End, particleOf } from '../particles/end.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { Frame } from './frame.ts';
import { addCircle } from './geometry.ts';
import { type PathList, type PathPaint, pathKinds } from './path-list.ts';
import { pathPaint } from './ramp.ts';
import type { SceneStyle } from './scene-style.ts';

/** From a disc to the ring around it. Unit: CSS px. */
const clearance = 2.5;

/** Draws the marks where something hangs on a fixed point, or on a particle that cannot move: a ring with a dot. */
export class PinMarks {
  readonly #ring: PathPaint | null;
  readonly #dot: PathPaint | null;
  readonly #radius: number;
  readonly #points: End[] = [];
  readonly #slots: number[] = [];
  #noted: Uint8Array = new Uint8Array(0);
  #particles: ParticleArrays | null = null;

  constructor({ pins }: SceneStyle) {
    this.#ring = pins && pathPaint(pins.color, pins.alpha, Math.min(2, pins.radius / 2.5));
    this.#dot = pins && pathPaint(pins.color, pins.alpha, 0);
    this.#radius = pins?.radius ?? 0;
  }

  /** Starts a frame. */
  begin(particles: ParticleArrays): void {
    this.#particles = particles;
    this.#points.length = 0;
    this.#slots.length = 0;
    if (this.#noted.length < particles.count) this.#noted = new Uint8Array(particles.alive.length);
    this.#noted.fill(0);
  }

  /** Takes note of an end that something hangs on. */
  note(end: End): void {
    if (this.#ring === null || this.#particles === null) return;
    const particle = particleOf(end);
    if (particle === undefined) {
      if (this.#points.at(-1) !== end) this.#points.push(end);
    } else if (this.#particles.mass[particle.slot] === Infinity && this.#noted[particle.slot] === 0) {
      this.#noted[particle.slot] = 1;
      this.#slots.push(particle.slot);
    }
  }

  /** Adds the marks. */
  draw(list: PathList, frame: Frame): void {
    for (const end of this.#points) this.#mark(list, frame.endX(end), frame.endY(end), 0, frame);
    for (const slot of this.#slots) this.#mark(list, frame.x[slot], frame.y[slot], frame.radius[slot], frame);
  }

  #mark(list: PathList, x: number, y: number, disc: number, frame: Frame): void {
    if (this.#ring === null || this.#dot === null || frame.misses(x, y, x, y, disc + 20)) return;
    addCircle(list, x, y, Math.max(this.#radius, disc + clearance) - this.#ring.width / 2);
    list.end(pathKinds.ring, this.#ring);
    if (disc > 0) return;
    addCircle(list, x, y, this.#radius * 0.4);
    list.end(pathKinds.fill, this.#dot);
  }
}
