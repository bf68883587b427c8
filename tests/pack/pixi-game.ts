// The same in a container of PixiJS.
import { World } from '@mass/core';
import { Camera, type Renderer } from '@mass/core/view';
import { PixiRenderer } from '@mass/pixi';
import { Application, type Container } from 'pixi.js';

/** Draws one frame of a falling ball. Returns the ball's height, in metres. */
export async function play(): Promise<number> {
  const app = new Application();
  await app.init({ width: 800, height: 600 });
  const world = new World({ gravity: { x: 0, y: -9.81 } });
  const ball = world.addParticle({ x: 0, y: 5, mass: 1, radius: 0.2 });
  const renderer: Renderer<Container> = new PixiRenderer(app.stage);
  world.step(1 / 60);
  renderer.render(world, new Camera({ width: 800, height: 600, y: 3 }), 1);
  renderer.destroy();
  return ball.y;
}
