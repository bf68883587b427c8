import { DiscContacts, HalfPlane, type Particle, Random, substep, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../../helpers.ts';

const R = 0.25;

function awake(friction: number): World {
  const world = new World({ gravity: { x: 0, y: -9.81 }, resolver: substep({ sleepTime: Infinity }) });
  world.addShape(new HalfPlane({ friction }));
  world.addContactGenerator(new DiscContacts());
  return world;
}

/** A triangle of discs that just touch, its lowest row between two walls where there are walls. The top is the last. */
function pyramid(rows: number, friction: number, walls: boolean): { world: World; top: Particle } {
  const world = awake(friction);
  if (walls) {
    world.addShape(new HalfPlane({ normal: { x: 1, y: 0 }, friction }));
    world.addShape(new HalfPlane({ normal: { x: -1, y: 0 }, point: { x: 2 * rows * R, y: 0 }, friction }));
  }
  let top!: Particle;
  for (let row = 0; row < rows; row++) {
    for (let i = 0; i < rows - row; i++) {
      top = world.addParticle({ x: (2 * i + 1 + row) * R, y: R + row * Math.sqrt(3) * R, radius: R, friction });
    }
  }
  return { world, top };
}

describe('a stack of discs', () => {
  it.each([
    [10, 0.008],
    [20, 0.03],
  ])('[S8] a column of %s sinks by less than %s m, and creeps by less than 0.1 mm after 2 s', (rows, most) => {
    const world = awake(0);
    let top!: Particle;
    for (let row = 0; row < rows; row++) top = world.addParticle({ x: 0, y: R + 2 * R * row, radius: R });
    const start = top.y;
    run(world, 120);
    const early = top.y;
    run(world, 480);
    expect(start - top.y).toBeLessThan(most);
    expect(Math.abs(early - top.y)).toBeLessThan(1e-4);
  });

  it.each([
    [10, 0.008],
    [20, 0.03],
  ])(
    '[S8] a pyramid of %s rows between walls sinks by less than %s m, and creeps by less than 0.1 mm after 2 s',
    (rows, most) => {
      const { world, top } = pyramid(rows, 0.5, true);
      const start = top.y;
      run(world, 120);
      const early = top.y;
      run(world, 480);
      expect(start - top.y).toBeLessThan(most);
      expect(Math.abs(early - top.y)).toBeLessThan(1e-4);
    },
  );

  // Discs do not turn, so the load of an edge may lean from the line of the centres, 30 degrees off the upright, by the angle of friction; the
  // floor holds what is left: µ = (n - 1) / (n + 1)·tan(30° - atan µ), 0.242 for 10 rows and 0.255 for 20, tan 15° for many.
  it.each([
    [10, 0.23, 0.26],
    [20, 0.24, 0.28],
  ])(
    '[S8] a pyramid of %s rows without walls falls at friction %s and keeps its top within 30 mm at %s',
    (rows, low, high) => {
      const falls = pyramid(rows, low, false);
      const stands = pyramid(rows, high, false);
      const start = stands.top.y;
      run(falls.world, 600);
      run(stands.world, 120);
      const early = stands.top.y;
      run(stands.world, 480);
      expect(start - falls.top.y).toBeGreaterThan(2 * R);
      expect(start - stands.top.y).toBeLessThan(0.03);
      expect(Math.abs(early - stands.top.y)).toBeLessThan(1e-4);
    },
  );
});

describe('a pile', () => {
  it('[S9] of 500 discs in a box: none is out, the mean penetration is below 1 % of the radius', () => {
    const random = new Random(1);
    const world = awake(0.3);
    const width = 23 * 2.3 * R;
    world.addShape(new HalfPlane({ normal: { x: 1, y: 0 }, friction: 0.3 }));
    world.addShape(new HalfPlane({ normal: { x: -1, y: 0 }, point: { x: width, y: 0 }, friction: 0.3 }));
    for (let i = 0; i < 500; i++) {
      const radius = R * random.between(0.9, 1.1);
      const x = ((i % 23) + 0.5) * 2.3 * R + random.between(-0.02, 0.02);
      world.addParticle({ x, y: (Math.floor(i / 23) + 0.5) * 3 * R, radius, mass: (radius / R) ** 2, friction: 0.3 });
    }
    run(world, 600);
    const { count, penetration } = world.contacts;
    let sum = 0;
    let touching = 0;
    for (let c = 0; c < count; c++) {
      if (penetration[c] <= 0) continue;
      sum += penetration[c];
      touching++;
    }
    expect(touching).toBeGreaterThan(400);
    expect(sum / touching).toBeLessThan(0.01 * R);
    const { x, y } = world.particles;
    for (let i = 0; i < 500; i++) expect(x[i] > 0 && x[i] < width && y[i] > 0).toBe(true);
  });

  it.each([10, 100, 1000, 10_000])(
    '[S10] a disc of %s times the mass on light ones gains no height and comes to rest',
    (mass) => {
      const world = awake(0.5);
      const light = [-0.5, 0, 0.5].map((x) => world.addParticle({ x, y: R, radius: R, friction: 0.5 }));
      const heavy = world.addParticle({ x: 0, y: 2 * R + 1, radius: 1, mass, friction: 0.5 });
      let highest = 0;
      for (let step = 0; step < 900; step++) {
        world.step(1 / 60);
        highest = Math.max(highest, heavy.y);
      }
      expect(highest).toBeLessThan(1.501);
      for (const disc of [heavy, ...light]) expect(Math.hypot(disc.vx, disc.vy)).toBeLessThan(0.03);
    },
  );
});
