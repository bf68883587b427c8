/**
 * When two discs that move along a line first touch, as a share of the way: 0 where they touch already, Infinity where they pass by.
 * @param dx - Centre of the first, seen from the second. Unit: m.
 * @param dy - Centre of the first, seen from the second. Unit: m.
 * @param ux - Way of the first, seen from the second. Unit: m.
 * @param uy - Way of the first, seen from the second. Unit: m.
 * @param sum - Sum of the radii. Unit: m.
 */
export function timeOfTouch(dx: number, dy: number, ux: number, uy: number, sum: number): number {
  // |d + u·t|² = sum²: a·t² + 2·b·t + c = 0
  const a = ux * ux + uy * uy;
  const b = dx * ux + dy * uy;
  const c = dx * dx + dy * dy - sum * sum;
  if (c <= 0) return 0;
  if (b >= 0) return Infinity;
  const discriminant = b * b - a * c;
  return discriminant < 0 ? Infinity : c / (Math.sqrt(discriminant) - b); // this form cancels nothing: b is negative
}
