import type { Particle } from '@mass/core';
import type { Point } from './scene.ts';

/** How something is thrown. Units: m, m/s, m/s²; damping is the share of the velocity kept per second. */
export interface Throw {
  readonly x: number;
  readonly y: number;
  readonly vx: number;
  readonly vy: number;
  readonly ax: number;
  readonly ay: number;
  readonly damping: number;
}

/**
 * Where a thrown particle is after `t` seconds: the closed form of projectile motion with damping, v' = a + λ·v with
 * λ = ln d, which gives x = x₀ + (v₀ + a/λ)·(e^(λt) - 1)/λ - a·t/λ.
 */
export function positionAt({ x, y, vx, vy, ax, ay, damping }: Throw, t: number): Point {
  if (damping === 1) return { x: x + vx * t + (ax * t * t) / 2, y: y + vy * t + (ay * t * t) / 2 };
  const lambda = Math.log(damping);
  const grown = Math.expm1(lambda * t) / lambda;
  return {
    x: x + (vx + ax / lambda) * grown - (ax * t) / lambda,
    y: y + (vy + ay / lambda) * grown - (ay * t) / lambda,
  };
}

/** The curve of a throw from its start to `seconds` later, as points for a guide: x and y in turn. */
export function arcOf(thrown: Throw, seconds: number, pieces = 48): number[] {
  const points: number[] = [];
  for (let n = 0; n <= pieces; n++) {
    const { x, y } = positionAt(thrown, (n / pieces) * seconds);
    points.push(x, y);
  }
  return points;
}

/** A particle in flight beside its closed form. */
export class Flight {
  readonly particle: Particle;
  readonly thrown: Throw;
  /** The particle's, which outlives it. */
  readonly group: number;
  readonly #start: number;
  #last: Point;
  #flown = 0;
  #error = 0;

  /** `start` is the world's time when the particle was thrown. Unit: s. */
  constructor(particle: Particle, thrown: Throw, start: number) {
    this.particle = particle;
    this.thrown = thrown;
    this.group = particle.group;
    this.#start = start;
    this.#last = thrown;
  }

  /** How far the particle is off its closed form, as a share of the way that it has flown. */
  get error(): number {
    return this.#error;
  }

  /** Looks where the particle is now. Unit: s. */
  follow(time: number): void {
    const { x, y } = this.particle;
    const exact = positionAt(this.thrown, time - this.#start);
    this.#flown += Math.hypot(x - this.#last.x, y - this.#last.y);
    this.#last = { x, y };
    if (this.#flown > 0) this.#error = Math.hypot(x - exact.x, y - exact.y) / this.#flown;
  }
}
