import {
  type Body,
  box,
  DiscContacts,
  HalfPlane,
  type Link,
  type Particle,
  regularPolygon,
  rod,
  substep,
  type Vec2,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../helpers.ts';

const down = { x: 0, y: -9.81 };

function join(world: World, ends: readonly Particle[], pairs: readonly (readonly [number, number])[]): Link[] {
  return pairs.map(([a, b]) => world.addLink(rod(ends[a], ends[b])));
}

/** A ladder of squares, each with one diagonal. */
function truss(world: World, squares: number, braced = true): { ends: Particle[]; rods: Link[] } {
  const ends: Particle[] = [];
  const pairs: [number, number][] = [];
  for (let k = 0; k <= squares; k++) {
    ends.push(world.addParticle({ x: k, y: 5, mass: 1 + k }), world.addParticle({ x: k, y: 6 }));
    pairs.push([2 * k, 2 * k + 1]);
    if (k === 0) continue;
    pairs.push([2 * k - 2, 2 * k], [2 * k - 1, 2 * k + 1]);
    if (braced || k > 1) pairs.push([2 * k - 2, 2 * k + 1]);
  }
  return { ends, rods: join(world, ends, pairs) };
}

function worstStrain(links: readonly Link[]): number {
  return Math.max(...links.map((link) => Math.abs((link as Link & { strain: number }).strain)));
}

function motionOf(particles: readonly Particle[]): {
  mass: number;
  vx: number;
  vy: number;
  spin: number;
  energy: number;
} {
  let [mass, x, y, px, py, energy] = [0, 0, 0, 0, 0, 0];
  for (const p of particles) {
    mass += p.mass;
    x += p.mass * p.x;
    y += p.mass * p.y;
    px += p.mass * p.vx;
    py += p.mass * p.vy;
    energy += (p.mass * (p.vx * p.vx + p.vy * p.vy)) / 2;
  }
  let [momentum, inertia] = [0, 0];
  for (const p of particles) {
    const dx = p.x - x / mass;
    const dy = p.y - y / mass;
    momentum += p.mass * (dx * p.vy - dy * p.vx);
    inertia += p.mass * (dx * dx + dy * dy);
  }
  return { mass, vx: px / mass, vy: py / mass, spin: momentum / inertia, energy };
}

describe('what rods hold in one shape', () => {
  it.each([
    ['a box', box({ x: 0, y: 0, width: 2, height: 1, vx: 3, vy: -1, angularVelocity: 5, mass: 3 })],
    ['a polygon of 12', regularPolygon({ x: 0, y: 0, sides: 12, circumradius: 1, vx: 3, vy: -1, angularVelocity: -5 })],
  ])('[K17] %s flies and spins for a minute and is the same as ever', (_, plan) => {
    const world = new World();
    const body = world.addBody(plan);
    const { angularVelocity } = body;
    world.step(1 / 60);
    const energy = body.kineticEnergy;
    run(world, 3600);
    expect(worstStrain(body.links)).toBeLessThan(1e-12);
    expect(body.vx).toBeCloseTo(3, 9);
    expect(body.vy).toBeCloseTo(-1, 9);
    expect(body.angularVelocity / angularVelocity).toBeCloseTo(1, 9);
    expect(body.kineticEnergy / energy).toBeCloseTo(1, 9);
  });

  it('[K17] a truss is, however long; one square without its diagonal folds', () => {
    for (const braced of [true, false]) {
      const world = new World({ gravity: down });
      const { ends, rods } = truss(world, 12, braced);
      ends[0].vy = 5;
      run(world, 30);
      expect(worstStrain(rods)).toBeLessThan(braced ? 1e-12 : 0.01);
      const diagonal = Math.hypot(ends[3].x - ends[0].x, ends[3].y - ends[0].y);
      if (braced) expect(diagonal).toBeCloseTo(Math.SQRT2, 12);
      else expect(Math.abs(diagonal - Math.SQRT2)).toBeGreaterThan(0.1);
    }
  });

  it('[K17] stays so when other links come and go, and is free again without one of its rods', () => {
    const world = new World({ gravity: down });
    const { ends, rods } = truss(world, 2);
    const other = world.addParticle({ x: 20, y: 5 });
    const rope = world.addLink(rod(other, { x: 20, y: 7 }));
    run(world, 30);
    world.removeLink(rope);
    run(world, 30);
    expect(worstStrain(rods)).toBeLessThan(1e-12);
    world.removeLink(rods[4]);
    ends[0].vy += 5;
    run(world, 30);
    expect(Math.abs(Math.hypot(ends[3].x - ends[0].x, ends[3].y - ends[0].y) - Math.SQRT2)).toBeGreaterThan(0.1);
  });

  it('[K17] swings about a corner that is pinned, and flies on when it is freed', () => {
    const world = new World({ gravity: down });
    const body: Body = world.addBody(box({ x: 0, y: 0, width: 1, height: 1 }));
    const [corner] = body.particles;
    const { mass } = corner;
    corner.mass = Infinity;
    const at: Vec2 = { x: corner.x, y: corner.y };
    run(world, 60);
    expect([corner.x, corner.y]).toEqual([at.x, at.y]);
    expect(worstStrain(body.links)).toBeLessThan(1e-3);
    expect(Math.abs(body.angle)).toBeGreaterThan(0.1);
    corner.mass = mass;
    const { vx, angularVelocity } = body;
    run(world, 60);
    expect(body.vx).toBeCloseTo(vx, 3);
    expect(body.angularVelocity).toBeCloseTo(angularVelocity, 1);
  });

  it('[K17] takes the size that its rods are given', () => {
    const world = new World();
    const ends = [0, 1, 2].map((k) => world.addParticle({ x: k % 2, y: k > 1 ? 1 : 0 }));
    const rods = [rod(ends[0], ends[1]), rod(ends[1], ends[2]), rod(ends[2], ends[0])].map((link) =>
      world.addLink(link),
    );
    run(world, 1);
    for (const link of rods) link.setLength(1.2 * link.maxLength, 1.2 * link.maxLength);
    run(world, 60);
    expect(worstStrain(rods)).toBeLessThan(1e-6);
    expect(Math.hypot(ends[1].x - ends[0].x, ends[1].y - ends[0].y)).toBeCloseTo(1.2, 5);
  });
});

describe('a hit on a rigid body', () => {
  it.each([
    [1, 1, 0],
    [1, 100, 0],
    [100, 1, 0.5],
    [1, 1000, 1],
  ])('[K18] is that of the textbook: ends of %f and %f kg, restitution %f', (near, far, restitution) => {
    const world = new World();
    world.addContactGenerator(new DiscContacts());
    const ends = [
      world.addParticle({ x: 0, y: 0, radius: 0.1, mass: near, restitution }),
      world.addParticle({ x: 2, y: 0, mass: far }),
    ];
    join(world, ends, [[0, 1]]);
    const mass = 2;
    const disc = world.addParticle({ x: 0, y: -0.2, vy: 3, radius: 0.1, mass });
    run(world, 1);
    const arm = (-2 * far) / (near + far);
    const inertia = (4 * near * far) / (near + far);
    const impulse = ((1 + restitution) * 3) / (1 / mass + 1 / (near + far) + (arm * arm) / inertia);
    const { vx, vy, spin } = motionOf(ends);
    const least = restitution === 1 ? 0.02 : 2e-3; // it turns within the step
    expect(Math.abs(disc.vy - (3 - impulse / mass))).toBeLessThan(least * 3);
    expect(Math.abs(vy - impulse / (near + far))).toBeLessThan((least * impulse) / (near + far));
    expect(Math.abs(vx)).toBeLessThan(0.01);
    expect(Math.abs(spin / ((arm * impulse) / inertia) - 1)).toBeLessThan(least);
  });

  it.each([1, 10, 100, 1000])(
    '[K18] stops a rod that falls on the floor upright, its upper end %f times the lower',
    (ratio) => {
      const world = new World();
      world.addShape(new HalfPlane());
      const ends = [
        world.addParticle({ x: 0, y: 0.3, radius: 0.1, vy: -5 }),
        world.addParticle({ x: 0, y: 1.3, vy: -5, mass: ratio }),
      ];
      join(world, ends, [[0, 1]]);
      run(world, 10);
      expect(motionOf(ends).energy).toBeLessThan(1e-9 * ratio);
    },
  );

  it('[C49] a tower of 10 boxes stands for a minute without sleep, and sinks by less than 6 mm, at 4 to 8 small steps', () => {
    for (const subSteps of [4, 5, 6, 8]) {
      const world = new World({ gravity: down, resolver: substep({ subSteps, sleepTime: Infinity }) });
      world.addShape(new HalfPlane({ friction: 0.5 }));
      world.addContactGenerator(new DiscContacts());
      const boxes = Array.from({ length: 10 }, (_, n) =>
        world.addBody(box({ x: 0, y: 0.3 + n * 0.6, width: 0.5, height: 0.5, radius: 0.05, friction: 0.5 })),
      );
      run(world, 3600);
      expect(5.7 - boxes[9].y).toBeLessThan(0.006);
      expect(5.7 - boxes[9].y).toBeGreaterThan(0);
    }
  });
});
