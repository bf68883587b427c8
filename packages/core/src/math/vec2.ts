/**
 * 2D vector algebra for code outside the step: each function returns a new vector and leaves its arguments alone.
 * (Inside the step the same formulas are written out on scalars.)
 */

/** A vector or a point: two numbers. */
export interface Vec2 {
  x: number;
  y: number;
}

/** a + b. */
export function add(a: Readonly<Vec2>, b: Readonly<Vec2>): Vec2 {
  return { x: a.x + b.x, y: a.y + b.y };
}

/** a - b: the way from b to a. */
export function subtract(a: Readonly<Vec2>, b: Readonly<Vec2>): Vec2 {
  return { x: a.x - b.x, y: a.y - b.y };
}

/** v times a number. */
export function scale(v: Readonly<Vec2>, factor: number): Vec2 {
  return { x: v.x * factor, y: v.y * factor };
}

/** a + b times a number. */
export function addScaled(a: Readonly<Vec2>, b: Readonly<Vec2>, factor: number): Vec2 {
  return { x: a.x + b.x * factor, y: a.y + b.y * factor };
}

/** Scalar product: |a|·|b|·cos of the angle between them. */
export function dot(a: Readonly<Vec2>, b: Readonly<Vec2>): number {
  return a.x * b.x + a.y * b.y;
}

/** The z of the vector product: |a|·|b|·sin of the angle from a to b; positive where b lies to the left of a. */
export function cross(a: Readonly<Vec2>, b: Readonly<Vec2>): number {
  return a.x * b.y - a.y * b.x;
}

/** The vector's length. */
export function length(v: Readonly<Vec2>): number {
  return Math.sqrt(v.x * v.x + v.y * v.y);
}

/** The distance between two points. */
export function distance(a: Readonly<Vec2>, b: Readonly<Vec2>): number {
  return length(subtract(a, b));
}

/** The angle from the x axis, counter-clockwise, in radians from -π to π; 0 for the zero vector. */
export function angle(v: Readonly<Vec2>): number {
  return Math.atan2(v.y, v.x);
}

/** The vector of length 1 in the direction of v; the zero vector has no direction and stays zero. */
export function normalise(v: Readonly<Vec2>): Vec2 {
  const size = length(v);
  return size === 0 ? { x: 0, y: 0 } : { x: v.x / size, y: v.y / size };
}

/** v turned a quarter, counter-clockwise. */
export function perpendicular(v: Readonly<Vec2>): Vec2 {
  return { x: v.y === 0 ? 0 : -v.y, y: v.x };
}
