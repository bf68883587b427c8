import {
  box,
  chain,
  DiscContacts,
  EdgeContacts,
  HalfPlane,
  impact,
  type Particle,
  polygon,
  Random,
  rod,
  severity,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { run } from '../helpers.ts';

/** A moment: so short that nothing moves. */
const MOMENT = 1e-12;

/** The contacts of the last step that are none of links, as objects. */
function touches(world: World) {
  const { contacts, links } = world;
  return Array.from({ length: contacts.count }, (_, c) => ({
    a: contacts.a[c],
    b: contacts.b[c],
    end: contacts.edgeEnd[c],
    share: contacts.edgeShare[c],
    normal: [contacts.normalX[c], contacts.normalY[c]] as const,
    penetration: contacts.penetration[c],
    source: contacts.source[c],
  })).filter(({ source }) => source >= links.length);
}

/** Looks for contacts without resolving any. */
function look(world: World) {
  world.step(MOMENT);
  return touches(world);
}

function world(): World {
  const made = new World({ resolver: severity({ iterations: 0 }) });
  made.addContactGenerator(new EdgeContacts(made));
  return made;
}

/** A bar from (0, 0) to (2, 0), radius 0.1. */
function bar(to: World, radii: readonly [number, number] = [0.1, 0.1]): [Particle, Particle] {
  const generator = new EdgeContacts(to);
  to.addContactGenerator(generator);
  const a = to.addParticle({ x: 0, y: 0, radius: radii[0] });
  const b = to.addParticle({ x: 2, y: 0, radius: radii[1] });
  generator.add([to.addLink(rod(a, b))]);
  return [a, b];
}

describe('a particle at an open edge', () => {
  it.each([1, -1])('[C41] is pushed to the side where it is: %i', (side) => {
    const w = new World({ resolver: severity({ iterations: 0 }) });
    const [a, b] = bar(w);
    const p = w.addParticle({ x: 0.5, y: side * 0.25, radius: 0.2 });
    const found = look(w);
    expect(found).toHaveLength(1);
    expect(found[0]).toMatchObject({ a: p.slot, b: a.slot, end: b.slot });
    expect(found[0].share).toBeCloseTo(0.25, 12);
    expect(found[0].normal[0]).toBeCloseTo(0, 12);
    expect(found[0].normal[1]).toBeCloseTo(side, 12);
    expect(found[0].penetration).toBeCloseTo(0.05, 12);
  });

  it('[C41] beyond an end it touches the disc of that end', () => {
    const w = new World({ resolver: severity({ iterations: 0 }) });
    const [, b] = bar(w);
    const p = w.addParticle({ x: 2.12, y: 0.16, radius: 0.2 });
    const [found, ...more] = look(w);
    expect(more).toEqual([]);
    expect(found).toMatchObject({ a: p.slot, b: b.slot, end: -1 });
    expect(found.normal[0]).toBeCloseTo(0.6, 12);
    expect(found.normal[1]).toBeCloseTo(0.8, 12);
    expect(found.penetration).toBeCloseTo(0.1, 12);
  });

  it('[C41] is not touched out of reach, and early by a hundredth of the radii', () => {
    for (const [y, count] of [
      [0.31, 0],
      [0.302, 1],
      [0.3, 1],
    ] as const) {
      // biome-ignore format: one line
      const w = new World({ resolver: severity({ iterations: 0 }) });
      bar(w);
      w.addParticle({ x: 1, y, radius: 0.2 });
      expect(look(w)).toHaveLength(count);
    }
  });

  it('[C41] the edge is as thick as the thinner end; a thicker one sticks out of it', () => {
    const w = new World({ resolver: severity({ iterations: 0 }) });
    bar(w, [0.1, 0.5]);
    w.addParticle({ x: 1, y: 0.25, radius: 0.2 });
    w.addParticle({ x: 1.9, y: 0.6, radius: 0.2 });
    const found = look(w);
    expect(found.map(({ end }) => end)).toEqual([1, -1]);
    expect(found[0].penetration).toBeCloseTo(0.05, 12);
    expect(found[1].penetration).toBeCloseTo(0.7 - Math.hypot(0.1, 0.6), 12);
  });

  it('[C42] that went through in this step is sent back; round the end it is not', () => {
    for (const [x, count] of [
      [1, 1],
      [3, 0],
    ] as const) {
      // biome-ignore format: one line
      const w = new World({ resolver: severity() });
      const [a, b] = bar(w);
      a.mass = b.mass = Infinity;
      const p = w.addParticle({ x, y: 1, vy: -120, radius: 0.05 });
      w.step(1 / 60);
      expect(touches(w)).toHaveLength(count);
      expect(Math.sign(p.y)).toBe(count === 1 ? 1 : -1);
    }
  });
});

describe('a particle at a closed outline', () => {
  const square = (w: World, radius = 0.1, angle = 0) =>
    w.addBody(box({ x: 0, y: 0, width: 2, height: 2, radius, angle, mass: 4 }));

  it.each([
    [0, 1.2, 0, 1],
    [0, -1.2, 0, -1],
    [1.2, 0, 1, 0],
    [-1.2, 0, -1, 0],
  ])('[C42] is pushed outwards: at (%d, %d)', (x, y, nx, ny) => {
    const w = world();
    square(w);
    w.addParticle({ x, y, radius: 0.15 });
    const [found, ...more] = look(w);
    expect(more).toEqual([]);
    expect(found.normal[0]).toBeCloseTo(nx, 12);
    expect(found.normal[1]).toBeCloseTo(ny, 12);
    expect(found.penetration).toBeCloseTo(0.05, 12);
    expect(found.share).toBeCloseTo(0.5, 12);
  });

  it('[C42] whichever way the outline goes round', () => {
    for (const points of [
      [
        [-1, -1],
        [1, -1],
        [0, 1],
      ],
      [
        [-1, -1],
        [0, 1],
        [1, -1],
      ],
    ]) {
      // biome-ignore format: one line
      const w = world();
      w.addBody(polygon({ x: 0, y: 0, points: points.map(([x, y]) => ({ x, y })), radius: 0.1 }));
      const bottom = Math.min(...w.particles.y.subarray(0, 3));
      w.addParticle({ x: 0, y: bottom - 0.15, radius: 0.1 });
      const [found, ...more] = look(w);
      expect(more).toEqual([]);
      expect(found.normal[1]).toBeCloseTo(-1, 12);
    }
  });

  it('[C42] at a corner it touches one disc, once, though two edges end there', () => {
    const w = world();
    square(w);
    w.addParticle({ x: 1.1, y: 1.1, radius: 0.1 });
    const [found, ...more] = look(w);
    expect(more).toEqual([]);
    expect(found.end).toBe(-1);
    expect(found.normal[0]).toBeCloseTo(Math.SQRT1_2, 12);
  });

  it('[C42] in a notch it touches both edges', () => {
    const w = world();
    const points = [{ x: -2, y: 0 }, { x: 2, y: 0 }, { x: 2, y: 2 }, { x: 0, y: 0.5 }, { x: -2, y: 2 }]; // biome-ignore format: one line
    const body = w.addBody(polygon({ x: 0, y: 0, points, radius: 0.1 }));
    const notch = body.particles[3];
    w.addParticle({ x: notch.x, y: notch.y + 0.3, radius: 0.3 });
    const found = look(w);
    expect(found).toHaveLength(2);
    for (const { normal } of found) expect(normal[1]).toBeCloseTo(0.8, 12);
  });

  it('[C42] inside, it leaves by the nearest edge', () => {
    const w = world();
    square(w);
    w.addParticle({ x: 0.2, y: -0.7, radius: 0.15 });
    const [found, ...more] = look(w);
    expect(more).toEqual([]);
    expect(found.normal[1]).toBeCloseTo(-1, 12);
    expect(found.penetration).toBeCloseTo(0.55, 12);
  });

  it('[C42] inside, having come in during the step, by the edge through which it came', () => {
    const w = new World({ resolver: severity() });
    w.addContactGenerator(new EdgeContacts(w));
    const body = square(w, 0.05);
    for (const particle of body.particles) particle.mass = Infinity;
    const p = w.addParticle({ x: 0.8, y: 1.1, vy: -60, radius: 0.02 }); // it ends the step 0.2 m from the right side
    w.step(1 / 60);
    expect(p.y).toBeCloseTo(1.07, 6);
    expect(p.x).toBeCloseTo(0.8, 6);
  });

  it('[C42] right through it in one step, it is sent back, too', () => {
    const w = new World({ resolver: severity() });
    w.addContactGenerator(new EdgeContacts(w));
    const plate = w.addBody(box({ x: 0, y: 0, width: 4, height: 0.1, radius: 0.01 }));
    for (const particle of plate.particles) particle.mass = Infinity;
    const p = w.addParticle({ x: 0.3, y: 0.5, vy: -60, radius: 0.01 });
    w.step(1 / 60);
    expect(p.y).toBeCloseTo(0.07, 6);
  });

  it('[C42] points and outlines without a radius touch, too', () => {
    const w = world();
    square(w, 0);
    w.addParticle({ x: 0.3, y: 0.99 });
    const [found] = look(w);
    expect(found.normal[1]).toBeCloseTo(1, 12);
    expect(found.penetration).toBeCloseTo(0.01, 12);
  });
});

describe('two bodies', () => {
  it('[C42] of which one is deep in the other part as wholes, the shortest way', () => {
    const w = world();
    for (const [x, y] of [[0, 0], [0.3, 0.8]]) w.addBody(box({ x, y, width: 1, height: 1, radius: 0.05 })); // biome-ignore format: one line
    const found = look(w).filter(({ penetration }) => penetration > 0.1);
    expect(found.length).toBeGreaterThan(0);
    for (const { a, normal } of found) expect(normal[1]).toBeCloseTo(a >= 4 ? 1 : -1, 12);
  });

  it('[C42] that are deep in each other come apart, and neither is torn', () => {
    const w = new World({ resolver: severity({ iterations: 2000 }) });
    w.addContactGenerator(new EdgeContacts(w));
    const [a, b] = [
      [0, 0],
      [0.2, 0.7],
    ].map(([x, y]) => w.addBody(box({ x, y, width: 1, height: 1, radius: 0.05 })));
    run(w, 30);
    expect(Math.hypot(b.x - a.x, b.y - a.y)).toBeGreaterThan(1.09);
    for (const { penetration } of touches(w)) expect(penetration).toBeLessThan(1e-6);
    for (const link of w.links) {
      const { x, y } = link.a;
      expect(Math.hypot(link.b.x - x, link.b.y - y)).toBeLessThan(1.45);
    }
  });

  it('[C43] of one size on each other touch corner on corner, upwards, each pair once', () => {
    const w = world();
    for (const y of [0, 1.2]) w.addBody(box({ x: 0, y, width: 1, height: 1, radius: 0.1 }));
    const found = look(w);
    expect(found.map(({ a, b, end }) => [a, b, end])).toEqual([
      [2, 5, -1],
      [3, 4, -1],
    ]);
    for (const { normal } of found) expect(normal[1]).toBeCloseTo(-1, 12);
  });

  it('[C43] shifted, each rests with one corner on the other', () => {
    const w = world();
    for (const n of [0, 1]) w.addBody(box({ x: n * 0.3, y: n * 1.2, width: 1, height: 1, radius: 0.1 }));
    const found = look(w);
    expect(found.map(({ a, b, end }) => [a, b, end])).toEqual([
      [2, 4, 5],
      [4, 2, 3],
    ]);
    expect(found[0].normal[1]).toBeCloseTo(-1, 12);
    expect(found[1].normal[1]).toBeCloseTo(1, 12);
  });
});

describe('what does not collide', () => {
  it('[C40] the particles of a body with its own outline, nor a chain with itself', () => {
    const w = world();
    w.addBody(box({ x: 0, y: 0, width: 0.1, height: 0.1, radius: 0.2 }));
    w.addBody(chain({ from: { x: 5, y: 0 }, to: { x: 5, y: 0.5 }, length: 3, links: 30, free: 'both', radius: 0.1 }));
    expect(look(w)).toEqual([]);
  });

  it('[C40] a particle with an edge to whose end a link joins it', () => {
    const w = world();
    const body = w.addBody(box({ x: 0, y: 0, width: 1, height: 1, radius: 0.1 }));
    const p = w.addParticle({ x: 0.4, y: 0.5, radius: 0.1 });
    expect(look(w)).toHaveLength(1);
    const link = w.addLink(rod(p, body.particles[2]));
    expect(look(w)).toEqual([]);
    w.removeLink(link);
    expect(look(w)).toHaveLength(1);
  });

  it('[C40] what cannot move with what cannot move', () => {
    const w = world();
    const body = w.addBody(box({ x: 0, y: 0, width: 1, height: 1, radius: 0.1 }));
    for (const particle of body.particles) particle.mass = Infinity;
    const p = w.addParticle({ x: 0.2, y: 0.6, radius: 0.1, mass: Infinity });
    expect(look(w)).toEqual([]);
    p.mass = 1;
    expect(look(w)).toHaveLength(1);
  });

  it('[C40] a link that is in no open body, unless it is added, and once it is out of the world', () => {
    const w = new World({ resolver: severity({ iterations: 0 }) });
    const edges = w.addContactGenerator(new EdgeContacts(w));
    const ends = [0, 2].map((x) => w.addParticle({ x, y: 0, radius: 0.1 }));
    const link = w.addLink(rod(ends[0], ends[1]));
    w.addParticle({ x: 1, y: 0.1, radius: 0.1 });
    expect(look(w)).toEqual([]);
    edges.add([link]);
    expect(look(w)).toHaveLength(1);
    w.removeLink(link);
    expect(look(w)).toEqual([]);
  });
});

describe('filters and sensors', () => {
  it('[C40] a particle and an edge touch where category and mask of both ends let them', () => {
    const w = new World({ resolver: severity({ iterations: 0 }) });
    const [a, b] = bar(w);
    const p = w.addParticle({ x: 1, y: 0.2, radius: 0.2, mask: 2 });
    expect(look(w)).toHaveLength(0);
    a.category = 2;
    expect(look(w)).toHaveLength(0);
    b.category = 2;
    expect(look(w)).toHaveLength(1);
    a.mask = 4;
    expect(look(w)).toHaveLength(0);
    p.category = 5;
    expect(look(w)).toHaveLength(1);
  });

  it('[C40] a sensor is told of and does not push', () => {
    const w = new World({ resolver: severity() });
    bar(w);
    const p = w.addParticle({ x: 1, y: 0.2, vy: -1, radius: 0.2, sensor: true });
    let told = 0;
    w.on('contactBegin', ({ a }) => {
      if (a === p) told++;
    });
    w.step(1 / 60);
    expect([told, p.vy, w.contacts.count]).toEqual([1, -1, 2]);
  });

  it('[C48] under impact edges do not collide', () => {
    const w = new World({ resolver: impact() });
    bar(w);
    const p = w.addParticle({ x: 1, y: 0.4, vy: -30, radius: 0.05 });
    w.step(1 / 60);
    expect(p.y).toBeCloseTo(-0.1, 12);
  });
});

describe('what comes and goes', () => {
  it('[C40] bodies that are added later collide; a broken link and a removed body do no more', () => {
    const w = world();
    const p = w.addParticle({ x: 0.25, y: 0.05, radius: 0.1 });
    expect(look(w)).toEqual([]);
    const rope = w.addBody(chain({ from: { x: 0, y: 0 }, to: { x: 1, y: 0 }, links: 2, free: 'both', radius: 0.1 }));
    expect(look(w)).toHaveLength(1);
    w.removeLink(rope.links[0]);
    expect(look(w)).toEqual([]);
    p.x = 0.75;
    expect(look(w)).toHaveLength(1);
    rope.remove();
    expect(look(w)).toEqual([]);
  });

  it('[C40] a chain from particle to particle collides from end to end', () => {
    const w = world();
    const ends = [0, 1].map((x) => w.addParticle({ x, y: 0, radius: 0.1, mass: Infinity }));
    w.addBody(chain({ from: ends[0], to: ends[1], links: 4, radius: 0.1 }));
    for (const x of [0.1, 0.35, 0.65, 0.9]) w.addParticle({ x, y: 0.05, radius: 0.01 });
    expect(look(w).map(({ end }) => end >= 0)).toEqual([true, true, true, true]);
  });

  it('[C44] contacts are sorted by slots, and are those of a new generator, whatever happened before', () => {
    const random = new Random(7);
    const w = new World({ gravity: { x: 0, y: -9.81 } });
    const kept = w.addContactGenerator(new EdgeContacts(w));
    w.addContactGenerator(new DiscContacts());
    w.addShape(new HalfPlane());
    for (const x of [-1.5, 1.5]) w.addShape(new HalfPlane({ point: { x, y: 0 }, normal: { x: -Math.sign(x), y: 0 } }));
    let compared = 0;
    for (let step = 0; step < 240; step++) {
      if (step % 6 === 0) {
        const [x, y, radius] = [random.between(-1, 1), random.between(1, 2), random.between(0.02, 0.1)];
        if (random.next() < 0.4) w.addBody(box({ x, y, width: 0.4, height: 0.3, angle: x, vy: -5, radius }));
        else if (random.next() < 0.5) w.addParticle({ x, y, vx: 30 * x, radius });
        else w.addBody(chain({ from: { x, y }, to: { x: x + 0.8, y }, free: 'both', links: 8, radius: 0.02 }));
      }
      if (step % 30 === 29) w.bodies[random.integer(0, w.bodies.length - 1)].remove();
      w.step(1 / 60);
      w.removeContactGenerator(kept);
      const list = (generator: EdgeContacts) => {
        w.addContactGenerator(generator);
        const found: unknown[] = [];
        const { lookAhead, margin, linkVersion, takesEdges } = w.contacts as never;
        const areLinked = (a: number, b: number) =>
          w.links.some((link) => {
            const [i, j] = [link.a, link.b].map((end) => ('slot' in end ? (end.slot as number) : -1));
            return (i === a && j === b) || (i === b && j === a);
          });
        const push = (a: number, b: number, ...rest: number[]) => found.push([a, b, -1, ...rest]);
        const makeEdge = (end: number) => {
          (found[found.length - 1] as number[])[2] = end;
        };
        generator.addContacts(
          w.particles,
          { lookAhead, margin, linkVersion, takesEdges, areLinked, push, makeEdge } as never,
          1 / 60,
        );
        w.removeContactGenerator(generator);
        return found as number[][];
      };
      const old = list(kept);
      expect(old).toEqual(list(new EdgeContacts(w)));
      expect(old).toEqual(old.toSorted((p, q) => p[0] - q[0] || p[1] - q[1] || p[2] - q[2]));
      compared += old.length;
      w.addContactGenerator(kept);
    }
    expect(compared).toBeGreaterThan(500);
  });
});

describe('errors', () => {
  it('[X1] what is no world, and what is no list of links', () => {
    expect(() => new EdgeContacts(undefined as never)).toThrow('EdgeContacts: it must be given the world');
    const w = new World();
    expect(() => new EdgeContacts(w).add(3 as never)).toThrow('EdgeContacts.add: links must be a list of links; got 3');
  });

  it('[C11] at the limit of contacts none becomes another', () => {
    const w = new World({ resolver: severity({ iterations: 0 }), contactLimit: 2 });
    bar(w);
    w.addParticle({ x: 1, y: 0.1, radius: 0.1 });
    look(w);
    expect([w.contacts.count, w.contacts.leftOut]).toEqual([2, 1]);
    expect(Array.from(w.contacts.edgeEnd.subarray(0, 2))).toEqual([-1, -1]);
  });
});
