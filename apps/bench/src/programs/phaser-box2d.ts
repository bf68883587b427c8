import {
  b2Body_GetPosition,
  b2BodyType,
  b2Circle,
  b2CreateBody,
  b2CreateCircleShape,
  b2CreatePolygonShape,
  b2CreateWorld,
  b2CreateWorldArray,
  b2DefaultBodyDef,
  b2DefaultShapeDef,
  b2DefaultWorldDef,
  b2MakeBox,
  b2Vec2,
  b2World_Step,
} from 'phaser-box2d/dist/PhaserBox2D.js';

b2CreateWorldArray();
const world = b2CreateWorld(b2DefaultWorldDef());
for (const [x, y, halfWidth, halfHeight] of [
  [0, -1, 2, 1],
  [-2, 9, 1, 10],
  [2, 9, 1, 10],
]) {
  const def = b2DefaultBodyDef();
  def.position = new b2Vec2(x, y);
  b2CreatePolygonShape(b2CreateBody(world, def), b2DefaultShapeDef(), b2MakeBox(halfWidth, halfHeight));
}
const discs = [0.5, 1.1, 1.7].map((y) => {
  const def = b2DefaultBodyDef();
  def.type = b2BodyType.b2_dynamicBody;
  def.position = new b2Vec2(0, y);
  const body = b2CreateBody(world, def);
  b2CreateCircleShape(body, b2DefaultShapeDef(), new b2Circle(new b2Vec2(0, 0), 0.25));
  return body;
});
b2World_Step(world, 1 / 60, 4);
export const heights = discs.map((body) => b2Body_GetPosition(body).y);
