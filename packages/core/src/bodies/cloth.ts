import { DistanceLink } from '../links/distance-link.ts';
import { requireFinite, requireInteger, requireOneOf, requireOptions, requirePositive, wrong } from '../math/checks.ts';
import { aggregate } from './aggregate.ts';
import { checkedShares, type SharedOptions } from './body-options.ts';
import type { LinkPlan } from './body-parts.ts';
import type { BodyPlan } from './body-plan.ts';

/** How a cloth is made. */
export interface ClothOptions extends SharedOptions {
  /** Centre. Unit: m. */
  x: number;
  y: number;
  /** From the first column to the last. Unit: m. */
  width: number;
  /** From the first row to the last. Unit: m. */
  height: number;
  /** How many particles there are in a row, 2 to 1000. */
  columns: number;
  /** How many rows there are, 2 to 1000. */
  rows: number;
  /** Which particles stay where they are. Column 0 is on the left, row 0 at the top. @default none */
  pinned?: 'top' | 'corners' | ((column: number, row: number) => boolean);
  /** What a thread is between two knots: a cable, which may be slack, or a rod. @default 'cable' */
  kind?: 'cable' | 'rod';
}

const MOST = 1000;

/**
 * A cloth or net in the plane, to hand to `World.addBody`: rows of particles, each joined to its neighbours in the row and the
 * column. Row after row from the upper left, they are equal shares of the mass, but that pinned ones have an infinite mass. With
 * `breakStrain` and `compliance` it tears where it is pulled.
 *
 * @example
 * ```ts
 * world.addBody(cloth({ x: 0, y: 2, width: 2, height: 2, columns: 20, rows: 20, mass: 0.5, pinned: 'top', breakForce: 30 }));
 * world.addBody(cloth({ x: 0, y: 2, width: 3, height: 1, columns: 30, rows: 10, pinned: (column) => column % 5 === 0 }));
 * ```
 */
export function cloth(options: ClothOptions): BodyPlan {
  requireOptions('cloth', 'options', options, '{ x: 0, y: 1, width: 1, height: 1, columns: 10, rows: 10 }');
  const { x, y, width, height, columns, rows, pinned, kind = 'cable', ...shared } = options;
  const { particle, giving, mass } = checkedShares('cloth', shared);
  requireFinite('cloth', 'x', x, 'metres');
  requireFinite('cloth', 'y', y, 'metres');
  requirePositive('cloth', 'width', width, 'metres');
  requirePositive('cloth', 'height', height, 'metres');
  requireInteger('cloth', 'columns', columns, 2, MOST);
  requireInteger('cloth', 'rows', rows, 2, MOST);
  requireOneOf('cloth', 'kind', kind, ['cable', 'rod']);
  const stays = checkedPins(pinned, columns);
  const dx = width / (columns - 1);
  const dy = height / (rows - 1);
  const particles = Array.from({ length: columns * rows }, (_, place) => {
    const column = place % columns;
    const row = (place - column) / columns;
    return {
      ...particle,
      x: x - width / 2 + column * dx,
      y: y + height / 2 - row * dy,
      mass: stays(column, row) ? Infinity : mass / (columns * rows),
    };
  });
  const thread = (a: number, b: number, length: number): LinkPlan => {
    const limits = { kind, minLength: kind === 'rod' ? length : 0, maxLength: length, ...giving };
    return { a, b, join: (p, q) => new DistanceLink('cloth', p, q, limits) };
  };
  const links: LinkPlan[] = [];
  for (let place = 0; place < columns * rows; place++) {
    if (place % columns > 0) links.push(thread(place - 1, place, dx));
    if (place >= columns) links.push(thread(place - columns, place, dy));
  }
  return aggregate({ kind: 'cloth', closed: false, particles, links });
}

function checkedPins(pinned: ClothOptions['pinned'], columns: number): (column: number, row: number) => boolean {
  switch (pinned) {
    case undefined:
      return () => false;
    case 'top':
      return (_, row) => row === 0;
    case 'corners':
      return (column, row) => row === 0 && (column === 0 || column === columns - 1);
    default:
      if (typeof pinned === 'function') return pinned;
      throw wrong('cloth', "pinned must be 'top', 'corners' or a function of column and row", pinned);
  }
}
