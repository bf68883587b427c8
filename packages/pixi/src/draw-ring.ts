import type { Atlas } from './atlas.ts';
import type { QuadBatch } from './quad-batch.ts';

/** How far the polygon may be from the circle. Unit: device px. */
const tolerance = 0.1;
const mostSides = 2048;

/** Adds a ring as a polygon of lines, sharp at any size, where one of the atlas would be scaled. Lengths in CSS px. */
export function drawRing(
  batch: QuadBatch,
  atlas: Atlas,
  x: number,
  y: number,
  outer: number,
  width: number,
  rgb: number,
  alpha: number,
  pixelRatio: number,
): void {
  const { texture, size } = atlas.line(width * pixelRatio);
  const radius = outer - width / 2;
  const sides = Math.min(mostSides, Math.ceil(Math.PI * Math.sqrt((outer * pixelRatio) / (2 * tolerance))));
  const half = Math.PI / sides;
  // As long as makes the outer edges meet, and as far out as halves the error.
  const side = 2 * outer * Math.tan(half);
  const distance = (radius * (1 + Math.cos(half))) / 2;
  for (let k = 0; k < sides; k++) {
    const angle = 2 * half * k;
    const middleX = x + distance * Math.cos(angle);
    const middleY = y + distance * Math.sin(angle);
    batch.add(texture, middleX, middleY, side, width / size, angle + Math.PI / 2, rgb, alpha);
  }
}
