import {
  Box,
  Buoyancy,
  cable,
  chain,
  type ForceGenerator,
  inRegion,
  insideBox,
  type Particle,
  rod,
  travellingWave,
  Wind,
  type World,
} from '@mass/core';
import type { Point } from '../scene.ts';
import { CHAIN, TARGET, WEIGHT } from './groups.ts';

/** How a target is hit: `fall` when it comes down to the ground, `strike` when the ball or a weight touches it. */
export type Hit = 'fall' | 'strike';

/** What a level put into the world. */
export interface Place {
  readonly targets: readonly Particle[];
  /** Acts on balls too; `liquid` is what it is made of. */
  readonly water?: ForceGenerator;
  readonly liquid?: Buoyancy;
}

/** A throw: the pull that it is let go at, so long after the ball was there. Units: m, s. */
export interface Throw extends Point {
  readonly after: number;
}

/** One level: data and a `build()`, as a scene is. */
export interface Level {
  readonly name: string;
  readonly hint: string;
  readonly hit: Hit;
  readonly throws: number;
  /** Throws that win it: the game shows them until somebody plays, and the check plays them. */
  readonly solution: readonly Throw[];
  /** Velocity of the air, to the right. Unit: m/s. @default 0 */
  readonly wind?: number;
  build(world: World): Place;
}

const target = (world: World, x: number, y: number, radius = 0.42, mass = 0.6): Particle =>
  world.addParticle({ x, y, radius, mass, restitution: 0.2, group: TARGET });

const block = (world: World, minX: number, minY: number, maxX: number, maxY: number): Box =>
  world.addShape(
    new Box({ centre: { x: (minX + maxX) / 2, y: (minY + maxY) / 2 }, width: maxX - minX, height: maxY - minY }),
  );

const row: Level = {
  name: 'Three in a row',
  hint: 'Pull the ball back and let go: sweep all three off the shelf.',
  hit: 'fall',
  throws: 3,
  solution: [{ x: -1.77, y: -1.2, after: 1.1 }],
  build(world) {
    block(world, 8.4, 3.4, 12.8, 3.75);
    block(world, 10.4, 0, 10.8, 3.4);
    return { targets: [9.4, 10.6, 11.8].map((x) => target(world, x, 3.75 + 0.42)) };
  },
};

const glass: Level = {
  name: 'House of glass',
  hint: 'The rods are brittle: where one breaks, what it held comes down.',
  hit: 'fall',
  throws: 2,
  solution: [{ x: -1.92, y: -0.94, after: 1.1 }],
  build(world) {
    const wide = 1.5;
    const high = 1.35;
    const floors = [3, 2, 1].map((rooms, floor) =>
      Array.from({ length: rooms }, (_, n) =>
        target(world, 9.2 + wide * (n + (floor + 1) / 2), high * (floor + 1), 0.36),
      ),
    );
    const ground = [0, 1, 2, 3].map((n) => ({ x: 9.2 + wide * n, y: 0 }));
    for (const [floor, nodes] of floors.entries()) {
      for (const [n, node] of nodes.entries()) {
        const below = floor === 0 ? ground : floors[floor - 1];
        const ends = [below[n], below[n + 1], ...(n > 0 ? [nodes[n - 1]] : [])];
        for (const end of ends) world.addLink(rod(node, end, { breakForce: 150 }));
      }
    }
    return { targets: floors.flat() };
  },
};

const pendulums: Level = {
  name: 'Pendulums',
  hint: 'They swing on rods: throw to where they will be.',
  hit: 'strike',
  throws: 4,
  solution: [
    { x: -1.59, y: -1.43, after: 0.9 },
    { x: -1.38, y: -1.64, after: 1.5 },
  ],
  build(world) {
    const hung = (anchor: Point, dx: number, dy: number): Particle => {
      const bob = target(world, anchor.x + dx, anchor.y + dy, 0.5, 1);
      world.addLink(rod(anchor, bob));
      return bob;
    };
    return { targets: [hung({ x: 8.6, y: 10.6 }, -2.4, -4.8), hung({ x: 13.4, y: 9.4 }, 2.4, -3.4)] };
  },
};

const cut: Level = {
  name: 'Cut the cable',
  hint: 'Nothing gets past the weight but the weight. What holds it?',
  hit: 'strike',
  throws: 3,
  solution: [{ x: -1.49, y: -1.54, after: 1.1 }],
  build(world) {
    block(world, 9.6, 0, 10, 4.6);
    block(world, 12.2, 0, 12.6, 4.6);
    const weight = world.addParticle({ x: 11.1, y: 5, radius: 1, mass: 5, restitution: 0.1, group: WEIGHT });
    // Two pieces of chain, and between them the link that gives way.
    const piece = { mass: 2, radius: 0.14, group: CHAIN };
    const upper = world.addBody(
      chain({ from: { x: 11.1, y: 9.5 }, to: { x: 11.1, y: 8 }, free: 'to', links: 2, ...piece }),
    );
    const lower = world.addBody(chain({ from: { x: 11.1, y: 7.25 }, to: weight, free: 'from', links: 3, ...piece }));
    world.addLink(cable(upper.particles[1], lower.particles[0], { breakForce: 260 }));
    return { targets: [target(world, 10.55, 0.42), target(world, 11.65, 0.42)] };
  },
};

const pond: Level = {
  name: 'Against the wind',
  hint: 'The wind blows the ball back, the waves lift the buoys.',
  hit: 'strike',
  throws: 5,
  wind: -6,
  solution: [
    { x: -1.86, y: -1.07, after: 1.1 },
    { x: -1.85, y: -0.75, after: 1.1 },
    { x: -1.87, y: -1.26, after: 1.1 },
  ],
  build(world) {
    const { time: start } = world;
    const wave = travellingWave({ level: 1.45, amplitude: 0.16, length: 4, speed: -1.6 });
    block(world, 7.2, 0, 7.6, 1.9);
    block(world, 16.4, 0, 16.8, 1.9);
    const liquid = new Buoyancy({ level: (x, time) => wave(x, time - start), k1: 3 });
    const targets = [9, 11.6, 14.2].map((x) => target(world, x, 1.45, 0.42, 1));
    const water = world.addForce(inRegion(liquid, insideBox({ minX: 7.6, maxX: 16.4, minY: 0 })), targets);
    for (const buoy of targets) {
      liquid.setHull(buoy, { volume: 0.002, maxDepth: 0.42 });
      world.addLink(cable({ x: buoy.x, y: 0 }, buoy, { maxLength: 1.6 }));
    }
    return { targets, water, liquid };
  },
};

/** All levels, each harder than the one before. */
export const levels: readonly Level[] = [row, glass, pendulums, cut, pond];

/** What acts on a ball in flight, besides gravity. */
export function airOf({ wind = 0 }: Level): ForceGenerator[] {
  return wind === 0 ? [] : [new Wind({ velocity: { x: wind, y: 0 }, k1: 0.2 })];
}
