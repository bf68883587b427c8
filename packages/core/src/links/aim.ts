import type { ForestTable } from './forest-table.ts';

/** The side of a link that is at both of its limits at once. */
export const ROD = 2;

/** A taut cable counts as taut up to this share short of its length, as long as it pulls. */
const NEAR = 0.02;
/** It jerks again when it was shorter than this share. */
const LOOSE = 0.001;
const ROUNDING = 1e-9;

/** Decides at which of its limits a link is. Writes `side` and `taut`. @returns The length to aim at. Unit: m. */
export function aim(t: ForestTable, k: number, dd: number, r: number, again: boolean): number {
  const max = t.maxLength[k];
  const min = t.minLength[k];
  if (again) return t.side[k] < 0 ? min : Math.min(max, Number.MAX_VALUE);
  const jerks = t.taut[k] === 0 && t.restitution[k] > 0;
  t.taut[k] = r > (1 - LOOSE) * max || r < (1 + LOOSE) * min ? 1 : 0;
  if (r > (1 - ROUNDING) * max || (t.tension[k] > 0 && r > (1 - NEAR) * max)) {
    t.side[k] = 1;
    const length = Math.sqrt(dd);
    return jerks ? Math.min(max, length - t.restitution[k] * (r - length)) : max;
  }
  if (r < (1 + ROUNDING) * min || (t.tension[k] < 0 && r < (1 + NEAR) * min)) {
    t.side[k] = -1;
    const length = Math.sqrt(dd);
    return jerks ? Math.max(min, length + t.restitution[k] * (length - r)) : min;
  }
  t.side[k] = 0;
  return r;
}
