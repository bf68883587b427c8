import Rapier from '@dimforge/rapier2d-compat';

await Rapier.init();
const world = new Rapier.World({ x: 0, y: -9.81 });
for (const [x, y, halfWidth, halfHeight] of [
  [0, -1, 2, 1],
  [-2, 9, 1, 10],
  [2, 9, 1, 10],
]) {
  world.createCollider(Rapier.ColliderDesc.cuboid(halfWidth, halfHeight).setTranslation(x, y));
}
const discs = [0.5, 1.1, 1.7].map((y) => {
  const body = world.createRigidBody(Rapier.RigidBodyDesc.dynamic().setTranslation(0, y));
  world.createCollider(Rapier.ColliderDesc.ball(0.25), body);
  return body;
});
world.step();
export const heights = discs.map((body) => body.translation().y);
