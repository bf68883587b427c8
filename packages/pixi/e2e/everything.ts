// A world with one of everything that is drawn.
import {
  Attraction,
  Box,
  Bungees,
  Buoyancy,
  box,
  bungee,
  cable,
  chain,
  Disc,
  DiscContacts,
  DistanceLink,
  Drag,
  ForceProbe,
  Gravity,
  HalfPlane,
  inRegion,
  insideBox,
  Polygon,
  Polyline,
  regularPolygon,
  rod,
  Segment,
  Springs,
  spring,
  travellingWave,
  triangle,
  World,
} from '@mass/core';
import type { Style } from '@mass/core/view';

/** Seen with 50 px a metre, it fills 900 by 600 px around the origin. */
export function everything(): World {
  const world = new World();
  world.addForce(new Gravity({ x: 0, y: -9.81 }));
  addScenery(world);
  addHanging(world);
  addBodies(world);
  world.addContactGenerator(new DiscContacts());
  world.addForce(new ForceProbe());
  return world;
}

function addScenery(world: World): void {
  world.addShape(new HalfPlane({ point: { x: 0, y: -5 } }));
  world.addShape(new HalfPlane({ point: { x: 8.6, y: 0 }, normal: { x: -1, y: 0.12 } }));
  world.addShape(new Box({ centre: { x: -7.2, y: -4.4 }, width: 1.2, height: 1.2 }));
  world.addShape(new Box({ centre: { x: -5.4, y: -3.9 }, width: 1.4, height: 0.5, angle: 0.4 }));
  world.addShape(
    new Polygon({
      points: [
        { x: -4.2, y: -5 },
        { x: -2.4, y: -5 },
        { x: -2.8, y: -4.2 },
        { x: -3.3, y: -4.7 },
        { x: -4, y: -3.9 },
      ],
    }),
  );
  world.addShape(new Disc({ centre: { x: -7.2, y: -2.6 }, radius: 0.5 }));
  world.addShape(new Segment({ a: { x: -8.6, y: -1.2 }, b: { x: -6.6, y: -1.7 } }));
  world.addShape(new Segment({ a: { x: -8.4, y: 0.2 }, b: { x: -7, y: -0.2 }, thickness: 0.3 }));
  const hills = Array.from({ length: 9 }, (_, n) => ({ x: -6 + n * 0.4, y: -2.6 + 0.25 * Math.sin(n * 1.3) }));
  world.addShape(new Polyline({ points: hills, thickness: 0.16 }));
  world.addShape(new Polyline({ points: hills.map(({ x, y }) => ({ x, y: y - 0.45 })) }));
}

function addHanging(world: World): void {
  const springs = world.addForce(new Springs());
  const bungees = world.addForce(new Bungees());
  for (let n = 0; n < 4; n++) {
    const x = -8 + n * 0.8;
    const bob = world.addParticle({ x, y: 3.6 - n * 0.6, radius: 0.14, group: 1 });
    springs.add({ x, y: 5.2 }, bob, { stiffness: 12 + 6 * n, restLength: 1.6 });
    const jumper = world.addParticle({ x: x + 3.4, y: 4.6 - n * 0.9, radius: 0.12, group: 2 });
    bungees.add({ x: x + 3.4, y: 5.2 }, jumper, { stiffness: 20, restLength: 1.4 });
  }
  const post = world.addParticle({ x: -1.2, y: 5, mass: Infinity, radius: 0.16 });
  const bob = world.addParticle({ x: 0, y: 3.2, radius: 0.2, group: 3 });
  world.addLink(rod(post, bob));
  world.addLink(cable(bob, { x: 2, y: 4.6 }, { maxLength: 3.4 }));
  world.addLink(cable({ x: 1, y: 5.2 }, world.addParticle({ x: 1, y: 4, radius: 0.1 })));
  world.addLink(
    new DistanceLink('bar', bob, world.addParticle({ x: 0.2, y: 1.8, radius: 0.12 }), {
      kind: 'bar',
      minLength: 1,
      maxLength: 2,
    }),
  );
  world.addBody(chain({ from: { x: 2.6, y: 5 }, to: { x: 6, y: 4.6 }, length: 4.4, links: 6, mass: 1, radius: 0.06 }));
  const tied = world.addParticle({ x: 6.6, y: 3, radius: 0.18, group: 2 });
  world.addForce(spring({ x: 8, y: 4.4 }, tied, { stiffness: 30, restLength: 1 }));
  world.addForce(bungee({ x: 7.8, y: 2 }, tied, { stiffness: 10, restLength: 2.6 }));
  world.addForce(new Attraction({ G: 1, to: [{ x: 0, y: 0, mass: 4 }] }), [tied]);
  world.addForce(new Drag({ k1: 0.2 }));
}

function addBodies(world: World): void {
  const sea = new Buoyancy({ level: travellingWave({ level: -2.2, amplitude: 0.18, length: 2.6 }), k1: 2 });
  const oil = new Buoyancy({ level: -1.2, density: 800, k1: 2 });
  const float = world.addParticle({ x: 0.6, y: -2, mass: 120, group: 4 });
  sea.setHull(float, { volume: 0.36, maxDepth: 0.3 });
  const ball = world.addParticle({ x: 3, y: -2, mass: 200, radius: 0.35, group: 2 });
  world.addForce(inRegion(sea, insideBox({ minX: -2, maxX: 4, minY: -5 })), [float, ball]);
  world.addForce(inRegion(oil, insideBox({ minX: 5, maxX: 7.6, minY: -4 })), []);
  world.addBody(box({ x: -4, y: 0, width: 1.2, height: 0.8, angle: 0.5, angularVelocity: 1, radius: 0.1, group: 1 }));
  world.addBody(triangle({ x: -2, y: 0.2, width: 1.2, angle: 0.2, radius: 0.14, group: 2 }));
  world.addBody(regularPolygon({ x: -0.2, y: -0.4, sides: 6, radius: 0.04, circumradius: 0.6, group: 3 }));
  world.addBody(box({ x: 2.2, y: 0.6, width: 0.7, height: 0.7, angle: 0.1, group: 0 }));
  for (let n = 0; n < 4; n++)
    world.addParticle({ x: 3.6 + n * 0.5, y: 1.4 + 0.1 * n, vx: 2 - n, radius: 0.27, group: 4 });
}

/** A style for it, with arrows and contacts or without. */
export function everyStyle(dark: boolean, arrows: boolean): Style {
  return {
    background: dark ? '#14171c' : '#ffffff',
    particle: { fill: dark ? '#8fa3b8' : '#5b6b7e' },
    groups: {
      1: { fill: dark ? '#6cb2ff' : '#1c6dd0' },
      2: { fill: dark ? '#ff8a5c' : '#d9480f' },
      3: { fill: dark ? '#5fd6b4' : '#0b8a6a' },
      4: { fill: dark ? '#ffcf5c' : '#c58a00' },
    },
    springs: { colorBy: { by: 'strain', from: -0.4, to: 0.4, colors: ['#1c6dd0', '#7687a0', '#d9480f'] } },
    liquids: { colorBy: { by: 'density', from: 700, to: 1100, colors: ['#c58a00', '#0284c7'] } },
    ...(arrows && { velocities: {}, forces: { scale: 0.03 }, contacts: {} }),
  };
}
