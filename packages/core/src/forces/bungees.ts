import { Springs } from './springs.ts';

/**
 * Bungee cords, each between two particles or a particle and a fixed point: springs that pull while they are longer than
 * at rest and are slack otherwise. Everything else is as with `Springs`.
 *
 * @example
 * ```ts
 * const bungees = world.addForce(new Bungees());
 * bungees.add(bridge, jumper, { stiffness: 60, restLength: 10, damping: 5 });
 * ```
 */
export class Bungees extends Springs {
  constructor() {
    super('bungee');
  }
}
