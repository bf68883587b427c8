import type { Engine } from '../engine.ts';
import { barsOf, dampingOf, simulationOf } from './rigid-bodies.ts';

const ITERATIONS = 10;

export const p2: Engine = {
  id: 'p2-es',
  package: 'p2-es',
  language: 'JavaScript',
  settings: [
    'the defaults of `World`: a Gauss-Seidel solver of 10 iterations, sweep and prune',
    'walls are boxes 10 m thick, links `DistanceConstraint`s, fast discs have a `ccdSpeedThreshold` of 1 m/s; sleep by body',
    'where nothing collides discs have an empty collision mask',
  ],
  async load() {
    const { World, Body, Circle, Box, DistanceConstraint, GSSolver } = await import('p2-es');
    return (scene, effort) => {
      const solver = new GSSolver({ iterations: ITERATIONS * effort });
      const world = new World({ gravity: [0, -scene.gravity], solver });
      world.defaultContactMaterial.friction = scene.friction;
      world.defaultContactMaterial.restitution = scene.restitution;
      if (scene.sleep) world.sleepMode = World.BODY_SLEEPING;
      for (const { x, y, width, height } of barsOf(scene)) {
        const body = new Body({ mass: 0, position: [x, y] });
        body.addShape(new Box({ width, height }));
        world.addBody(body);
      }
      const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed, fast }) => {
        const body = new Body({
          ...{ mass: fixed ? 0 : mass, position: [x, y], velocity: [vx, vy] },
          damping: 1 - Math.exp(-dampingOf(scene, mass)), // the share lost in a second
          angularDamping: 0,
          ...(fast ? { ccdSpeedThreshold: 1, ccdIterations: 10 } : {}),
        });
        // One without a shape would be slow: it has no bounds, and the broad phase pairs it with all others.
        body.addShape(new Circle(scene.collide ? { radius } : { radius, collisionMask: 0 }));
        world.addBody(body);
        return body;
      });
      const crates = scene.crates.map(({ x, y, size, mass }) => {
        const body = new Body({ mass, position: [x, y], damping: 0, angularDamping: 0 });
        body.addShape(new Box({ width: size, height: size }));
        world.addBody(body);
        return body;
      });
      for (const { a, b, length } of scene.links) {
        world.addConstraint(new DistanceConstraint(discs[a], discs[b], { distance: length, collideConnected: false }));
      }
      return simulationOf<(typeof discs)[number]>({
        ...{ scene, discs, crates },
        step: () => world.step(scene.dt),
        position(body, into) {
          into.x = body.position[0];
          into.y = body.position[1];
        },
        velocity(body, into) {
          into.x = body.velocity[0];
          into.y = body.velocity[1];
        },
        rotation(body, into) {
          into.cos = Math.cos(body.angle);
          into.sin = Math.sin(body.angle);
        },
        push(body, fx, fy) {
          body.force[0] += fx;
          body.force[1] += fy;
        },
      });
    };
  },
};
