import type { Engine } from '../engine.ts';
import { barsOf, dampingOf, simulationOf } from './rigid-bodies.ts';

const VELOCITY_ITERATIONS = 8;
const POSITION_ITERATIONS = 3;

export const planck: Engine = {
  id: 'planck',
  package: 'planck',
  language: 'JavaScript',
  settings: [
    '8 velocity and 3 position iterations, the defaults of `World.step`',
    'walls are boxes 10 m thick, links rigid `DistanceJoint`s, fast discs are bullets',
    'where nothing collides discs have no fixture',
  ],
  async load() {
    const { World, Vec2, Circle, Box, DistanceJoint } = await import('planck');
    return (scene, effort) => {
      const { friction, restitution } = scene;
      const world = new World({ gravity: new Vec2(0, -scene.gravity), allowSleep: scene.sleep });
      for (const { x, y, width, height } of barsOf(scene)) {
        const shape = new Box(width / 2, height / 2);
        world.createBody({ position: new Vec2(x, y) }).createFixture({ shape, friction, restitution });
      }
      const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed, fast = false }) => {
        const body = world.createBody({
          type: fixed ? 'static' : 'dynamic',
          position: new Vec2(x, y),
          linearVelocity: new Vec2(vx, vy),
          linearDamping: dampingOf(scene, mass),
          bullet: fast,
        });
        const density = mass / (Math.PI * radius * radius);
        if (scene.collide) body.createFixture({ shape: new Circle(radius), density, friction, restitution });
        else body.setMassData({ mass, center: new Vec2(0, 0), I: 0 });
        return body;
      });
      const crates = scene.crates.map(({ x, y, size, mass }) => {
        const body = world.createBody({ type: 'dynamic', position: new Vec2(x, y) });
        const density = mass / (size * size);
        body.createFixture({ shape: new Box(size / 2, size / 2), density, friction, restitution });
        return body;
      });
      const centre = new Vec2(0, 0);
      for (const { a, b, length } of scene.links) {
        const [bodyA, bodyB] = [discs[a], discs[b]];
        world.createJoint(new DistanceJoint({ bodyA, bodyB, localAnchorA: centre, localAnchorB: centre, length }));
      }
      const force = new Vec2(0, 0);
      return simulationOf<(typeof discs)[number]>({
        ...{ scene, discs, crates },
        step: () => world.step(scene.dt, VELOCITY_ITERATIONS * effort, POSITION_ITERATIONS * effort),
        position(body, into) {
          const { x, y } = body.getPosition();
          into.x = x;
          into.y = y;
        },
        velocity(body, into) {
          const { x, y } = body.getLinearVelocity();
          into.x = x;
          into.y = y;
        },
        rotation(body, into) {
          into.cos = Math.cos(body.getAngle());
          into.sin = Math.sin(body.getAngle());
        },
        push(body, fx, fy) {
          force.set(fx, fy);
          body.applyForceToCenter(force, true);
        },
      });
    };
  },
};
