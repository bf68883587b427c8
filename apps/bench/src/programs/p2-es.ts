import { Body, Circle, Plane, World } from 'p2-es';

const world = new World({ gravity: [0, -9.81] });
for (const [x, angle] of [
  [0, 0],
  [-1, -Math.PI / 2],
  [1, Math.PI / 2],
]) {
  const wall = new Body({ mass: 0, position: [x, 0], angle });
  wall.addShape(new Plane());
  world.addBody(wall);
}
const discs = [0.5, 1.1, 1.7].map((y) => {
  const body = new Body({ mass: 1, position: [0, y] });
  body.addShape(new Circle({ radius: 0.25 }));
  world.addBody(body);
  return body;
});
world.step(1 / 60);
export const heights = discs.map(({ position }) => position[1]);
