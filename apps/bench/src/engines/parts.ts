// What adapters of engines of rigid bodies share.
import type { Bar, Scene } from '../scene.ts';

const THICKNESS = 10;
const HEIGHT = 1000;

/** The container as three thick bars, for engines that know no half-plane. */
export function slabsOf({ container }: Scene): Bar[] {
  if (!container) return [];
  const { left, right, floor } = container;
  const width = right - left + 2 * THICKNESS;
  const y = floor + HEIGHT / 2 - THICKNESS;
  return [
    { x: (left + right) / 2, y: floor - THICKNESS / 2, width, height: THICKNESS },
    { x: left - THICKNESS / 2, y, width: THICKNESS, height: HEIGHT },
    { x: right + THICKNESS / 2, y, width: THICKNESS, height: HEIGHT },
  ];
}

/** Where a rigid body is and how it is turned. */
export interface Pose {
  x: number;
  y: number;
  cos: number;
  sin: number;
}

/** Writes the four corners of a square crate, counter-clockwise. */
export function writeCorners(into: Float64Array, crate: number, { x, y, cos, sin }: Pose, size: number): void {
  for (let k = 0; k < 4; k++) {
    const u = ((k === 1 || k === 2 ? 1 : -1) * size) / 2;
    const v = ((k < 2 ? -1 : 1) * size) / 2;
    into[8 * crate + 2 * k] = x + cos * u - sin * v;
    into[8 * crate + 2 * k + 1] = y + sin * u + cos * v;
  }
}
