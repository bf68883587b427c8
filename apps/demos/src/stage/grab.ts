import type { ForceGenerator, ForceTargets, ParticleArrays } from '@mass/core';

/** How fast a held particle follows: the angular frequency of the spring. Unit: rad/s. */
const FREQUENCY = 14;

/** The most that the hand pulls with, for each kilogram that it holds. Unit: m/s². */
const STRONGEST = 600;

/** The reader's hand: a critically damped spring from a particle to the pointer, with a limit on its force. */
export class Grab implements ForceGenerator {
  /** Where the pointer is. Unit: m. */
  x: number;
  y: number;

  constructor(x: number, y: number) {
    this.x = x;
    this.y = y;
  }

  /** Reads x, y, vx, vy, mass, inverseMass. Adds to fx, fy. */
  apply({ x, y, vx, vy, mass, inverseMass, fx, fy }: ParticleArrays, { slots, count }: ForceTargets): void {
    for (let t = 0; t < count; t++) {
      const i = slots[t];
      if (inverseMass[i] === 0) continue;
      const pullX = FREQUENCY * FREQUENCY * (this.x - x[i]) - 2 * FREQUENCY * vx[i];
      const pullY = FREQUENCY * FREQUENCY * (this.y - y[i]) - 2 * FREQUENCY * vy[i];
      const share = mass[i] * Math.min(1, STRONGEST / Math.max(1e-9, Math.sqrt(pullX * pullX + pullY * pullY)));
      fx[i] += share * pullX;
      fy[i] += share * pullY;
    }
  }
}
