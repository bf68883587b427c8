import { requireOptions, requirePositive } from '../math/checks.ts';
import type { BodyOptions } from './body-options.ts';
import type { BodyPlan } from './body-plan.ts';
import { stiffBody } from './stiff-body.ts';

/** How a box is made. */
export interface BoxBodyOptions extends BodyOptions {
  /** Distance of the corner particles, along x while the angle is 0. Unit: m. */
  width: number;
  /** The same along y. Unit: m. */
  height: number;
}

/**
 * A box, to hand to `World.addBody`: four particles at its corners, from the lower left counter-clockwise, and six rods. All
 * of its mass is in the corners, so its moment of inertia is m·(w² + h²)/4, three times that of a full box.
 *
 * @example
 * ```ts
 * const crate = world.addBody(box({ x: 0, y: 5, width: 1, height: 1, mass: 4, radius: 0.1, angularVelocity: 2 }));
 * ```
 */
export function box(options: BoxBodyOptions): BodyPlan {
  requireOptions('box', 'options', options, '{ x: 0, y: 1, width: 1, height: 1 }');
  const { width, height, ...others } = options;
  requirePositive('box', 'width', width, 'metres');
  requirePositive('box', 'height', height, 'metres');
  const x = width / 2;
  const y = height / 2;
  return stiffBody(
    'box',
    [
      { x: -x, y: -y },
      { x, y: -y },
      { x, y },
      { x: -x, y },
    ],
    others,
  );
}
