/** The same work as a loop over objects, as one writes it by hand in a small game: the yardstick of the benchmark. */
export interface Body {
  x: number;
  y: number;
  previousX: number;
  previousY: number;
  vx: number;
  vy: number;
  fx: number;
  fy: number;
  ax: number;
  ay: number;
  mass: number;
  damping: number;
}

export function makeBodies(count: number): Body[] {
  return Array.from({ length: count }, (_, i) => ({
    x: i % 1000,
    y: (i * 7) % 100,
    previousX: 0,
    previousY: 0,
    vx: (i % 13) - 6.5,
    vy: (i % 7) + 0.5,
    fx: 0,
    fy: 0,
    ax: 0,
    ay: 0,
    mass: 1 + (i % 3),
    damping: 1,
  }));
}

/** Gravity, drag in proportion to the speed, previous positions, semi-implicit Euler, a sweep for NaN: no more than that. */
export function stepBodies(bodies: Body[], gravity: number, k1: number, dt: number): void {
  for (const body of bodies) {
    body.fx -= k1 * body.vx;
    body.fy -= k1 * body.vy;
    body.previousX = body.x;
    body.previousY = body.y;
    body.vx += (body.fx / body.mass) * dt;
    body.vy += (gravity + body.fy / body.mass) * dt;
    body.x += body.vx * dt;
    body.y += body.vy * dt;
    body.fx = 0;
    body.fy = 0;
    if (!Number.isFinite(body.x + body.y)) throw new RangeError('a body is not finite');
  }
}

/** The same, and a constant acceleration and a damping of each body's own, as a particle of Mass may have them. */
export function stepDampedBodies(bodies: Body[], gravity: number, k1: number, dt: number): void {
  let lastDamping = 1;
  let kept = 1;
  for (const body of bodies) {
    body.fx -= k1 * body.vx;
    body.fy -= k1 * body.vy;
    body.previousX = body.x;
    body.previousY = body.y;
    if (body.damping !== lastDamping) {
      lastDamping = body.damping;
      kept = lastDamping ** dt;
    }
    body.vx = (body.vx + (body.ax + body.fx / body.mass) * dt) * kept;
    body.vy = (body.vy + (gravity + body.ay + body.fy / body.mass) * dt) * kept;
    body.x += body.vx * dt;
    body.y += body.vy * dt;
    body.fx = 0;
    body.fy = 0;
    if (!Number.isFinite(body.x + body.y)) throw new RangeError('a body is not finite');
  }
}
