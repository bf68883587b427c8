/// <reference path="./untyped.d.ts" />
import type { Engine } from '../engine.ts';
import { barsOf, dampingOf, simulationOf } from './rigid-bodies.ts';

// What is used of it: it comes without types.
interface Vector {
  get_x(): number;
  get_y(): number;
  setxy(x: number, y: number): void;
}

interface Space {
  step(dt: number, velocityIterations: number, positionIterations: number): void;
  set_worldLinearDrag(drag: number): void;
  set_worldAngularDrag(drag: number): void;
}

interface Part {
  set_material(material: object): void;
  set_filter(filter: object): void;
}

interface Body {
  get_shapes(): { add(part: Part): void };
  get_position(): Vector;
  get_velocity(): Vector;
  get_rotation(): number;
  set_velocity(velocity: Vector): void;
  set_mass(mass: number): void;
  set_isBullet(bullet: boolean): void;
  set_force(force: Vector): void;
  set_space(space: Space): void;
}

interface Nape {
  readonly Config: { sleepDelay: number };
  readonly space: { readonly Space: new (gravity: Vector) => Space };
  readonly geom: { readonly Vec2: new (x: number, y: number) => Vector };
  readonly phys: {
    readonly Body: new (type: object, position: Vector) => Body;
    readonly BodyType: { get_STATIC(): object; get_DYNAMIC(): object };
    readonly Material: new (
      restitution: number,
      dynamicFriction: number,
      staticFriction: number,
      density: number,
      rollingFriction: number,
    ) => object;
  };
  readonly shape: {
    readonly Circle: new (radius: number) => Part;
    readonly Polygon: { new (corners: object): Part; box(width: number, height: number): object };
  };
  readonly dynamics: { readonly InteractionFilter: new (group: number, mask: number) => object };
  readonly constraint: {
    readonly DistanceJoint: new (
      a: Body,
      b: Body,
      anchorA: Vector,
      anchorB: Vector,
      least: number,
      most: number,
    ) => { set_space(space: Space): void };
  };
}

/** Where it looks for a window, and where it puts itself. */
export interface NapeGlobals {
  window: typeof globalThis;
  readonly nape: Nape;
}

/** Pixels a metre: its manual speaks of pixels, and its tolerances are made for them. */
const SCALE = 100;
const ITERATIONS = 10;

export const nape: Engine = {
  id: 'nape-js',
  package: '@newkrok/nape-js',
  language: 'JavaScript',
  settings: [
    '100 pixels a metre; 10 velocity and 10 position iterations, the defaults of `Space.step`',
    'walls are boxes 10 m thick, links stiff `DistanceJoint`s, fast discs are bullets',
    'sleep cannot be switched off: where nothing may sleep, `Config.sleepDelay` is a year',
    'its loader wants a `window`: the global object is given as one',
  ],
  async load() {
    const globals = globalThis as unknown as NapeGlobals;
    globals.window = globalThis;
    const { default: initNape } = await import('@newkrok/nape-js');
    initNape();
    const { space, geom, phys, shape, constraint, dynamics, Config } = globals.nape;
    const vector = (x: number, y: number) => new geom.Vec2(x * SCALE, y * SCALE);
    return (scene, effort) => {
      if (!scene.sleep) Config.sleepDelay = 60 * 60 * 24 * 365 * 60; // steps
      const world = new space.Space(vector(0, -scene.gravity));
      world.set_worldLinearDrag(0);
      world.set_worldAngularDrag(0);
      const { friction, restitution } = scene;
      const nothing = new dynamics.InteractionFilter(1, 0);

      function addBody(x: number, y: number, fixed: boolean, part: Part, collides: boolean): Body {
        const body = new phys.Body(fixed ? phys.BodyType.get_STATIC() : phys.BodyType.get_DYNAMIC(), vector(x, y));
        part.set_material(new phys.Material(restitution, friction, friction, 1, 0));
        if (!collides) part.set_filter(nothing);
        body.get_shapes().add(part);
        return body;
      }

      for (const { x, y, width, height } of barsOf(scene)) {
        const part = new shape.Polygon(shape.Polygon.box(width * SCALE, height * SCALE));
        addBody(x, y, true, part, true).set_space(world);
      }
      const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed = false, fast = false }) => {
        const body = addBody(x, y, fixed, new shape.Circle(radius * SCALE), scene.collide);
        if (!fixed) body.set_mass(mass);
        body.set_velocity(vector(vx, vy));
        body.set_isBullet(fast);
        body.set_space(world);
        return body;
      });
      const crates = scene.crates.map(({ x, y, size, mass }) => {
        const part = new shape.Polygon(shape.Polygon.box(size * SCALE, size * SCALE));
        const body = addBody(x, y, false, part, true);
        body.set_mass(mass);
        body.set_space(world);
        return body;
      });
      for (const { a, b, length } of scene.links) {
        const [least, most] = [length * SCALE, length * SCALE];
        new constraint.DistanceJoint(discs[a], discs[b], vector(0, 0), vector(0, 0), least, most).set_space(world);
      }
      const { drag } = scene;
      if (drag?.by === 'engine') world.set_worldLinearDrag(dampingOf(scene, scene.discs[0].mass));
      const force = vector(0, 0);
      return simulationOf<Body>({
        ...{ scene, discs, crates },
        step: () => world.step(scene.dt, ITERATIONS * effort, ITERATIONS * effort),
        position(body, into) {
          const position = body.get_position();
          into.x = position.get_x() / SCALE;
          into.y = position.get_y() / SCALE;
        },
        velocity(body, into) {
          const velocity = body.get_velocity();
          into.x = velocity.get_x() / SCALE;
          into.y = velocity.get_y() / SCALE;
        },
        rotation(body, into) {
          into.cos = Math.cos(body.get_rotation());
          into.sin = Math.sin(body.get_rotation());
        },
        push(body, fx, fy) {
          force.setxy(fx * SCALE, fy * SCALE);
          body.set_force(force);
        },
      });
    };
  },
};
