import type Box2D from 'box2d3-wasm';
import type { Build, Effort, Engine, Simulation } from '../engine.ts';
import type { Scene } from '../scene.ts';
import { type Pose, slabsOf, writeCorners } from './parts.ts';

type B2 = Awaited<ReturnType<typeof Box2D>>;
type BodyId = ReturnType<B2['b2CreateBody']>;

const SUB_STEPS = 4;

function build(b2: B2, scene: Scene, effort: Effort): Simulation {
  const worldDef = b2.b2DefaultWorldDef();
  worldDef.gravity.Set(0, -scene.gravity);
  worldDef.enableSleep = scene.sleep;
  const world = b2.b2CreateWorld(worldDef);
  const shapeDef = b2.b2DefaultShapeDef();
  shapeDef.material.friction = scene.friction;
  shapeDef.material.restitution = scene.restitution;
  const none = { dynamic: false, fast: false, vx: 0, vy: 0, damping: 0 };

  function addBody(x: number, y: number, options: Partial<typeof none>): BodyId {
    const { dynamic, fast, vx, vy, damping } = { ...none, ...options };
    const def = b2.b2DefaultBodyDef();
    def.type = dynamic ? b2.b2BodyType.b2_dynamicBody : b2.b2BodyType.b2_staticBody;
    def.position.Set(x, y);
    def.linearVelocity.Set(vx, vy);
    def.linearDamping = damping;
    def.isBullet = fast;
    const id = b2.b2CreateBody(world, def);
    def.delete();
    return id;
  }

  for (const { x, y, width, height } of [...slabsOf(scene), ...scene.bars]) {
    b2.b2CreatePolygonShape(addBody(x, y, {}), shapeDef, b2.b2MakeBox(width / 2, height / 2));
  }
  const damped = scene.drag?.by === 'engine' ? scene.drag.k1 : 0;
  const circle = new b2.b2Circle();
  if (!scene.collide) shapeDef.filter.maskBits = 0;
  const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed = false, fast = false }) => {
    const id = addBody(x, y, { dynamic: !fixed, fast, vx, vy, damping: damped / mass });
    circle.radius = radius;
    shapeDef.density = mass / (Math.PI * radius * radius);
    b2.b2CreateCircleShape(id, shapeDef, circle);
    return id;
  });
  const crates = scene.crates.map(({ x, y, size, mass }) => {
    const id = addBody(x, y, { dynamic: true });
    shapeDef.density = mass / (size * size);
    b2.b2CreatePolygonShape(id, shapeDef, b2.b2MakeSquare(size / 2));
    return id;
  });
  for (const { a, b, length } of scene.links) {
    const def = b2.b2DefaultDistanceJointDef();
    def.base.bodyIdA = discs[a];
    def.base.bodyIdB = discs[b];
    def.length = length;
    b2.b2CreateDistanceJoint(world, def);
    def.delete();
  }
  const { drag } = scene;
  const force = new b2.b2Vec2(0, 0);
  const pose: Pose = { x: 0, y: 0, cos: 1, sin: 0 };
  return {
    step() {
      if (drag?.by === 'function') {
        for (const id of discs) {
          const velocity = b2.b2Body_GetLinearVelocity(id);
          force.Set(-drag.k1 * velocity.x, -drag.k1 * velocity.y);
          b2.b2Body_ApplyForceToCenter(id, force, true);
          velocity.delete();
        }
      }
      b2.b2World_Step(world, scene.dt, SUB_STEPS * effort);
    },
    readPositions(into) {
      discs.forEach((id, i) => {
        const position = b2.b2Body_GetPosition(id);
        into[2 * i] = position.x;
        into[2 * i + 1] = position.y;
        position.delete();
      });
    },
    readVelocities(into) {
      discs.forEach((id, i) => {
        const velocity = b2.b2Body_GetLinearVelocity(id);
        into[2 * i] = velocity.x;
        into[2 * i + 1] = velocity.y;
        velocity.delete();
      });
    },
    readCorners(into) {
      crates.forEach((id, i) => {
        const position = b2.b2Body_GetPosition(id);
        const rotation = b2.b2Body_GetRotation(id);
        pose.x = position.x;
        pose.y = position.y;
        pose.cos = rotation.c;
        pose.sin = rotation.s;
        writeCorners(into, i, pose, scene.crates[i].size);
        position.delete();
        rotation.delete();
      });
    },
  };
}

/** One of the two builds, by its file: the entry of the package chooses one by what the machine can do. */
async function load(file: string): Promise<Build> {
  const url = new URL(file, import.meta.resolve('box2d3-wasm'));
  const module: { default: typeof Box2D } = await import(url.href);
  const b2 = await module.default({ pthreadCount: 0 });
  return (scene, effort) => build(b2, scene, effort);
}

const settings = [
  '`b2DefaultWorldDef`, 4 sub-steps, as its documentation recommends; walls are boxes 10 m thick, links rigid `b2DistanceJoint`s',
  'one thread: worlds of games of this size gain nothing from more, and every other engine here has one',
  'fast discs are bullets',
];

export const box2d3: Engine = {
  id: 'box2d3-wasm',
  package: 'box2d3-wasm',
  language: 'WASM',
  settings: ['the build with SIMD ("deluxe")', ...settings],
  load: () => load('deluxe/Box2D.deluxe.mjs'),
};

export const box2d3Compat: Engine = {
  id: 'box2d3-wasm-compat',
  package: 'box2d3-wasm',
  language: 'WASM',
  settings: ['the build without SIMD ("compat")', ...settings],
  load: () => load('compat/Box2D.compat.mjs'),
};
