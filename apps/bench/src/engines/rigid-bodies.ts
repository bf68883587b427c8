// What adapters of engines of rigid bodies share.
import type { Simulation } from '../engine.ts';
import type { Bar, Scene } from '../scene.ts';

const THICKNESS = 10;
const HEIGHT = 1000;

/** Where a rigid body is and how it is turned. */
export interface Pose {
  x: number;
  y: number;
  cos: number;
  sin: number;
}

/** A scene in terms of an engine's own handles of bodies. All numbers in SI units. */
export interface RigidBodies<Body> {
  readonly scene: Scene;
  readonly discs: readonly Body[];
  readonly crates: readonly Body[];
  step(): void;
  /** Write x and y. */
  position(body: Body, into: { x: number; y: number }): void;
  velocity(body: Body, into: { x: number; y: number }): void;
  /** Writes cos and sin. */
  rotation(body: Body, into: { cos: number; sin: number }): void;
  /** Applies a force to the centre for the next step. */
  push(body: Body, fx: number, fy: number): void;
}

/** The simulation of a scene that an engine has built, with the user's function for drag where the scene has one. */
export function simulationOf<Body>(world: RigidBodies<Body>): Simulation {
  const { discs, crates, scene } = world;
  const { drag } = scene;
  const at = { x: 0, y: 0 };
  const pose: Pose = { x: 0, y: 0, cos: 1, sin: 0 };
  function pushAll(k1: number): void {
    for (const disc of discs) {
      world.velocity(disc, at);
      world.push(disc, -k1 * at.x, -k1 * at.y);
    }
  }
  return {
    step() {
      if (drag?.by === 'function') pushAll(drag.k1);
      world.step();
    },
    readPositions(into) {
      for (let i = 0; i < discs.length; i++) {
        world.position(discs[i], at);
        into[2 * i] = at.x;
        into[2 * i + 1] = at.y;
      }
    },
    readVelocities(into) {
      for (let i = 0; i < discs.length; i++) {
        world.velocity(discs[i], at);
        into[2 * i] = at.x;
        into[2 * i + 1] = at.y;
      }
    },
    readCorners(into) {
      crates.forEach((crate, i) => {
        world.position(crate, pose);
        world.rotation(crate, pose);
        writeCorners(into, i, pose, scene.crates[i].size);
      });
    },
  };
}

/** Writes the four corners of a square crate, counter-clockwise. */
function writeCorners(into: Float64Array, crate: number, { x, y, cos, sin }: Pose, size: number): void {
  for (let k = 0; k < 4; k++) {
    const u = ((k === 1 || k === 2 ? 1 : -1) * size) / 2;
    const v = ((k < 2 ? -1 : 1) * size) / 2;
    into[8 * crate + 2 * k] = x + cos * u - sin * v;
    into[8 * crate + 2 * k + 1] = y + sin * u + cos * v;
  }
}

/** All that is immovable as bars, the container as three thick ones: for engines that know no half-plane. */
export function barsOf({ container, bars }: Scene): readonly Bar[] {
  if (!container) return bars;
  const { left, right, floor } = container;
  const y = floor + HEIGHT / 2 - THICKNESS;
  return [
    ...bars,
    { x: (left + right) / 2, y: floor - THICKNESS / 2, width: right - left + 2 * THICKNESS, height: THICKNESS },
    { x: left - THICKNESS / 2, y, width: THICKNESS, height: HEIGHT },
    { x: right + THICKNESS / 2, y, width: THICKNESS, height: HEIGHT },
  ];
}

/** Linear damping, 1/s, by which an engine is told of drag on a body of the given mass. */
export function dampingOf({ drag }: Scene, mass: number): number {
  return drag?.by === 'engine' ? drag.k1 / mass : 0;
}
