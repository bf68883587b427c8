import { requireInteger, requireOptions, requirePositive, requireVector, wrong } from '../math/checks.ts';
import { cos, sin } from '../math/trigonometry.ts';
import type { Vec2 } from '../math/vec2.ts';
import type { BodyOptions } from './body-options.ts';
import type { BodyPlan } from './body-plan.ts';
import { stiffBody } from './stiff-body.ts';

/** How a regular polygon is made. */
export interface RegularPolygonOptions extends BodyOptions {
  /** How many corners, 3 to 256. */
  sides: number;
  /** Distance of the corners from the centre. Unit: m. */
  circumradius: number;
}

/** How a polygon is made. */
export interface PolygonBodyOptions extends Omit<BodyOptions, 'x' | 'y'> {
  /** The corners in order, either way round, 3 to 256 of them; the last is joined to the first. Unit: m. */
  points: readonly Readonly<Vec2>[];
  /** Where the mean of the corners comes to lie. Unit: m. @default where it is */
  x?: number;
  y?: number;
}

const MOST_CORNERS = 256;

/**
 * A polygon of equal sides, to hand to `World.addBody`: it stands on one of its sides while the angle is 0, and its particles
 * go counter-clockwise from that side's left end. It has the rods of `polygon`.
 */
export function regularPolygon(options: RegularPolygonOptions): BodyPlan {
  const where = 'regularPolygon';
  requireOptions(where, 'options', options, '{ x: 0, y: 1, sides: 5, circumradius: 1 }');
  const { sides, circumradius, ...others } = options;
  requireInteger(where, 'sides', sides, 3, MOST_CORNERS);
  requirePositive(where, 'circumradius', circumradius, 'metres');
  const corners: Vec2[] = [];
  for (let corner = 0; corner < sides; corner++) {
    const angle = ((2 * corner - 1) / sides) * Math.PI; // from straight down
    corners.push({ x: circumradius * sin(angle), y: -circumradius * cos(angle) });
  }
  return stiffBody(where, corners, others, 'polygon');
}

/**
 * A body of any outline, to hand to `World.addBody`: equal masses at its corners, and rods between all of them up to eight
 * corners; beyond, along the edges and from each corner to three that are far apart, which is rigid whatever the outline.
 *
 * @example
 * ```ts
 * world.addBody(polygon({ points: [{ x: 0, y: 0 }, { x: 2, y: 0 }, { x: 2, y: 1 }, { x: 1, y: 2 }], mass: 3 }));
 * ```
 */
export function polygon(options: PolygonBodyOptions): BodyPlan {
  const where = 'polygon';
  requireOptions(where, 'options', options, '{ points: [{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0, y: 1 }] }');
  const { points, ...others } = options;
  if (!Array.isArray(points)) {
    throw wrong(where, 'points must be a list of { x, y }, in metres', points);
  }
  requireInteger(where, 'the number of points', points.length, 3, MOST_CORNERS);
  for (const [index, point] of points.entries()) requireVector(where, `points[${index}]`, point, 'metres');
  const mean = { x: 0, y: 0 };
  for (const point of points) {
    mean.x += point.x / points.length;
    mean.y += point.y / points.length;
  }
  const corners = points.map((point) => ({ x: point.x - mean.x, y: point.y - mean.y }));
  return stiffBody(where, corners, { x: mean.x, y: mean.y, ...others });
}
