import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { ENERGY, GIVE, INVERSE_MASS, MASS, NODE, PIECE, ROW, type TreeTable, VX, VY, X, Y } from './tree-table.ts';

/** Reads where nodes are, and how fast. */
export function gather({ slot, nodes }: TreeTable, from: number, to: number, { x, y, vx, vy }: ParticleArrays): void {
  for (let n = from; n < to; n++) {
    const i = n * NODE;
    const s = slot[n];
    if (s < 0) {
      nodes[i + VX] = nodes[i + VY] = 0;
      continue;
    }
    nodes[i + X] = x[s];
    nodes[i + Y] = y[s];
    nodes[i + VX] = vx[s];
    nodes[i + VY] = vy[s];
  }
}

/** Gives the particles the velocities of the nodes. */
export function scatter({ slot, nodes }: TreeTable, from: number, to: number, { vx, vy }: ParticleArrays): void {
  for (let n = from; n < to; n++) {
    const i = n * NODE;
    if (nodes[i + INVERSE_MASS] === 0) continue;
    vx[slot[n]] = nodes[i + VX];
    vy[slot[n]] = nodes[i + VY];
  }
}

/** Moves nodes on by a piece. */
export function advance({ slot, nodes, shared }: TreeTable, from: number, to: number): void {
  const h = shared[PIECE];
  for (let n = from; n < to; n++) {
    if (slot[n] < 0) continue;
    const i = n * NODE;
    nodes[i + X] += nodes[i + VX] * h;
    nodes[i + Y] += nodes[i + VY] * h;
  }
}

/**
 * Gives the particles the velocities that lead to where the nodes are in `h` seconds. The nodes keep what is left to their own, and, as
 * their place, which is no longer needed, what was given.
 */
export function scatterMean(
  { slot, nodes }: TreeTable,
  from: number,
  to: number,
  { x, y, vx, vy }: ParticleArrays,
  h: number,
): void {
  const perH = 1 / h;
  for (let n = from; n < to; n++) {
    const i = n * NODE;
    if (nodes[i + INVERSE_MASS] === 0) continue;
    const s = slot[n];
    const meanX = (nodes[i + X] - x[s]) * perH;
    const meanY = (nodes[i + Y] - y[s]) * perH;
    nodes[i + VX] -= meanX;
    nodes[i + VY] -= meanY;
    nodes[i + X] = meanX;
    nodes[i + Y] = meanY;
    vx[s] = meanX;
    vy[s] = meanY;
  }
}

/**
 * Adds to the velocities of the particles what `scatterMean` left, unless contacts, which saw the mean alone, would have done more work
 * on them than they meant to. Without it momentum is the same, and there is less energy.
 */
export function addRest({ slot, nodes }: TreeTable, from: number, to: number, { vx, vy }: ParticleArrays): void {
  let work = 0;
  for (let n = from; n < to; n++) {
    const i = n * NODE;
    const m = nodes[i + MASS];
    if (m === 0) continue;
    const s = slot[n];
    work += m * ((vx[s] - nodes[i + X]) * nodes[i + VX] + (vy[s] - nodes[i + Y]) * nodes[i + VY]);
  }
  if (work > 0) return;
  for (let n = from; n < to; n++) {
    const i = n * NODE;
    if (nodes[i + MASS] === 0) continue;
    vx[slot[n]] += nodes[i + VX];
    vy[slot[n]] += nodes[i + VY];
  }
}

/** Works out the energy of motion of nodes. */
export function measureMotion({ nodes, shared }: TreeTable, from: number, to: number): void {
  let sum = 0;
  for (let i = from * NODE; i < to * NODE; i += NODE) {
    const vx = nodes[i + VX];
    const vy = nodes[i + VY];
    sum += nodes[i + MASS] * (vx * vx + vy * vy);
  }
  shared[ENERGY] = sum / 2;
}

/** Adds to it the energy of links that give and are beyond their limits. */
export function measureStretch(t: TreeTable, from: number, to: number): void {
  const { node, parent, rows, nodes, minLength, maxLength } = t;
  let sum = 0;
  for (let k = from; k < to; k++) {
    const give = rows[k * ROW + GIVE];
    if (parent[k] < 0 || give === 0) continue;
    const i = node[k] * NODE;
    const j = node[parent[k]] * NODE;
    const dx = nodes[j + X] - nodes[i + X];
    const dy = nodes[j + Y] - nodes[i + Y];
    const length = Math.sqrt(dx * dx + dy * dy);
    const over = length - Math.max(minLength[k], Math.min(maxLength[k], length));
    sum += (over * over) / give;
  }
  t.shared[ENERGY] += sum / 2;
}

/**
 * Takes energy out of the motion of nodes, all in proportion; where nothing holds them, out of that about their common velocity, so
 * that momentum is kept. Returns how much there was to take. Unit: J.
 */
export function slow({ nodes }: TreeTable, from: number, to: number, energy: number): number {
  let mass = 0;
  let px = 0;
  let py = 0;
  let motion = 0;
  let isHeld = false;
  for (let i = from * NODE; i < to * NODE; i += NODE) {
    const m = nodes[i + MASS];
    const vx = nodes[i + VX];
    const vy = nodes[i + VY];
    mass += m;
    px += m * vx;
    py += m * vy;
    motion += 0.5 * m * (vx * vx + vy * vy);
    if (m === 0) isHeld = true;
  }
  const ux = isHeld ? 0 : px / mass;
  const uy = isHeld ? 0 : py / mass;
  motion -= 0.5 * mass * (ux * ux + uy * uy);
  const taken = Math.min(energy, motion);
  if (!(taken > 0)) return 0;
  const share = Math.sqrt(1 - taken / motion);
  for (let i = from * NODE; i < to * NODE; i += NODE) {
    if (nodes[i + MASS] === 0) continue;
    nodes[i + VX] = ux + share * (nodes[i + VX] - ux);
    nodes[i + VY] = uy + share * (nodes[i + VY] - uy);
  }
  return taken;
}
