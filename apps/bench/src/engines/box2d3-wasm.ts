import type Box2D from 'box2d3-wasm';
import type { Build, Effort, Engine, Simulation } from '../engine.ts';
import type { Scene } from '../scene.ts';
import { barsOf, dampingOf, simulationOf } from './rigid-bodies.ts';

type B2 = Awaited<ReturnType<typeof Box2D>>;
type BodyId = ReturnType<B2['b2CreateBody']>;
type BodyDef = ReturnType<B2['b2DefaultBodyDef']>;

const SUB_STEPS = 4;

function build(b2: B2, scene: Scene, effort: Effort): Simulation {
  const worldDef = b2.b2DefaultWorldDef();
  worldDef.gravity.Set(0, -scene.gravity);
  worldDef.enableSleep = scene.sleep;
  const world = b2.b2CreateWorld(worldDef);
  const shapeDef = b2.b2DefaultShapeDef();
  shapeDef.material.friction = scene.friction;
  shapeDef.material.restitution = scene.restitution;

  function addBody(x: number, y: number, configure?: (def: BodyDef) => void): BodyId {
    const def = b2.b2DefaultBodyDef();
    def.position.Set(x, y);
    configure?.(def);
    return b2.b2CreateBody(world, def);
  }

  for (const { x, y, width, height } of barsOf(scene)) {
    b2.b2CreatePolygonShape(addBody(x, y), shapeDef, b2.b2MakeBox(width / 2, height / 2));
  }
  const circle = new b2.b2Circle();
  const point = new b2.b2MassData();
  const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed = false, fast = false }) => {
    const body = addBody(x, y, (def) => {
      if (!fixed) def.type = b2.b2BodyType.b2_dynamicBody;
      def.linearVelocity.Set(vx, vy);
      def.linearDamping = dampingOf(scene, mass);
      def.isBullet = fast;
    });
    if (!scene.collide) {
      point.mass = mass;
      b2.b2Body_SetMassData(body, point);
      return body;
    }
    circle.radius = radius;
    shapeDef.density = mass / (Math.PI * radius * radius);
    b2.b2CreateCircleShape(body, shapeDef, circle);
    return body;
  });
  const crates = scene.crates.map(({ x, y, size, mass }) => {
    const body = addBody(x, y, (def) => {
      def.type = b2.b2BodyType.b2_dynamicBody;
    });
    shapeDef.density = mass / (size * size);
    b2.b2CreatePolygonShape(body, shapeDef, b2.b2MakeSquare(size / 2));
    return body;
  });
  for (const { a, b, length } of scene.links) {
    const def = b2.b2DefaultDistanceJointDef();
    def.base.bodyIdA = discs[a];
    def.base.bodyIdB = discs[b];
    def.length = length;
    b2.b2CreateDistanceJoint(world, def);
  }
  const force = new b2.b2Vec2(0, 0);
  return simulationOf<BodyId>({
    ...{ scene, discs, crates },
    step: () => b2.b2World_Step(world, scene.dt, SUB_STEPS * effort),
    position(body, into) {
      const position = b2.b2Body_GetPosition(body);
      into.x = position.x;
      into.y = position.y;
      position.delete();
    },
    velocity(body, into) {
      const velocity = b2.b2Body_GetLinearVelocity(body);
      into.x = velocity.x;
      into.y = velocity.y;
      velocity.delete();
    },
    rotation(body, into) {
      const rotation = b2.b2Body_GetRotation(body);
      into.cos = rotation.c;
      into.sin = rotation.s;
      rotation.delete();
    },
    push(body, fx, fy) {
      force.Set(fx, fy);
      b2.b2Body_ApplyForceToCenter(body, force, true);
    },
  });
}

/** One of the two builds, by its file: the entry of the package chooses by what the machine can do. */
async function load(file: string): Promise<Build> {
  const url = new URL(file, import.meta.resolve('box2d3-wasm'));
  const module: { default: typeof Box2D } = await import(url.href);
  const b2 = await module.default({ pthreadCount: 0 });
  return (scene, effort) => build(b2, scene, effort);
}

const settings = [
  'one thread, as all engines here have',
  '4 sub-steps and the defaults of `b2DefaultWorldDef`',
  'walls are boxes 10 m thick, links `b2DistanceJoint`s without spring; where nothing collides discs have no shape; fast discs are bullets',
];

export const box2d3: Engine = {
  id: 'box2d3-wasm',
  package: 'box2d3-wasm',
  language: 'WASM',
  settings: ['the build with SIMD, "deluxe"', ...settings],
  load: () => load('deluxe/Box2D.deluxe.mjs'),
};

export const box2d3Compat: Engine = {
  id: 'box2d3-wasm-compat',
  package: 'box2d3-wasm',
  language: 'WASM',
  settings: ['the build without SIMD, "compat"', ...settings],
  load: () => load('compat/Box2D.compat.mjs'),
};
