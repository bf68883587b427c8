import type { Engine } from '../engine.ts';
import { barsOf, dampingOf, simulationOf } from './rigid-bodies.ts';

/** Pixels a metre: sizes of some ten pixels are what its examples have and what its tolerances are made for. */
const SCALE = 100;
const MS = 1000;
/** Velocities are pixels in this time. */
const BASE = MS / 60;

export const matter: Engine = {
  id: 'matter-js',
  package: 'matter-js',
  language: 'JavaScript',
  settings: [
    '100 pixels a metre; the defaults of `Engine.create`: 6 position, 4 velocity, 2 constraint iterations',
    'no air friction, where the scene has none; walls are rectangles 10 m thick, links constraints of stiffness 1',
    'discs are polygons of up to 26 sides, as `Bodies.circle` makes them; there is no continuous collision',
    'where nothing collides discs have an empty collision mask',
  ],
  async load() {
    const { default: Matter } = await import('matter-js');
    const { Engine: Engines, Bodies, Body, Composite, Constraint } = Matter;
    return (scene, effort) => {
      const engine = Engines.create({
        gravity: { x: 0, y: -1, scale: (scene.gravity * SCALE) / (MS * MS) },
        enableSleeping: scene.sleep,
        positionIterations: 6 * effort,
        velocityIterations: 4 * effort,
        constraintIterations: 2 * effort,
      });
      const { friction, restitution } = scene;
      const surface = { friction, frictionStatic: friction, restitution };
      for (const { x, y, width, height } of barsOf(scene)) {
        const options = { isStatic: true, ...surface };
        Composite.add(engine.world, Bodies.rectangle(x * SCALE, y * SCALE, width * SCALE, height * SCALE, options));
      }
      const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed = false }) => {
        const body = Bodies.circle(x * SCALE, y * SCALE, radius * SCALE, {
          ...surface,
          frictionAir: (dampingOf(scene, mass) * BASE) / MS,
          isStatic: fixed,
          ...(scene.collide ? {} : { collisionFilter: { mask: 0 } }),
        });
        if (!fixed) Body.setMass(body, mass);
        Body.setVelocity(body, { x: (vx * SCALE * BASE) / MS, y: (vy * SCALE * BASE) / MS });
        return body;
      });
      const crates = scene.crates.map(({ x, y, size, mass }) => {
        const options = { ...surface, frictionAir: 0 };
        const body = Bodies.rectangle(x * SCALE, y * SCALE, size * SCALE, size * SCALE, options);
        Body.setMass(body, mass);
        return body;
      });
      Composite.add(engine.world, [...discs, ...crates]);
      for (const { a, b, length } of scene.links) {
        const constraint = { bodyA: discs[a], bodyB: discs[b], length: length * SCALE, stiffness: 1 };
        Composite.add(engine.world, Constraint.create(constraint));
      }
      return simulationOf<(typeof discs)[number]>({
        ...{ scene, discs, crates },
        step: () => void Engines.update(engine, scene.dt * MS),
        position(body, into) {
          into.x = body.position.x / SCALE;
          into.y = body.position.y / SCALE;
        },
        velocity(body, into) {
          into.x = (body.velocity.x / SCALE / BASE) * MS;
          into.y = (body.velocity.y / SCALE / BASE) * MS;
        },
        rotation(body, into) {
          into.cos = Math.cos(body.angle);
          into.sin = Math.sin(body.angle);
        },
        push(body, fx, fy) {
          body.force.x += (fx * SCALE) / (MS * MS);
          body.force.y += (fy * SCALE) / (MS * MS);
        },
      });
    };
  },
};
