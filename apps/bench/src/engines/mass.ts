import type { Build, Engine } from '../engine.ts';

/** Share of a crate's size that its corners are rounded by: the radius of the corner particles, which lie that far inside. */
const ROUNDING = 0.05;

const SUB_STEPS = 4;

async function load(): Promise<Build> {
  const core = await import('@mass/core');
  const { Box, box, DiscContacts, Drag, EdgeContacts, forEachParticle, HalfPlane, rod, substep, World } = core;
  return (scene, effort) => {
    const { friction, restitution, container, drag } = scene;
    const resolver = substep({ subSteps: SUB_STEPS * effort, ...(scene.sleep ? {} : { sleepTime: Infinity }) });
    const world = new World({ gravity: { x: 0, y: -scene.gravity }, resolver, capacity: scene.discs.length });
    const discs = scene.discs.map(({ x, y, vx = 0, vy = 0, radius, mass, fixed }) =>
      world.addParticle({
        ...{ x, y, vx, vy, friction, restitution },
        mass: fixed ? Infinity : mass,
        radius: scene.collide ? radius : 0,
      }),
    );
    const bodies = scene.crates.map(({ x, y, size, mass }) => {
      const radius = ROUNDING * size;
      const side = size - 2 * radius;
      return world.addBody(box({ x, y, width: side, height: side, mass, radius, friction, restitution }));
    });
    for (const { a, b, length } of scene.links) world.addLink(rod(discs[a], discs[b], { length }));
    const surface = { friction };
    if (container) {
      const { left, right, floor } = container;
      world.addShape(Object.assign(new HalfPlane({ point: { x: 0, y: floor } }), surface));
      world.addShape(Object.assign(new HalfPlane({ point: { x: left, y: 0 }, normal: { x: 1, y: 0 } }), surface));
      world.addShape(Object.assign(new HalfPlane({ point: { x: right, y: 0 }, normal: { x: -1, y: 0 } }), surface));
    }
    for (const { x, y, width, height } of scene.bars) {
      world.addShape(Object.assign(new Box({ centre: { x, y }, width, height }), surface));
    }
    if (scene.collide && discs.length > 0) world.addContactGenerator(new DiscContacts());
    if (bodies.length > 0) world.addContactGenerator(new EdgeContacts(world));
    if (drag?.by === 'engine') world.addForce(new Drag({ k1: drag.k1 }));
    if (drag?.by === 'function') {
      world.addForce(forEachParticle((p) => p.applyForce(-drag.k1 * p.vx, -drag.k1 * p.vy)));
    }
    const { particles } = world; // discs were added first: their slots are their numbers
    return {
      step: () => world.step(scene.dt),
      readPositions(into) {
        const { x, y } = particles;
        for (let i = 0; i < discs.length; i++) {
          into[2 * i] = x[i];
          into[2 * i + 1] = y[i];
        }
      },
      readVelocities(into) {
        const { vx, vy } = particles;
        for (let i = 0; i < discs.length; i++) {
          into[2 * i] = vx[i];
          into[2 * i + 1] = vy[i];
        }
      },
      readCorners(into) {
        bodies.forEach((body, b) => {
          const outwards = 1 / (1 - 2 * ROUNDING);
          body.particles.forEach((corner, k) => {
            into[8 * b + 2 * k] = body.x + (corner.x - body.x) * outwards;
            into[8 * b + 2 * k + 1] = body.y + (corner.y - body.y) * outwards;
          });
        });
      },
    };
  };
}

export const mass: Engine = {
  id: 'mass',
  package: '@mass/core',
  language: 'TypeScript',
  settings: [
    'the default resolver, `substep()`, of 4 sub-steps; walls are `HalfPlane`, links `rod`, discs collide by `DiscContacts`',
    'a crate is `box()`: 4 particles, 6 rods; its corners are rounded by 5 % of its size; crates collide by `EdgeContacts`',
  ],
  load,
};
