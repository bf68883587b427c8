/**
 * How a contact gives way within a small step: as a spring of a frequency and a damping ratio, integrated implicitly, so that it is
 * stable however stiff it is (E. Catto: Soft Constraints, 2011; Solver2D, 2024).
 */
export interface Softness {
  /** Share of a penetration that is undone in a second. Unit: 1/s. */
  readonly biasRate: number;
  /** Shares of the effective mass, and of the impulse so far that is let go. */
  readonly massScale: number;
  readonly impulseScale: number;
}

/** Undoes no penetration and holds what it has: for velocities alone. */
export const RIGID: Softness = { biasRate: 0, massScale: 1, impulseScale: 0 };

/**
 * @param hertz - Frequency of the spring. Unit: Hz.
 * @param dampingRatio - 1 is critical; contacts are damped far beyond.
 * @param h - Duration of the small step. Unit: s.
 */
export function softness(hertz: number, dampingRatio: number, h: number): Softness {
  const omega = 2 * Math.PI * hertz;
  const a1 = 2 * dampingRatio + h * omega;
  const a2 = h * omega * a1;
  const a3 = 1 / (1 + a2);
  return { biasRate: omega / a1, massScale: a2 * a3, impulseScale: a3 };
}
