// The same on a canvas, with a loop as a game has it.
import { CanvasRenderer } from '@mass/canvas2d';
import { FixedTimestep, World } from '@mass/core';
import { Camera, type Style } from '@mass/core/view';

const style: Style = {};

/** Draws one frame of a falling ball into a canvas of 800 by 600 CSS pixels. Returns the ball's height, in metres. */
export function play(canvas: HTMLCanvasElement | OffscreenCanvas): number {
  const world = new World({ gravity: { x: 0, y: -9.81 } });
  const ball = world.addParticle({ x: 0, y: 5, mass: 1, radius: 0.2 });
  const camera = new Camera({ width: 800, height: 600, y: 3 });
  const renderer = new CanvasRenderer(canvas, { style });
  const timestep = new FixedTimestep();
  timestep.advance(1 / 30, (dt) => world.step(dt));
  renderer.render(world, camera, timestep.alpha);
  renderer.destroy();
  return ball.y;
}
