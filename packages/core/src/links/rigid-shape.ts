import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { LimitedLink } from './limited-link.ts';
import type { LinkGraph } from './link-graph.ts';

/** Particles that rods hold in one shape: all that is left to them is to move and to turn together. */
export interface RigidShape {
  readonly slots: readonly number[];
  /** Where each is in the shape, as the lengths of the rods want it. Unit: m. */
  readonly x: readonly number[];
  readonly y: readonly number[];
}

/** How far a rod may be off the length that the others leave to it, as a share. */
const AGREED = 1e-6;

/** A triangle lower than this share of its base does not place its tip. */
const FLAT = 1e-3;

/**
 * The shape in which the links of a connected part hold its particles; undefined where they leave it other freedom, give, may break, or hold
 * on to something that does not move. Two are placed first; then each that rods join to two that stand already (L. Henneberg 1911), from
 * the lengths alone and on the side where it is now. A rod that is left over must agree.
 */
export function rigidShape(
  slots: readonly number[],
  links: readonly LimitedLink[],
  graph: LinkGraph,
  particles: ParticleArrays,
): RigidShape | undefined {
  const { near, far, first, links: numbers } = graph;
  for (const slot of slots) {
    for (let i = first[slot]; i < first[slot + 1]; i++)
      if (far[numbers[i]] < 0 || !isStiff(links[numbers[i]])) return undefined;
  }
  const shape = new Drawing(particles);
  const start = numbers[first[slots[0]]];
  shape.begin(near[start], far[start], links[start].maxLength);
  for (let placed = 2, before = 0; placed < slots.length; placed = shape.count) {
    if (placed === before) return undefined;
    before = placed;
    for (const slot of slots) if (!shape.has(slot)) shape.place(slot, links, graph);
  }
  for (const slot of slots) {
    for (let i = first[slot]; i < first[slot + 1]; i++) {
      const link = numbers[i];
      const { maxLength } = links[link];
      if (!(Math.abs(shape.distance(near[link], far[link]) - maxLength) <= AGREED * maxLength)) return undefined;
    }
  }
  return { slots, x: slots.map((slot) => shape.xOf(slot)), y: slots.map((slot) => shape.yOf(slot)) };
}

/** A rod that keeps its length whatever comes. */
function isStiff({ minLength, maxLength, compliance, damping, breaksAt }: LimitedLink): boolean {
  return minLength === maxLength && minLength > 0 && compliance === 0 && damping === 0 && breaksAt === undefined;
}

/** Places of particles, from lengths, turned as they are in the world. */
class Drawing {
  readonly #particles: ParticleArrays;
  readonly #places = new Map<number, { readonly x: number; readonly y: number }>();

  constructor(particles: ParticleArrays) {
    this.#particles = particles;
  }

  get count(): number {
    return this.#places.size;
  }

  has(slot: number): boolean {
    return this.#places.has(slot);
  }

  xOf(slot: number): number {
    return this.#places.get(slot)?.x ?? Number.NaN;
  }

  yOf(slot: number): number {
    return this.#places.get(slot)?.y ?? Number.NaN;
  }

  distance(a: number, b: number): number {
    return length(this.xOf(b) - this.xOf(a), this.yOf(b) - this.yOf(a));
  }

  begin(a: number, b: number, distance: number): void {
    const { x, y } = this.#particles;
    const now = length(x[b] - x[a], y[b] - y[a]);
    this.#places.set(a, { x: 0, y: 0 });
    this.#places.set(b, { x: ((x[b] - x[a]) / now) * distance, y: ((y[b] - y[a]) / now) * distance });
  }

  /** Places a slot by rods to two that have a place, if there are such: those that make the highest triangle. */
  place(slot: number, links: readonly LimitedLink[], { near, far, first, links: numbers }: LinkGraph): void {
    const { x, y } = this.#particles;
    let best = FLAT;
    let from = -1;
    let to = -1;
    for (let i = first[slot]; i < first[slot + 1]; i++) {
      const a = otherEnd(near, far, numbers[i], slot);
      if (!this.has(a)) continue;
      for (let j = i + 1; j < first[slot + 1]; j++) {
        const b = otherEnd(near, far, numbers[j], slot);
        if (!this.has(b)) continue;
        const ux = x[b] - x[a];
        const uy = y[b] - y[a];
        const height = Math.abs(ux * (y[slot] - y[a]) - uy * (x[slot] - x[a])) / (ux * ux + uy * uy);
        if (!(height > best)) continue;
        best = height;
        from = i;
        to = j;
      }
    }
    if (from < 0) return;
    const a = otherEnd(near, far, numbers[from], slot);
    const b = otherEnd(near, far, numbers[to], slot);
    this.#addTip(slot, a, b, links[numbers[from]].maxLength, links[numbers[to]].maxLength);
  }

  /** The tip of the triangle over two places, at given distances from both. */
  #addTip(slot: number, a: number, b: number, fromA: number, fromB: number): void {
    const { x, y } = this.#particles;
    const base = this.distance(a, b);
    const ux = (this.xOf(b) - this.xOf(a)) / base;
    const uy = (this.yOf(b) - this.yOf(a)) / base;
    const along = (fromA * fromA - fromB * fromB + base * base) / (2 * base);
    const height = Math.sqrt(Math.max(0, fromA * fromA - along * along));
    const isLeft = (x[b] - x[a]) * (y[slot] - y[a]) - (y[b] - y[a]) * (x[slot] - x[a]) > 0;
    const across = isLeft ? height : -height;
    this.#places.set(slot, {
      x: this.xOf(a) + ux * along - uy * across,
      y: this.yOf(a) + uy * along + ux * across,
    });
  }
}

function otherEnd(near: Int32Array, far: Int32Array, link: number, slot: number): number {
  return near[link] === slot ? far[link] : near[link];
}

function length(x: number, y: number): number {
  return Math.sqrt(x * x + y * y);
}

/** The slots of each connected part of a graph. */
export function connectedParts({ slots, near, far, first, links }: LinkGraph): number[][] {
  const seen = new Uint8Array(slots);
  const parts: number[][] = [];
  for (let start = 0; start < slots; start++) {
    if (seen[start] === 1 || first[start + 1] === first[start]) continue;
    const part = [start];
    seen[start] = 1;
    for (const slot of part) {
      for (let i = first[slot]; i < first[slot + 1]; i++) {
        const other = otherEnd(near, far, links[i], slot);
        if (other < 0 || seen[other] === 1) continue;
        seen[other] = 1;
        part.push(other);
      }
    }
    parts.push(part);
  }
  return parts;
}
