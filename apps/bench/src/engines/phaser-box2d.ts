/// <reference path="./untyped.d.ts" />
import type { Engine } from '../engine.ts';
import { barsOf, dampingOf, simulationOf } from './rigid-bodies.ts';

const SUB_STEPS = 4;

export const phaserBox2d: Engine = {
  id: 'phaser-box2d',
  package: 'phaser-box2d',
  language: 'JavaScript',
  settings: [
    'the release build, `dist/PhaserBox2D.js`; 4 sub-steps and the defaults of `b2DefaultWorldDef`',
    'walls are boxes 10 m thick, links rigid distance joints, fast discs are bullets',
    'where nothing collides discs have no shape',
  ],
  async load() {
    const b2 = await import('phaser-box2d/dist/PhaserBox2D.js');
    return (scene, effort) => {
      b2.b2CreateWorldArray();
      const worldDef = b2.b2DefaultWorldDef();
      worldDef.gravity = new b2.b2Vec2(0, -scene.gravity);
      worldDef.enableSleep = scene.sleep;
      const world = b2.b2CreateWorld(worldDef);
      const shapeDef = b2.b2DefaultShapeDef();
      shapeDef.friction = scene.friction;
      shapeDef.restitution = scene.restitution;
      for (const { x, y, width, height } of barsOf(scene)) {
        const def = b2.b2DefaultBodyDef();
        def.position = new b2.b2Vec2(x, y);
        b2.b2CreatePolygonShape(b2.b2CreateBody(world, def), shapeDef, b2.b2MakeBox(width / 2, height / 2));
      }
      const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed, fast = false }) => {
        const def = b2.b2DefaultBodyDef();
        if (!fixed) def.type = b2.b2BodyType.b2_dynamicBody;
        def.position = new b2.b2Vec2(x, y);
        def.linearVelocity = new b2.b2Vec2(vx, vy);
        def.linearDamping = dampingOf(scene, mass);
        def.isBullet = fast;
        const body = b2.b2CreateBody(world, def);
        if (!scene.collide) {
          b2.b2Body_SetMassData(body, { mass, center: new b2.b2Vec2(0, 0), rotationalInertia: 0 });
          return body;
        }
        shapeDef.density = mass / (Math.PI * radius * radius);
        b2.b2CreateCircleShape(body, shapeDef, new b2.b2Circle(new b2.b2Vec2(0, 0), radius));
        return body;
      });
      const crates = scene.crates.map(({ x, y, size, mass }) => {
        const def = b2.b2DefaultBodyDef();
        def.type = b2.b2BodyType.b2_dynamicBody;
        def.position = new b2.b2Vec2(x, y);
        const body = b2.b2CreateBody(world, def);
        shapeDef.density = mass / (size * size);
        b2.b2CreatePolygonShape(body, shapeDef, b2.b2MakeBox(size / 2, size / 2));
        return body;
      });
      for (const { a, b, length } of scene.links) {
        const def = b2.b2DefaultDistanceJointDef();
        def.bodyIdA = discs[a];
        def.bodyIdB = discs[b];
        def.length = length;
        b2.b2CreateDistanceJoint(world, def);
      }
      const force = new b2.b2Vec2(0, 0);
      return simulationOf<(typeof discs)[number]>({
        ...{ scene, discs, crates },
        step: () => b2.b2World_Step(world, scene.dt, SUB_STEPS * effort),
        position(body, into) {
          const { x, y } = b2.b2Body_GetPosition(body);
          into.x = x;
          into.y = y;
        },
        velocity(body, into) {
          const { x, y } = b2.b2Body_GetLinearVelocity(body);
          into.x = x;
          into.y = y;
        },
        rotation(body, into) {
          const { c, s } = b2.b2Body_GetRotation(body);
          into.cos = c;
          into.sin = s;
        },
        push(body, fx, fy) {
          force.x = fx;
          force.y = fy;
          b2.b2Body_ApplyForceToCenter(body, force, true);
        },
      });
    };
  },
};
