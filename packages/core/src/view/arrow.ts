import { type PathList, type PathPaint, pathKinds } from './path-list.ts';

/** A head is as long as so many widths of the shaft, and no more than so much of the arrow. */
const headLength = 4.5;
const headShare = 0.6;
const headHalfWidth = 0.42;
/** What is shorter is not drawn. Unit: CSS px. */
const shortest = 1.5;

/** Adds an arrow, all in CSS px: a shaft and a head, which shrinks with a short arrow. */
export function addArrow(
  list: PathList,
  x: number,
  y: number,
  dx: number,
  dy: number,
  longest: number,
  shaft: PathPaint,
  head: PathPaint,
): void {
  const wanted = Math.sqrt(dx * dx + dy * dy);
  const length = Math.min(longest, wanted);
  if (!(length >= shortest)) return;
  const ux = dx / wanted;
  const uy = dy / wanted;
  const size = Math.min(headLength * shaft.width, headShare * length);
  const neckX = x + ux * (length - size);
  const neckY = y + uy * (length - size);
  list.line(x, y, neckX + ux * size * 0.25, neckY + uy * size * 0.25, shaft);
  list.add(x + ux * length, y + uy * length);
  list.add(neckX - uy * size * headHalfWidth, neckY + ux * size * headHalfWidth);
  list.add(neckX + uy * size * headHalfWidth, neckY - ux * size * headHalfWidth);
  list.end(pathKinds.fill, head);
}
