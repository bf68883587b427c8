import { type PathList, type PathPaint, pathKinds } from './path-list.ts';

/** Slack below this share of the length is not shown: a cable that holds a swinging weight must not tremble. */
const tautShare = 0.002;
const mostSegments = 24;

/**
 * How deep the middle of a line of some length hangs between two ends, as a parabola: the sum of the segments that are drawn
 * is the length. The ends are `dx`, `dy` apart and it hangs along the unit vector `gx`, `gy`.
 */
export function sagOf(dx: number, dy: number, length: number, gx: number, gy: number, segments: number): number {
  let low = 0;
  let high = length; // half of it is enough for a curve; more for one of few segments
  for (let n = 0; n < 24 && high - low > 0.02; n++) {
    const middle = (low + high) / 2;
    if (lengthOf(dx, dy, middle, gx, gy, segments) < length) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

function lengthOf(dx: number, dy: number, sag: number, gx: number, gy: number, segments: number): number {
  let sum = 0;
  let before = 0;
  for (let k = 1; k <= segments; k++) {
    const t = k / segments;
    const hang = 4 * sag * t * (1 - t);
    const x = dx / segments + gx * (hang - before);
    const y = dy / segments + gy * (hang - before);
    sum += Math.sqrt(x * x + y * y);
    before = hang;
  }
  return sum;
}

/** Adds a line of some length from one place to another, all in CSS px: straight when taut, in a curve when slack. */
export function addSlack(
  list: PathList,
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  length: number,
  gx: number,
  gy: number,
  paint: PathPaint,
): void {
  const dx = x1 - x0;
  const dy = y1 - y0;
  const distance = Math.sqrt(dx * dx + dy * dy);
  const shown = length * (1 - tautShare);
  list.add(x0, y0);
  if (distance < shown) {
    const segments = Math.max(4, Math.min(mostSegments, 2 * Math.ceil(shown / 16)));
    const sag = sagOf(dx, dy, shown, gx, gy, segments);
    for (let k = 1; k < segments; k++) {
      const t = k / segments;
      const hang = 4 * sag * t * (1 - t);
      list.add(x0 + dx * t + gx * hang, y0 + dy * t + gy * hang);
    }
  }
  list.add(x1, y1);
  list.end(pathKinds.line, paint);
}
