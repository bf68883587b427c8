import { type BodyPlan, box, HalfPlane, polygon, regularPolygon, severity, triangle, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { hashOf, run } from '../helpers.ts';
import { momenta, worstStrain, wrapped } from './helpers.ts';

const weight = { x: 0, y: -9.81 };
const motion = { x: 3, y: 2, vx: 1.5, vy: -0.5, angularVelocity: 2.5, angle: 0.7, mass: 6 };

/** An L, with corners in a line along its edges. */
const outline = [
  { x: 0, y: 0 },
  { x: 1, y: 0 },
  { x: 2, y: 0 },
  { x: 2, y: 1 },
  { x: 1, y: 1 },
  { x: 1, y: 2 },
  { x: 1, y: 3 },
  { x: 0, y: 3 },
  { x: 0, y: 2 },
  { x: 0, y: 1 },
];

const plans: [string, BodyPlan, number, number][] = [
  ['box', box({ ...motion, width: 1, height: 0.6 }), 4, 6],
  ['triangle', triangle({ ...motion, width: 1 }), 3, 3],
  ['pentagon', regularPolygon({ ...motion, sides: 5, circumradius: 0.5 }), 5, 10],
  ['octagon', regularPolygon({ ...motion, sides: 8, circumradius: 0.5 }), 8, 28],
  ['12 corners', regularPolygon({ ...motion, sides: 12, circumradius: 0.5 }), 12, 36],
  ['an L of 10 corners', polygon({ ...motion, points: outline }), 10, 28],
];

describe.each(plans)('%s', (_name, plan, particles, links) => {
  it('[B2] has its mass, centre, velocity, angular velocity and orientation as they were asked for', () => {
    const body = new World({ resolver: severity() }).addBody(plan);
    expect([body.particles.length, body.links.length]).toEqual([particles, links]);
    expect(body.mass).toBeCloseTo(6, 12);
    expect(body.x).toBeCloseTo(3, 12);
    expect(body.y).toBeCloseTo(2, 12);
    expect(body.vx).toBeCloseTo(1.5, 12);
    expect(body.vy).toBeCloseTo(-0.5, 12);
    expect(body.angularVelocity).toBeCloseTo(2.5, 12);
    expect(body.angle).toBeCloseTo(0.7, 12);
    expect(body.kineticEnergy).toBeCloseTo((6 * 2.5 + body.inertia * 2.5 ** 2) / 2, 11);
    expect(worstStrain(body)).toBe(0);
  });

  it('[B3] is rigid: its rods leave it no motion but three', () => {
    expect(rankOfRods(plan)).toBe(2 * particles - 3);
  });

  it('[B6] an impulse off the centre changes velocity by J/M and angular velocity by r × J/I, to 1e-12', () => {
    const body = new World({ resolver: severity() }).addBody(plan);
    const { vx, vy, angularVelocity, x, y, mass, inertia } = body;
    const before = momenta(body);
    const [jx, jy, atX, atY] = [1.7, -2.3, x + 0.4, y - 0.9];
    body.applyImpulse(jx, jy, atX, atY);
    const after = momenta(body);
    expect(body.vx - vx).toBeCloseTo(jx / mass, 12);
    expect(body.vy - vy).toBeCloseTo(jy / mass, 12);
    expect(body.angularVelocity - angularVelocity).toBeCloseTo((0.4 * jy + 0.9 * jx) / inertia, 12);
    expect(after.x - before.x).toBeCloseTo(jx, 12);
    expect(after.y - before.y).toBeCloseTo(jy, 12);
    expect(after.angular - before.angular).toBeCloseTo(atX * jy - atY * jx, 12);
  });

  it('[B6] an impulse moves it as a rigid body: no rod is pulled', () => {
    const body = new World({ resolver: severity() }).addBody(plan);
    body.applyImpulse(1.7, -2.3, 3.4, 1.1);
    for (const { a, b } of body.links) {
      const p = body.particles.find((particle) => particle === a);
      const q = body.particles.find((particle) => particle === b);
      if (p === undefined || q === undefined) throw new Error('a rod ends elsewhere');
      expect((p.x - q.x) * (p.vx - q.vx) + (p.y - q.y) * (p.vy - q.vy)).toBeCloseTo(0, 12);
    }
  });

  it('[B7] a force off the centre does over a step what an impulse F·dt does', () => {
    const world = new World({ resolver: severity() });
    const pushed = world.addBody(plan);
    const hit = new World({ resolver: severity() }).addBody(plan);
    pushed.applyForce(17, -23, 3.4, 1.1);
    hit.applyImpulse(17 / 60, -23 / 60, 3.4, 1.1);
    const { fx, fy } = world.particles;
    for (const [index, { slot, mass, vx, vy }] of pushed.particles.entries()) {
      expect(vx + fx[slot] / mass / 60).toBeCloseTo(hit.particles[index].vx, 12);
      expect(vy + fy[slot] / mass / 60).toBeCloseTo(hit.particles[index].vy, 12);
    }
  });

  it('[B4] in free flight keeps its momentum to 1e-12, and its rods their lengths to 2e-5', () => {
    const world = new World({ resolver: severity() });
    const body = world.addBody(plan);
    for (let i = 0; i < 600; i++) {
      world.step(1 / 60);
      expect(worstStrain(body)).toBeLessThan(2e-5);
    }
    expect(body.vx).toBeCloseTo(1.5, 12);
    expect(body.vy).toBeCloseTo(-0.5, 12);
    expect(body.x).toBeCloseTo(3 + 15, 10);
    expect(body.y).toBeCloseTo(2 - 5, 10);
  });

  it('[B8] comes out of the world with all its particles and rods', () => {
    const world = new World({ resolver: severity() });
    const other = world.addParticle({ x: 0, y: 0 });
    const body = world.addBody(plan);
    const [particle] = body.particles;
    expect(world.bodies).toEqual([body]);
    world.removeBody(body);
    expect([world.particleCount, world.links.length, world.bodies.length]).toEqual([1, 0, 0]);
    expect([body.alive, particle.alive, other.alive, body.whole]).toEqual([false, false, true, false]);
    expect([body.particles, body.links]).toEqual([[], []]);
  });

  it('[B1] the same plan gives the same bits twice, and after a fall too', () => {
    const build = () => {
      const world = new World({ resolver: severity(), gravity: weight });
      world.addShape(new HalfPlane({ restitution: 0.3 }));
      world.addBody(plan);
      return world;
    };
    const [first, second] = [build(), build()];
    expect(hashOf(first)).toBe(hashOf(second));
    run(first, 120);
    run(second, 120);
    expect(hashOf(first)).toBe(hashOf(second));
  });
});

describe('turning', () => {
  it.each([60, 240])(
    '[B4] in flight under severity at 1/%i s a step takes 1/ω² to 1/ω² + dt², and nothing else of the turning',
    (rate) => {
      const world = new World({ resolver: severity() });
      const body = world.addBody(box({ x: 0, y: 0, width: 1, height: 0.6, angularVelocity: 3 }));
      for (let i = 1; i <= 10 * rate; i++) {
        world.step(1 / rate);
        expect(body.angularVelocity).toBeCloseTo(1 / Math.sqrt(1 / 9 + i / rate ** 2), 9);
      }
    },
  );

  it('[B5] orientation follows ω·t, through full turns', () => {
    const world = new World({ resolver: severity() });
    const body = world.addBody(box({ x: 0, y: 0, width: 1, height: 0.6, angularVelocity: -2, angle: 1 }));
    let turned = 1;
    for (let i = 0; i < 2400; i++) {
      // Each step moves the corners along the tangent by ω·dt and brings them back to the circle: it turns by atan(ω·dt).
      turned += Math.atan(body.angularVelocity / 240);
      world.step(1 / 240);
      expect(wrapped(body.angle - turned)).toBeCloseTo(0, 9);
      expect(Math.abs(body.angle)).toBeLessThanOrEqual(Math.PI);
    }
    expect(Math.abs(turned)).toBeGreaterThan(2 * Math.PI);
  });

  it('[B5] a pose is between the last two states', () => {
    const world = new World({ resolver: severity() });
    const body = world.addBody(box({ x: 1, y: 2, width: 1, height: 1, vx: 6, angularVelocity: 0.6 }));
    world.step(1 / 60);
    const pose = { x: NaN, y: NaN, angle: NaN };
    expect(body.pose(0)).toEqual({ x: 1, y: 2, angle: 0 });
    expect(body.pose(0.5, pose)).toBe(pose);
    expect(pose.x).toBeCloseTo(1.05, 12);
    expect(pose.angle).toBeCloseTo(0.005, 6);
    expect(body.pose()).toEqual({ x: body.x, y: body.y, angle: body.angle });
  });

  it('[B5] the angle comes back within half a turn', () => {
    const world = new World({ resolver: severity() });
    for (const angle of [-3, 3, 4, -7, 100]) {
      const body = world.addBody(triangle({ x: 0, y: 0, width: 1, angle }));
      expect(body.angle).toBeCloseTo(wrapped(angle), 12);
    }
  });

  it('[B9] dropped without turning, it hits with a corner, turns, and comes to lie on a side', () => {
    const world = new World({ resolver: severity(), gravity: weight });
    world.addShape(new HalfPlane({ restitution: 0.3 }));
    const body = world.addBody(box({ x: 0, y: 3, width: 0.4, height: 1.6, mass: 4, radius: 0.05, angle: 0.5 }));
    let fastest = 0;
    let strain = 0;
    for (let i = 0; i < 600; i++) {
      world.step(1 / 60);
      fastest = Math.max(fastest, Math.abs(body.angularVelocity));
      strain = Math.max(strain, worstStrain(body));
    }
    expect(fastest).toBeGreaterThan(3);
    expect(body.angle).toBeCloseTo(Math.PI / 2, 3);
    expect(body.y).toBeCloseTo(0.25, 3);
    expect(Math.abs(body.angularVelocity)).toBeLessThan(0.01);
    expect(body.x).toBeCloseTo(0, 9); // no friction: nothing pushes it sideways
    expect(strain).toBeLessThan(0.05); // in the step of a hit
    expect(worstStrain(body)).toBeLessThan(1e-3);
  });

  it('[B9] falls mirror-wise when it is built mirror-wise', () => {
    const fall = (side: number) => {
      const world = new World({ resolver: severity(), gravity: weight });
      world.addShape(new HalfPlane({ restitution: 0.3 }));
      const body = world.addBody(
        triangle({ x: side, y: 2, width: 1, vx: side, angle: 0.3 * side, angularVelocity: side, radius: 0.05 }),
      );
      run(world, 20);
      return body;
    };
    const [left, right] = [fall(-1), fall(1)];
    expect(left.x).toBeCloseTo(-right.x, 12);
    expect(left.y).toBeCloseTo(right.y, 12);
    expect(left.angularVelocity).toBeCloseTo(-right.angularVelocity, 12);
  });

  it('[B10] hung by a pinned corner it swings as a compound pendulum, T = 2π √(I / (m·g·d)), to 0.2 %', () => {
    const reach = Math.sqrt(0.5 ** 2 + 0.3 ** 2);
    const swing = 0.1;
    const world = new World({ resolver: severity(), gravity: weight });
    const hung = world.addBody(
      box({
        x: Math.sin(swing) * reach,
        y: -Math.cos(swing) * reach,
        width: 1,
        height: 0.6,
        mass: 4,
        angle: Math.PI / 2 - Math.atan2(0.3, 0.5) + swing,
      }),
    );
    const [, , pivot] = hung.particles;
    pivot.mass = Infinity;
    const [at, inertia] = [{ x: pivot.x, y: pivot.y }, hung.inertia];
    expect([hung.mass, hung.x, hung.y]).toEqual([Infinity, at.x, at.y]);
    const crossings: number[] = [];
    let before = hung.angle;
    const rest = before - swing;
    for (let i = 1; i <= 2400; i++) {
      world.step(1 / 240);
      if (before > rest && hung.angle <= rest) crossings.push((i - 1 + (before - rest) / (before - hung.angle)) / 240);
      before = hung.angle;
    }
    const period = (crossings[crossings.length - 1] - crossings[0]) / (crossings.length - 1);
    const exact = 2 * Math.PI * Math.sqrt(inertia / (3 * 9.81 * ((4 / 3) * reach)));
    expect(Math.abs(period / exact - 1)).toBeLessThan(0.002);
  });

  it('[B10] an impulse turns it about a pinned particle, and does nothing to one with two', () => {
    const world = new World({ resolver: severity() });
    const body = world.addBody(box({ x: 0, y: 0, width: 2, height: 2, mass: 4 }));
    const [corner, , , other] = body.particles;
    corner.mass = Infinity;
    body.applyImpulse(0, 3, 1, 1);
    expect(body.angularVelocity).toBeCloseTo((2 * 3) / body.inertia, 12);
    expect([corner.vx, corner.vy, body.vx, body.vy]).toEqual([0, 0, 0, 0]);
    const turning = body.particles.map(({ vx, vy }) => [vx, vy]);
    other.mass = Infinity;
    body.applyImpulse(0, 3, 1, 1);
    expect(body.particles.map(({ vx, vy }) => [vx, vy])).toEqual(turning);
    expect([body.inertia, body.angularVelocity]).toEqual([Infinity, 0]);
  });
});

describe('shapes', () => {
  it('[B2] a box has its corners counter-clockwise from the lower left', () => {
    const body = new World({ resolver: severity() }).addBody(
      box({ x: 5, y: 6, width: 2, height: 4, radius: 0.1, restitution: 0.4, group: 7 }),
    );
    expect(body.particles.map(({ x, y }) => [x, y])).toEqual([
      [4, 4],
      [6, 4],
      [6, 8],
      [4, 8],
    ]);
    for (const { radius, restitution, group, mass } of body.particles) {
      expect([radius, restitution, group, mass]).toEqual([0.1, 0.4, 7, 0.25]);
    }
    expect([body.kind, body.closed, body.whole, body.group]).toEqual(['box', true, true, 7]);
    expect(body.inertia).toBeCloseTo((1 * (2 ** 2 + 4 ** 2)) / 4, 12);
    body.group = 9;
    expect(body.particles.map(({ group }) => group)).toEqual([9, 9, 9, 9]);
  });

  it('[B2] a quarter turn takes each corner to the next', () => {
    const body = new World({ resolver: severity() }).addBody(
      box({ x: 0, y: 0, width: 2, height: 2, angle: Math.PI / 2 }),
    );
    expect(body.particles[0].x).toBeCloseTo(1, 15);
    expect(body.particles[0].y).toBeCloseTo(-1, 15);
  });

  it('[B2] a regular polygon stands on a side, and of four sides is a box', () => {
    const square = new World({ resolver: severity() }).addBody(
      regularPolygon({ x: 0, y: 0, sides: 4, circumradius: Math.SQRT2 }),
    );
    const turned = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ];
    for (const [index, { x, y }] of square.particles.entries()) {
      expect(x).toBeCloseTo(turned[index][0], 14);
      expect(y).toBeCloseTo(turned[index][1], 14);
    }
    expect(square.kind).toBe('polygon');
  });

  it('[B2] a triangle has equal sides unless a height is given', () => {
    const [even, tall] = [triangle({ x: 0, y: 0, width: 2 }), triangle({ x: 0, y: 0, width: 2, height: 3 })];
    const lengths = ({ particles: [p, q, r] }: BodyPlan) =>
      [
        [p, q],
        [q, r],
        [r, p],
      ].map(([a, b]) => Math.hypot(a.x - b.x, a.y - b.y));
    for (const length of lengths(even)) expect(length).toBeCloseTo(2, 14);
    expect(tall.particles.map(({ x, y }) => [x, y])).toEqual([
      [-1, -1],
      [1, -1],
      [0, 2],
    ]);
  });

  it('[B2] a polygon of points stays where they are, unless it is told a place', () => {
    const points = [
      { x: 4, y: 4 },
      { x: 7, y: 4 },
      { x: 4, y: 7 },
    ];
    const [there, moved] = [polygon({ points }), polygon({ points, x: 0, y: 0 })];
    for (const [index, { x, y }] of there.particles.entries()) {
      expect([x, y]).toEqual([points[index].x, points[index].y]);
      expect([moved.particles[index].x, moved.particles[index].y]).toEqual([x - 5, y - 5]);
    }
  });
});

/** The rank of the rigidity matrix: one row a rod, the direction of it in the columns of its ends. */
function rankOfRods({ particles, links }: BodyPlan): number {
  const rows = links.map(({ a, b }) => {
    if (typeof a !== 'number' || typeof b !== 'number') throw new Error('a rod ends elsewhere');
    const row = new Array<number>(particles.length * 2).fill(0);
    row[a * 2] = particles[a].x - particles[b].x;
    row[a * 2 + 1] = particles[a].y - particles[b].y;
    row[b * 2] = -row[a * 2];
    row[b * 2 + 1] = -row[a * 2 + 1];
    return row;
  });
  let rank = 0;
  for (let column = 0; column < particles.length * 2; column++) {
    let pivot = rank;
    for (let r = rank; r < rows.length; r++) if (Math.abs(rows[r][column]) > Math.abs(rows[pivot][column])) pivot = r;
    if (rank === rows.length || Math.abs(rows[pivot][column]) < 1e-9) continue;
    [rows[rank], rows[pivot]] = [rows[pivot], rows[rank]];
    for (let r = rank + 1; r < rows.length; r++) {
      const share = rows[r][column] / rows[rank][column];
      for (let c = column; c < rows[r].length; c++) rows[r][c] -= share * rows[rank][c];
    }
    rank++;
  }
  return rank;
}
