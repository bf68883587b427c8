import { chain, DistanceLink, rod, severity, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { hashOf, run } from '../helpers.ts';

const left = { x: -2, y: 0 };
const right = { x: 2, y: 0 };

describe('building', () => {
  it('[B11] joins two fixed points by links of one length, and owns what is between', () => {
    const world = new World({ resolver: severity() });
    const body = world.addBody(chain({ from: left, to: right, links: 8, mass: 3.5, radius: 0.05, group: 2 }));
    expect([body.particles.length, body.links.length]).toEqual([7, 8]);
    expect(body.mass).toBeCloseTo(3.5, 12);
    expect([body.kind, body.closed, body.group]).toEqual(['chain', false, 2]);
    for (const [index, { x, y, mass, radius }] of body.particles.entries()) {
      expect(x).toBeCloseTo(-1.5 + index / 2, 14);
      expect([y, mass, radius]).toEqual([0, 0.5, 0.05]);
    }
    for (const link of body.links as DistanceLink[]) {
      expect([link.kind, link.minLength, link.maxLength]).toEqual(['cable', 0, 0.5]);
    }
    expect(body.links[0].a).toEqual(left);
    expect(body.links[7].b).toEqual(right);
  });

  it('[B11] takes as many links as none is longer than asked for', () => {
    const count = (linkLength: number) => chain({ from: left, to: right, linkLength }).links.length;
    expect([count(1), count(0.1), count(1.5), count(3.9)]).toEqual([4, 40, 3, 2]);
  });

  it('[B11] hangs on particles that stay when it goes', () => {
    const world = new World({ resolver: severity() });
    const [pin, ball] = [world.addParticle({ ...left, mass: Infinity }), world.addParticle({ ...right, mass: 5 })];
    const body = world.addBody(chain({ from: pin, to: ball, links: 4, mass: 0.3 }));
    expect([world.particleCount, body.particles.length, body.mass]).toEqual([5, 3, 0.3]);
    expect([body.links[0].a, body.links[3].b]).toEqual([pin, ball]);
    body.remove();
    expect([world.particleCount, world.links.length, pin.alive, ball.alive]).toEqual([2, 0, true, true]);
  });

  it('[B11] has a particle of its own at a free end', () => {
    const at = (free: 'from' | 'to' | 'both') =>
      new World({ resolver: severity() })
        .addBody(chain({ from: left, to: right, links: 4, free }))
        .particles.map(({ x }) => x);
    expect(at('to')).toEqual([-1, 0, 1, 2]);
    expect(at('from')).toEqual([-2, -1, 0, 1]);
    expect(at('both')).toEqual([-2, -1, 0, 1, 2]);
  });

  it('[B11] spreads the mass by weights', () => {
    const body = new World({ resolver: severity() }).addBody(
      chain({ from: left, to: right, links: 4, mass: 12, weights: [1, 2, 3] }),
    );
    expect(body.particles.map(({ mass }) => mass)).toEqual([2, 4, 6]);
  });

  it.each([
    ['a rope between two points', left, right, 5, 10],
    ['a rod that is nearly taut', left, right, 4.0001, 7],
    ['one that goes to the left', right, left, 6, 9],
    ['one that goes up', { x: 0, y: 0 }, { x: 0, y: 1 }, 3, 5],
    ['one that ends where it begins', left, left, 3, 6],
    ['two links', left, right, 5, 2],
  ])(
    '[B12] longer than the way it starts as an arc of links of the right length: %s',
    (_name, from, to, length, links) => {
      const { particles } = chain({ from, to, length, links, kind: 'rod' });
      const places = [from, ...particles, to];
      for (let i = 0; i < links; i++) {
        const [p, q] = [places[i], places[i + 1]];
        expect(Math.hypot(p.x - q.x, p.y - q.y)).toBeCloseTo(length / links, 12);
      }
      if (from.y === to.y && from.x !== to.x) for (const { y } of particles) expect(y).toBeLessThan(0);
    },
  );

  it('[B1] the same plan gives the same bits twice', () => {
    const build = () => {
      const world = new World({ resolver: severity(), gravity: { x: 0, y: -9.81 } });
      world.addBody(chain({ from: left, to: right, length: 5, links: 12 }));
      run(world, 30);
      return world;
    };
    expect(hashOf(build())).toBe(hashOf(build()));
  });
});

describe('hanging', () => {
  it.each(['cable', 'rod'] as const)(
    '[B13] a chain of %ss comes to hang in a catenary, to a fiftieth of its sag',
    (kind) => {
      const world = new World({ gravity: { x: 0, y: -9.81 }, resolver: severity({ iterations: 1000 }) });
      const body = world.addBody(chain({ from: left, to: right, length: 5, links: 10, mass: 2, damping: 0.1, kind }));
      run(world, 600);
      const a = catenary(4, 5);
      const hang = (x: number) => a * (Math.cosh(x / a) - Math.cosh(2 / a));
      for (const { x, y } of body.particles) expect(Math.abs(y / hang(0) - hang(x) / hang(0))).toBeLessThan(0.02);
      for (const link of body.links as DistanceLink[]) expect(Math.abs(link.strain)).toBeLessThan(1e-4);
    },
  );

  it('[B13] pulls at its ends with its weight', () => {
    const world = new World({ gravity: { x: 0, y: -9.81 }, resolver: severity({ iterations: Infinity }) });
    const body = world.addBody(chain({ from: left, to: { x: -2, y: -3 }, links: 3, mass: 6, free: 'to', kind: 'rod' }));
    run(world, 60);
    const { count, source, impulse } = world.contacts;
    let pull = 0;
    for (let c = 0; c < count; c++) if (source[c] === 0) pull += impulse[c] * 60;
    expect(pull).toBeCloseTo(body.mass * 9.81, 6);
  });
});

describe('losing parts', () => {
  it('[B8] a particle that is removed takes its links along, and the chain goes on with what is left', () => {
    const world = new World({ resolver: severity() });
    const body = world.addBody(chain({ from: left, to: right, links: 8, mass: 7 }));
    const [, , third] = body.particles;
    third.remove();
    expect([body.alive, body.whole, body.particles.length, body.links.length]).toEqual([true, false, 6, 6]);
    expect(body.mass).toBeCloseTo(6, 12);
    expect(world.bodies).toEqual([body]);
    for (const particle of body.particles) particle.remove();
    expect([body.alive, world.bodies, world.links]).toEqual([false, [], []]);
  });

  it('[B8] a slot that is used again by another particle is not of the body', () => {
    const world = new World({ resolver: severity() });
    const body = world.addBody(chain({ from: left, to: right, links: 4 }));
    const [first] = body.particles;
    first.remove();
    const other = world.addParticle({ x: 0, y: 9, mass: 100 });
    expect(other.slot).toBe(first.slot);
    expect(body.particles).not.toContain(other);
    expect(body.mass).toBeCloseTo(2 / 3, 12);
    body.remove();
    expect([other.alive, world.particleCount]).toEqual([true, 1]);
  });

  it('[B8] a link that broke or was taken out is no longer of the body', () => {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -9.81 } });
    const body = world.addBody(chain({ from: left, to: right, links: 4, mass: 50, breakForce: 10, kind: 'rod' }));
    world.removeLink(body.links[1]);
    expect(body.links.length).toBe(3);
    let broken = 0;
    world.on('linkBroke', () => broken++);
    run(world, 30);
    expect(broken).toBeGreaterThan(0);
    expect(body.links.length).toBe(3 - broken);
    expect([body.whole, body.links.every((link) => link instanceof DistanceLink)]).toEqual([true, true]);
  });

  it('[B11] an end that is removed takes the last link along', () => {
    const world = new World({ resolver: severity() });
    const ball = world.addParticle({ ...right, mass: 5 });
    const body = world.addBody(chain({ from: left, to: ball, links: 4 }));
    ball.remove();
    expect([body.whole, body.links.length]).toEqual([true, 3]);
    world.addLink(rod(body.particles[2], right));
    expect(body.links.length).toBe(3);
  });

  it('[B8] it expires with its particles', () => {
    const world = new World({ resolver: severity() });
    const body = world.addBody(chain({ from: left, to: right, links: 4, lifetime: 0.5 }));
    run(world, 31);
    expect([body.alive, world.bodies]).toEqual([false, []]);
  });
});

/** The parameter a of the catenary y = a·cosh(x/a) of a length over a span: length = 2a·sinh(span / 2a), by bisection. */
function catenary(span: number, length: number): number {
  let [low, high] = [0.1, 100];
  for (let i = 0; i < 100; i++) {
    const a = (low + high) / 2;
    if (2 * a * Math.sinh(span / 2 / a) > length) low = a;
    else high = a;
  }
  return low;
}
