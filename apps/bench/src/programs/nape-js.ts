import initNape from '@newkrok/nape-js';
import type { NapeGlobals } from '../engines/nape-js.ts';

const globals = globalThis as unknown as NapeGlobals;
globals.window = globalThis;
initNape();
const { space, geom, phys, shape } = globals.nape;
const world = new space.Space(new geom.Vec2(0, 981));
const { Polygon } = shape;
for (const [x, y, width, height] of [
  [0, 50, 400, 100],
  [-150, -400, 100, 1000],
  [150, -400, 100, 1000],
]) {
  const wall = new phys.Body(phys.BodyType.get_STATIC(), new geom.Vec2(x, y));
  wall.get_shapes().add(new Polygon(Polygon.box(width, height)));
  wall.set_space(world);
}
const discs = [-50, -110, -170].map((y) => {
  const body = new phys.Body(phys.BodyType.get_DYNAMIC(), new geom.Vec2(0, y));
  body.get_shapes().add(new shape.Circle(25));
  body.set_space(world);
  return body;
});
world.step(1 / 60, 10, 10);
export const heights = discs.map((body) => body.get_position().get_y());
