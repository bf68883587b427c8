import { Box, Circle, Vec2, World } from 'planck';

const world = new World({ gravity: new Vec2(0, -9.81) });
const ground = world.createBody();
ground.createFixture({ shape: new Box(2, 1, new Vec2(0, -1)) });
ground.createFixture({ shape: new Box(1, 10, new Vec2(-2, 0)) });
ground.createFixture({ shape: new Box(1, 10, new Vec2(2, 0)) });
const discs = [0.5, 1.1, 1.7].map((y) => {
  const body = world.createBody({ type: 'dynamic', position: new Vec2(0, y) });
  body.createFixture({ shape: new Circle(0.25), density: 1 });
  return body;
});
world.step(1 / 60);
export const heights = discs.map((body) => body.getPosition().y);
