import { type PathList, pathKinds } from '@mass/core/view';
import { earcut } from 'pixi.js';
import type { Triangles } from './triangles.ts';

/** A corner reaches no farther out than so many half-widths: what is sharper is cut off. */
const mostMitre = 2;

/** Adds lines and polygons as triangles, in order. Their edges fade over one device pixel, which smooths them. */
export function drawPaths(
  triangles: Triangles,
  { count, kinds, paints, starts, points }: PathList,
  pixelRatio: number,
): void {
  const soft = 1 / pixelRatio;
  triangles.begin();
  for (let p = 0; p < count; p++) {
    const { rgb, alpha, width } = paints[p];
    const first = starts[p];
    const end = starts[p + 1];
    triangles.color(rgb, alpha);
    if (kinds[p] === pathKinds.fill) addPolygon(triangles, points, first, end, soft);
    else if (kinds[p] === pathKinds.strip) addStrip(triangles, points, first, end);
    else addLine(triangles, points, first, end, kinds[p] === pathKinds.ring, width, soft);
  }
  triangles.end();
}

/**
 * A line as three bands along it: a soft edge, the middle, a soft edge. Thinner than a pixel it has no middle, and its
 * coverage is less. Where it turns by more than a right angle it ends, and begins anew, with square ends.
 */
function addLine(
  triangles: Triangles,
  points: Float64Array,
  first: number,
  end: number,
  closed: boolean,
  width: number,
  soft: number,
): void {
  const last = end - 2;
  let start = -1;
  let before = -1;
  let ux = closed ? directionX(points, last, first) : 0;
  let uy = closed ? directionY(points, last, first) : 0;
  for (let k = first; k < end; k += 2) {
    const next = k < last ? k + 2 : closed ? first : k;
    let vx = directionX(points, k, next);
    let vy = directionY(points, k, next);
    if (vx === 0 && vy === 0) {
      vx = ux;
      vy = uy;
    }
    if (ux === 0 && uy === 0) {
      ux = vx;
      uy = vy;
    }
    const x = points[k];
    const y = points[k + 1];
    const half = width / 2;
    if (ux * vx + uy * vy < 0) {
      const stop = addCorners(triangles, x + half * ux, y + half * uy, -uy, ux, width, soft);
      if (before >= 0) addBands(triangles, before, stop);
      else start = stop; // of a closed line: where it ends
      before = addCorners(triangles, x - half * vx, y - half * vy, -vy, vx, width, soft);
    } else {
      // Out along the middle of the two normals, as far as makes both bands as wide as they should be.
      const mx = -(uy + vy);
      const my = ux + vx;
      const reach = 2 / Math.max(1e-12, mx * mx + my * my);
      const at = addCorners(triangles, x, y, mx * reach, my * reach, width, soft);
      if (before >= 0) addBands(triangles, before, at);
      else start = at;
      before = at;
    }
    ux = vx;
    uy = vy;
  }
  if (closed) addBands(triangles, before, start);
}

/** Adds the four corners across a line, out along (mx, my) and its opposite. Returns the number of the first. */
function addCorners(
  triangles: Triangles,
  x: number,
  y: number,
  mx: number,
  my: number,
  width: number,
  soft: number,
): number {
  const inner = Math.max(0, (width - soft) / 2);
  const outer = inner + soft;
  const coverage = Math.min(1, width / soft);
  const at = triangles.corner(x + mx * outer, y + my * outer, 0);
  triangles.corner(x + mx * inner, y + my * inner, coverage);
  triangles.corner(x - mx * inner, y - my * inner, coverage);
  triangles.corner(x - mx * outer, y - my * outer, 0);
  return at;
}

function addBands(triangles: Triangles, from: number, to: number): void {
  for (let band = 0; band < 3; band++) triangles.quad(from + band, from + band + 1, to + band, to + band + 1);
}

function directionX(points: Float64Array, from: number, to: number): number {
  const dx = points[to] - points[from];
  const dy = points[to + 1] - points[from + 1];
  const length = Math.sqrt(dx * dx + dy * dy);
  return length === 0 ? 0 : dx / length;
}

function directionY(points: Float64Array, from: number, to: number): number {
  const dx = points[to] - points[from];
  const dy = points[to + 1] - points[from + 1];
  const length = Math.sqrt(dx * dx + dy * dy);
  return length === 0 ? 0 : dy / length;
}

/** A polygon, and around it a band that fades. */
function addPolygon(triangles: Triangles, points: Float64Array, first: number, end: number, soft: number): void {
  const count = (end - first) / 2;
  if (count < 3) return;
  let area = 0;
  for (let i = first, j = end - 2; i < end; j = i, i += 2) {
    area += points[j] * points[i + 1] - points[i] * points[j + 1];
  }
  const side = area < 0 ? -0.5 * soft : 0.5 * soft;
  let convex = true;
  let base = -1;
  let ux = directionX(points, end - 2, first);
  let uy = directionY(points, end - 2, first);
  for (let k = first; k < end; k += 2) {
    const next = k + 2 < end ? k + 2 : first;
    const vx = directionX(points, k, next);
    const vy = directionY(points, k, next);
    if ((ux * vy - uy * vx) * area < 0) convex = false;
    let nx = uy + vy; // outwards where the area is positive
    let ny = -(ux + vx);
    const square = nx * nx + ny * ny;
    const reach = square > 1e-6 ? (side * Math.min(mostMitre, 2 / Math.sqrt(square))) / Math.sqrt(square) : 0;
    nx *= reach;
    ny *= reach;
    const at = triangles.corner(points[k] - nx, points[k + 1] - ny, 1);
    triangles.corner(points[k] + nx, points[k + 1] + ny, 0);
    if (base < 0) base = at;
    else triangles.quad(at - 2, at - 1, at, at + 1);
    if (vx !== 0 || vy !== 0) {
      ux = vx;
      uy = vy;
    }
  }
  triangles.quad(base + 2 * count - 2, base + 2 * count - 1, base, base + 1);
  if (convex) for (let i = 2; i < count; i++) triangles.triangle(base, base + 2 * i - 2, base + 2 * i);
  else {
    const parts = earcut(points.subarray(first, end));
    for (let t = 0; t < parts.length; t += 3) {
      triangles.triangle(base + 2 * parts[t], base + 2 * parts[t + 1], base + 2 * parts[t + 2]);
    }
  }
}

/** A strip between two edges, point by point. */
function addStrip(triangles: Triangles, points: Float64Array, first: number, end: number): void {
  for (let k = first; k < end; k += 4) {
    const at = triangles.corner(points[k], points[k + 1], 1);
    triangles.corner(points[k + 2], points[k + 3], 1);
    if (k > first) triangles.quad(at - 2, at - 1, at, at + 1);
  }
}
