import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Engine, Simulation } from '../engine.ts';
import type { Scene } from '../scene.ts';
import { barsOf, dampingOf, simulationOf } from './rigid-bodies.ts';

type B2 = typeof Box2D & EmscriptenModule;

const VELOCITY_ITERATIONS = 8;
const POSITION_ITERATIONS = 3;

function build(b2: B2, scene: Scene, effort: number): Simulation {
  const vector = (x: number, y: number): Box2D.b2Vec2 => new b2.b2Vec2(x, y);
  const world = new b2.b2World(vector(0, -scene.gravity));
  world.SetAllowSleeping(scene.sleep);

  function addFixture(body: Box2D.b2Body, shape: Box2D.b2Shape, density: number): void {
    const fixture = new b2.b2FixtureDef();
    fixture.shape = shape;
    fixture.density = density;
    fixture.friction = scene.friction;
    fixture.restitution = scene.restitution;
    body.CreateFixture(fixture);
  }
  function boxOf(width: number, height: number): Box2D.b2PolygonShape {
    const shape = new b2.b2PolygonShape();
    shape.SetAsBox(width / 2, height / 2);
    return shape;
  }

  for (const { x, y, width, height } of barsOf(scene)) {
    const def = new b2.b2BodyDef();
    def.position = vector(x, y);
    addFixture(world.CreateBody(def), boxOf(width, height), 0);
  }
  const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed, fast = false }) => {
    const def = new b2.b2BodyDef();
    if (!fixed) def.type = b2.b2_dynamicBody;
    def.position = vector(x, y);
    def.linearVelocity = vector(vx, vy);
    def.linearDamping = dampingOf(scene, mass);
    def.bullet = fast;
    const body = world.CreateBody(def);
    if (scene.collide) {
      const shape = new b2.b2CircleShape();
      shape.m_radius = radius;
      addFixture(body, shape, mass / (Math.PI * radius * radius));
    } else {
      const point = new b2.b2MassData();
      point.mass = mass;
      body.SetMassData(point);
    }
    return body;
  });
  const crates = scene.crates.map(({ x, y, size, mass }) => {
    const def = new b2.b2BodyDef();
    def.type = b2.b2_dynamicBody;
    def.position = vector(x, y);
    const body = world.CreateBody(def);
    addFixture(body, boxOf(size, size), mass / (size * size));
    return body;
  });
  for (const { a, b, length } of scene.links) {
    const def = new b2.b2DistanceJointDef();
    def.bodyA = discs[a];
    def.bodyB = discs[b];
    def.length = length;
    def.minLength = length;
    def.maxLength = length;
    world.CreateJoint(def);
  }
  const force = vector(0, 0);
  return simulationOf<Box2D.b2Body>({
    ...{ scene, discs, crates },
    step: () => world.Step(scene.dt, VELOCITY_ITERATIONS * effort, POSITION_ITERATIONS * effort),
    position(body, into) {
      const { x, y } = body.GetPosition();
      into.x = x;
      into.y = y;
    },
    velocity(body, into) {
      const { x, y } = body.GetLinearVelocity();
      into.x = x;
      into.y = y;
    },
    rotation(body, into) {
      into.cos = Math.cos(body.GetAngle());
      into.sin = Math.sin(body.GetAngle());
    },
    push(body, fx, fy) {
      force.Set(fx, fy);
      body.ApplyForceToCenter(force, true);
    },
  });
}

export const box2d: Engine = {
  id: 'box2d-wasm',
  package: 'box2d-wasm',
  language: 'WASM',
  settings: [
    'Box2D 2.4.1, the build with SIMD, which its entry chooses on this machine',
    '8 velocity and 3 position iterations, as its manual recommends',
    'walls are boxes 10 m thick, links rigid distance joints, fast discs are bullets',
    'where nothing collides discs have no fixture',
  ],
  async load() {
    const { default: factory } = await import('box2d-wasm');
    // Its loader would fetch the file, which Node.js does from the network alone.
    const file = createRequire(import.meta.url)
      .resolve('box2d-wasm')
      .replace('entry.js', 'Box2D.simd.wasm');
    const b2 = await factory({ wasmBinary: new Uint8Array(readFileSync(file)).buffer });
    return (scene, effort) => build(b2, scene, effort);
  },
};
