import { requireFinite, requireOptions, requireOrdered, requirePositive, requireVector } from '../math/checks.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { SlotList } from '../particles/slot-list.ts';

/** A part of the world. A game's own is made the same way, or as a function of one slot: see `inRegion`. */
export interface Region {
  /**
   * Picks those targets whose centre is inside.
   * @param particles - Positions, and whatever else it goes by.
   * @param targets - The slots to choose from.
   * @param picked - To fill from the front with indices of `targets.slots`, in rising order; has room for all of them.
   * @returns How many are inside.
   */
  pick(particles: ParticleArrays, targets: SlotList, picked: Int32Array): number;
}

/** The edges of a box. Unit: m. */
export interface BoxRegionOptions {
  /** Left edge. @default -Infinity */
  minX?: number;
  /** Lower edge. @default -Infinity */
  minY?: number;
  /** Right edge, at least minX. @default Infinity */
  maxX?: number;
  /** Upper edge, at least minY. @default Infinity */
  maxY?: number;
}

/** An upright box, its edges included. An edge that is left out is infinitely far away. */
export function insideBox(box: Readonly<BoxRegionOptions>): Region & Readonly<Required<BoxRegionOptions>> {
  requireOptions('insideBox', 'box', box, '{ minX: 0, minY: 0, maxX: 4, maxY: 2 }');
  const { minX = -Infinity, minY = -Infinity, maxX = Infinity, maxY = Infinity } = box;
  requireOrdered('insideBox', 'x', minX, maxX, 'm');
  requireOrdered('insideBox', 'y', minY, maxY, 'm');
  return {
    minX,
    minY,
    maxX,
    maxY,
    pick({ x, y }, { slots, count }, picked) {
      let inside = 0;
      for (let t = 0; t < count; t++) {
        const i = slots[t];
        if (x[i] >= minX && x[i] <= maxX && y[i] >= minY && y[i] <= maxY) picked[inside++] = t;
      }
      return inside;
    },
  };
}

/** A disc, its edge included: centre x, y and radius in m. */
export function insideDisc(disc: Readonly<{ x: number; y: number; radius: number }>): Region {
  requireVector('insideDisc', 'disc', disc, 'metres');
  requirePositive('insideDisc', 'radius', disc.radius, 'metres');
  const { x: cx, y: cy, radius } = disc;
  return {
    pick({ x, y }, { slots, count }, picked) {
      let inside = 0;
      for (let t = 0; t < count; t++) {
        const dx = x[slots[t]] - cx;
        const dy = y[slots[t]] - cy;
        if (dx * dx + dy * dy <= radius * radius) picked[inside++] = t;
      }
      return inside;
    },
  };
}

/**
 * One side of a line, the line included: what lies from `point` in the direction of `normal`, or beside it.
 * @param point - A point of the line. Unit: m.
 * @param normal - The way from the line into the region, of any length but 0.
 */
export function insideHalfPlane(point: Readonly<Vec2>, normal: Readonly<Vec2>): Region {
  requireVector('insideHalfPlane', 'point', point, 'metres');
  requireVector('insideHalfPlane', 'normal', normal, '');
  const { x: nx, y: ny } = normal;
  if (nx === 0 && ny === 0) {
    throw new RangeError('insideHalfPlane: normal must point into the region; got (0, 0), which has no direction.');
  }
  const offset = nx * point.x + ny * point.y;
  requireFinite('insideHalfPlane', 'the product of point and normal', offset, '');
  return {
    pick({ x, y }, { slots, count }, picked) {
      let inside = 0;
      for (let t = 0; t < count; t++) {
        const i = slots[t];
        if (nx * x[i] + ny * y[i] >= offset) picked[inside++] = t;
      }
      return inside;
    },
  };
}
