// A small game as its author would write it: the core alone, compiled without the DOM library.
import { Drag, type Particle, World } from '@mass/core';

const world = new World({ gravity: { x: 0, y: -9.81 } });
const target = world.addParticle({ x: 15, y: 1, mass: Infinity });
const ball: Particle = world.addParticle({ x: 0, y: 1, vx: 12, vy: 12, mass: 0.5, radius: 0.1 });
world.addForce(new Drag({ k1: 0.02, k2: 0 }), [ball]);

/** Throws the ball. Returns how far it flew, in metres. */
export function play(): number {
  while (ball.y > 0) world.step(1 / 60);
  if (target.x !== 15 || target.y !== 1) throw new Error(`the target moved to ${target.x}, ${target.y}`);
  return ball.x;
}
