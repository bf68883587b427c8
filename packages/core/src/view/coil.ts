import { type PathList, type PathPaint, pathKinds } from './path-list.ts';

/** Share of the rest length that is straight at each end. */
const lead = 0.08;
/** The narrowest and widest that coils become, as a share of their width at rest. */
const narrowest = 0.3;
const widest = 1.5;
/** From one coil to the next at rest, at least, as a multiple of the width of the wire. */
const closest = 2.5;

/** How many coils fit: as many as wanted, unless the wire would have no room beside itself at rest. */
export function coilCount(wanted: number, rest: number, width: number): number {
  return rest > 0 ? Math.min(wanted, Math.max(1, Math.floor(rest / (closest * width)))) : wanted;
}

/** How far coils swing to each side: less as the spring is stretched, so that its wire seems to stay as long. */
export function coilRadius(diameter: number, rest: number, length: number): number {
  const atRest = rest > 0 ? Math.min(diameter / 2, rest / 4) : diameter / 2;
  const stretch = length > 0 ? Math.sqrt((rest > 0 ? rest : 2 * diameter) / length) : widest;
  return atRest * Math.min(widest, Math.max(narrowest, stretch));
}

/** Adds a spring from one place to another, all in CSS px: straight leads, and coils between; without coils it is straight. */
export function addCoil(
  list: PathList,
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  rest: number,
  wanted: number,
  diameter: number,
  paint: PathPaint,
): void {
  const dx = x1 - x0;
  const dy = y1 - y0;
  const length = Math.sqrt(dx * dx + dy * dy);
  const coils = coilCount(wanted, rest, paint.width);
  const radius = coilRadius(diameter, rest, length);
  list.add(x0, y0);
  if (length > 0 && coils > 0 && radius > 0.75) {
    const nx = -dy / length;
    const ny = dx / length;
    const steps = coils * (radius > 6 ? 12 : radius > 3 ? 8 : 4);
    for (let k = 0; k <= steps; k++) {
      const t = lead + ((1 - 2 * lead) * k) / steps;
      const across = radius * Math.sin((2 * Math.PI * coils * k) / steps);
      list.add(x0 + dx * t + nx * across, y0 + dy * t + ny * across);
    }
  }
  list.add(x1, y1);
  list.end(pathKinds.line, paint);
}
