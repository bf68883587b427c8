// How good a result is, from positions and velocities alone: one code for all engines.
import type { Scene } from './scene.ts';

/** What a crowd of discs in a container looks like. */
export interface Overlaps {
  /** Depth by which those that overlap do so, in the mean. Unit: m. */
  readonly mean: number;
  /** The deepest. Unit: m. */
  readonly peak: number;
  /** Discs whose centre is outside the container, or nowhere. */
  readonly escaped: number;
}

/** Overlaps of discs with one another and with the container. Positions are x and y by turns. */
export function overlapsOf({ discs, container }: Scene, positions: Float64Array): Overlaps {
  const cell = 2 * discs.reduce((most, { radius }) => Math.max(most, radius), 0);
  const cells = new Map<number, number[]>();
  let sum = 0;
  let count = 0;
  let peak = 0;
  let escaped = 0;
  const note = (depth: number): void => {
    if (!(depth > 0)) return;
    sum += depth;
    count++;
    if (depth > peak) peak = depth;
  };
  discs.forEach(({ radius }, i) => {
    const x = positions[2 * i];
    const y = positions[2 * i + 1];
    if (!Number.isFinite(x + y)) {
      escaped++;
      return;
    }
    if (container) {
      const room = Math.min(x - container.left, container.right - x, y - container.floor);
      if (room < 0) escaped++;
      else note(radius - room);
    }
    const column = Math.floor(x / cell);
    const row = Math.floor(y / cell);
    for (let near = 0; near < 9; near++) {
      for (const j of cells.get(keyOf(column + (near % 3) - 1, row + Math.floor(near / 3) - 1)) ?? []) {
        const distance = Math.hypot(positions[2 * j] - x, positions[2 * j + 1] - y);
        note(radius + discs[j].radius - distance);
      }
    }
    const key = keyOf(column, row);
    const here = cells.get(key);
    if (here) here.push(i);
    else cells.set(key, [i]);
  });
  return { mean: count === 0 ? 0 : sum / count, peak, escaped };
}

function keyOf(column: number, row: number): number {
  return column * 1_000_003 + row;
}

/** Lengths of all links together, over what they should be, less 1. */
export function stretchOf({ links }: Scene, positions: Float64Array): number {
  let length = 0;
  let rest = 0;
  for (const link of links) {
    length += lengthOf(link, positions);
    rest += link.length;
  }
  return length / rest - 1;
}

/** How much each link is too long or too short, as a share of its length, in the mean. */
export function strainOf({ links }: Scene, positions: Float64Array): number {
  return links.reduce((sum, link) => sum + Math.abs(lengthOf(link, positions) / link.length - 1), 0) / links.length;
}

function lengthOf({ a, b }: { a: number; b: number }, positions: Float64Array): number {
  return Math.hypot(positions[2 * a] - positions[2 * b], positions[2 * a + 1] - positions[2 * b + 1]);
}

/** Kinetic energy, and potential energy over y = 0, of all that moves. Unit: J. */
export function energyOf({ discs, gravity }: Scene, positions: Float64Array, velocities: Float64Array): number {
  return discs.reduce((sum, { mass, fixed }, i) => {
    if (fixed) return sum;
    const vx = velocities[2 * i];
    const vy = velocities[2 * i + 1];
    return sum + mass * ((vx * vx + vy * vy) / 2 + gravity * positions[2 * i + 1]);
  }, 0);
}

/** Root of the mean square distance that two sets of positions are apart, per coordinate pair. Unit: m. */
export function distanceBetween(before: Float64Array, after: Float64Array): number {
  const square = before.reduce((sum, value, i) => sum + (after[i] - value) ** 2, 0);
  return Math.sqrt((2 * square) / before.length);
}

/** Overlaps and shapes of crates. */
export interface CrateQuality {
  /** Depth of corners inside other crates or the container, in the mean of those that are. Unit: m. */
  readonly mean: number;
  readonly peak: number;
  /** The greatest deviation of a side from its length, as a share of it. */
  readonly deformation: number;
  readonly escaped: number;
}

/** Quality of crates from their corners, eight numbers each. */
export function crateQualityOf({ crates, container }: Scene, corners: Float64Array): CrateQuality {
  let sum = 0;
  let count = 0;
  let peak = 0;
  let deformation = 0;
  let escaped = 0;
  const note = (depth: number): void => {
    if (!(depth > 0)) return;
    sum += depth;
    count++;
    if (depth > peak) peak = depth;
  };
  crates.forEach((crate, a) => {
    const centre = centreOf(corners, a);
    if (!Number.isFinite(centre.x + centre.y)) escaped++;
    if (container && !(centre.x > container.left && centre.x < container.right && centre.y > container.floor))
      escaped++;
    for (let k = 0; k < 4; k++) {
      const x = corners[8 * a + 2 * k];
      const y = corners[8 * a + 2 * k + 1];
      const next = 8 * a + 2 * ((k + 1) % 4);
      const side = Math.hypot(corners[next] - x, corners[next + 1] - y);
      deformation = Math.max(deformation, Math.abs(side / crate.size - 1));
      if (container) note(Math.max(container.left - x, x - container.right, container.floor - y));
      for (let b = 0; b < crates.length; b++) if (b !== a) note(depthInside(corners, b, x, y));
    }
  });
  return { mean: count === 0 ? 0 : sum / count, peak, deformation, escaped };
}

function centreOf(corners: Float64Array, crate: number): { x: number; y: number } {
  let x = 0;
  let y = 0;
  for (let k = 0; k < 4; k++) {
    x += corners[8 * crate + 2 * k] / 4;
    y += corners[8 * crate + 2 * k + 1] / 4;
  }
  return { x, y };
}

/** How far a point is inside a crate, from its nearest side; negative outside. */
function depthInside(corners: Float64Array, crate: number, x: number, y: number): number {
  let depth = Infinity;
  for (let k = 0; k < 4; k++) {
    const from = 8 * crate + 2 * k;
    const to = 8 * crate + 2 * ((k + 1) % 4);
    const ux = corners[to] - corners[from];
    const uy = corners[to + 1] - corners[from + 1];
    const left = (ux * (y - corners[from + 1]) - uy * (x - corners[from])) / Math.hypot(ux, uy);
    if (left < depth) depth = left;
    if (depth < 0) return depth;
  }
  return depth;
}
