/** How a pendulum swings that is let go at rest, in closed form at any amplitude. Units: rad, rad/s, s. */
export class PendulumMotion {
  readonly amplitude: number;
  /** Of small swings: √(g / L). */
  readonly omega: number;
  /** Of one whole swing: 2π / (ω·agm(1, cos(θ₀/2))), the elliptic integral by the arithmetic-geometric mean. */
  readonly period: number;
  readonly #modulus: number;
  // The means that converge on agm(1, cos(θ₀/2)), and half the differences of the two before.
  readonly #a: number[] = [1];
  readonly #c: number[] = [];

  constructor(amplitude: number, length: number, g: number) {
    this.amplitude = amplitude;
    this.omega = Math.sqrt(g / length);
    this.#modulus = Math.sin(amplitude / 2);
    let b = Math.cos(amplitude / 2);
    while (Math.abs(this.#a[this.#a.length - 1] - b) > 1e-15 && this.#a.length < 20) {
      const a = this.#a[this.#a.length - 1];
      this.#c.push((a - b) / 2);
      this.#a.push((a + b) / 2);
      b = Math.sqrt(a * b);
    }
    this.period = (2 * Math.PI) / (this.omega * this.#a[this.#a.length - 1]);
  }

  /** sin(θ/2) = k·cn(ωt)/dn(ωt), with Jacobi's functions by Landen's descending steps (Abramowitz and Stegun, 16.4). */
  angleAt(time: number): number {
    const k = this.#modulus;
    const last = this.#a.length - 1;
    let phase = 2 ** last * this.#a[last] * this.omega * (time % this.period);
    for (let n = last; n > 0; n--) phase = (phase + Math.asin((this.#c[n - 1] / this.#a[n]) * Math.sin(phase))) / 2;
    const sn = Math.sin(phase);
    return 2 * Math.asin((k * Math.cos(phase)) / Math.sqrt(1 - k * k * sn * sn));
  }
}
