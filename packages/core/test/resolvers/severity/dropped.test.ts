import { explicitEuler, HalfPlane, semiImplicitEuler, World } from '@mass/core';
import { describe, expect, it } from 'vitest';

/** How far a disc that was dropped still moves in ten seconds, after three. Unit: m. */
function unrest(integrator: typeof semiImplicitEuler, restitution: number, radius: number, height: number): number {
  const world = new World({ gravity: { x: 0, y: -9.81 }, integrator });
  const disc = world.addParticle({ x: 0, y: radius + height, radius, restitution });
  world.addShape(new HalfPlane());
  for (let step = 0; step < 180; step++) world.step(1 / 60);
  const { y } = disc;
  let moved = 0;
  for (let step = 0; step < 600; step++) {
    world.step(1 / 60);
    moved = Math.max(moved, Math.abs(disc.y - y));
  }
  return moved;
}

describe('a disc that is dropped on a half-plane', () => {
  const drops = [0.05, 0.1, 0.25, 0.5, 1, 2].flatMap((radius) =>
    Array.from({ length: 31 }, (_, n) => [radius, n * 0.01] as const),
  );

  it('[R1] comes to rest at restitution 0.5, from any height and of any size, in both integrators', () => {
    for (const integrator of [semiImplicitEuler, explicitEuler]) {
      expect(Math.max(...drops.map(([radius, height]) => unrest(integrator, 0.5, radius, height)))).toBeLessThan(1e-6);
    }
  });

  it('[R1] comes to rest at restitution 0.7 in the semi-implicit one', () => {
    expect(Math.max(...drops.map(([radius, height]) => unrest(semiImplicitEuler, 0.7, radius, height)))).toBeLessThan(
      1e-6,
    );
  });
});
