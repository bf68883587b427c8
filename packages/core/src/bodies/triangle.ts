import { requireOptions, requirePositive } from '../math/checks.ts';
import type { BodyOptions } from './body-options.ts';
import type { BodyPlan } from './body-plan.ts';
import { stiffBody } from './stiff-body.ts';

/** How a triangle is made. */
export interface TriangleBodyOptions extends BodyOptions {
  /** Length of the base, along x while the angle is 0. Unit: m. */
  width: number;
  /** From the base to the tip, above its middle. Unit: m. @default that of equal sides, width · √3 / 2 */
  height?: number;
}

/**
 * A triangle with two equal sides, to hand to `World.addBody`: three particles, from the lower left counter-clockwise, and
 * three rods. For any other triangle see `polygon`.
 */
export function triangle(options: TriangleBodyOptions): BodyPlan {
  requireOptions('triangle', 'options', options, '{ x: 0, y: 1, width: 1 }');
  const { width, height = (width * Math.sqrt(3)) / 2, ...others } = options;
  requirePositive('triangle', 'width', width, 'metres');
  requirePositive('triangle', 'height', height, 'metres');
  const x = width / 2;
  const y = -height / 3;
  return stiffBody(
    'triangle',
    [
      { x: -x, y },
      { x, y },
      { x: 0, y: (height * 2) / 3 },
    ],
    others,
  );
}
