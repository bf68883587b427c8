import { aggregate, type BodyPlan, box, chain, cloth, polygon, regularPolygon, rod, triangle, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { failsUnchanged, thrownBy } from '../helpers.ts';

const place = { x: 0, y: 0 };
const crate = { ...place, width: 1, height: 1 };
const rope = { from: { x: 0, y: 0 }, to: { x: 1, y: 0 }, links: 4 };
const net = { ...place, width: 1, height: 1, columns: 3, rows: 3 };
const wrong = (value: unknown): never => value as never;

const builders: [string, () => unknown, RegExp, ErrorConstructor][] = [
  ['no options', () => box(wrong(undefined)), /^box: options must be an object such as \{ x: 0/, TypeError],
  [
    'no place',
    () => box(wrong({ width: 1, height: 1 })),
    /^box: x must be a finite number of metres; got und/,
    TypeError,
  ],
  ['no width', () => box(wrong({ ...place, height: 1 })), /^box: width must be a positive, finite/, TypeError],
  ['width 0', () => box({ ...crate, width: 0 }), /^box: width must .*; got 0\./, RangeError],
  [
    'NaN angle',
    () => box({ ...crate, angle: NaN }),
    /^box: angle must be a finite number of radians; got NaN/,
    RangeError,
  ],
  ['mass', () => box({ ...crate, mass: Infinity }), /^box: mass must be .*got Infinity\. To pin a body/, RangeError],
  ['radius', () => box({ ...crate, radius: -1 }), /^box: radius must be a finite number of metres, 0 or/, RangeError],
  [
    'restitution',
    () => box({ ...crate, restitution: 2 }),
    /^box: restitution must be a number from 0 to 1/,
    RangeError,
  ],
  ['breakForce', () => box({ ...crate, breakForce: 0 }), /^box: breakForce must be a positive number/, RangeError],
  ['turning', () => box({ ...crate, angularVelocity: Infinity }), /^box: angularVelocity must be/, RangeError],
  ['height', () => triangle({ ...place, width: 1, height: -1 }), /^triangle: height must be a pos/, RangeError],
  [
    'sides',
    () => regularPolygon({ ...place, sides: 2, circumradius: 1 }),
    /sides must be a whole number from 3/,
    RangeError,
  ],
  ['points', () => polygon({ points: wrong('abc') }), /^polygon: points must be a list of \{ x, y \}/, TypeError],
  ['two points', () => polygon({ points: [place, place] }), /^polygon: the number of points must be/, RangeError],
  [
    'a corner twice',
    () => polygon({ points: [place, { x: 1, y: 0 }, { x: 0, y: 1 }, place] }),
    /corners 0 and 3 are 0 m apart/,
    RangeError,
  ],
  [
    'a line',
    () => polygon({ points: [place, { x: 1, y: 1 }, { x: 2, y: 2 }] }),
    /^polygon: corners must not lie on one line/,
    RangeError,
  ],
  [
    'no end',
    () => chain(wrong({ from: place, links: 3 })),
    /^chain: to must be a particle or a fixed point/,
    TypeError,
  ],
  ['no links', () => chain({ from: place, to: rope.to }), /^chain: links or linkLength must be given/, TypeError],
  [
    'both',
    () => chain({ ...rope, linkLength: 1 }),
    /^chain: links or linkLength must be given, and not both/,
    TypeError,
  ],
  ['half a link', () => chain({ ...rope, links: 1.5 }), /^chain: links must be a whole number from 1/, RangeError],
  [
    'too many',
    () => chain({ ...rope, links: wrong(undefined), linkLength: 1e-9 }),
    /^chain: length \/ linkLength/,
    RangeError,
  ],
  [
    'short',
    () => chain({ ...rope, length: 0.9 }),
    /^chain: length must reach from end to end, at least 1 m/,
    RangeError,
  ],
  ['no way', () => chain({ ...rope, to: place }), /^chain: length must be .*one place: give one/, RangeError],
  ['one link', () => chain({ ...rope, links: 1 }), /^chain: a chain must have a particle of its own/, RangeError],
  [
    'a long rod',
    () => chain({ ...rope, links: 1, free: 'to', length: 2, kind: 'rod' }),
    /a single rod must be/,
    RangeError,
  ],
  [
    'weights',
    () => chain({ ...rope, weights: [1, 2] }),
    /weights must have one number for each particle, 3/,
    RangeError,
  ],
  ['weight 0', () => chain({ ...rope, weights: [1, 0, 1] }), /^chain: weights\[1\] must be a positive/, RangeError],
  ['kind', () => chain({ ...rope, kind: wrong('spring') }), /kind must be 'cable' or 'rod'; got "spring"/, RangeError],
  ['free', () => chain({ ...rope, free: wrong('all') }), /^chain: free must be 'from' or 'to' or 'both'/, RangeError],
  ['compliance', () => box({ ...crate, compliance: -1 }), /^box: compliance must be a finite number of m/, RangeError],
  ['link damping', () => chain({ ...rope, linkDamping: 2 }), /^chain: linkDamping must be a number from 0/, RangeError],
  ['columns', () => cloth({ ...net, columns: 1 }), /^cloth: columns must be a whole number from 2 to/, RangeError],
  [
    'rows',
    () => cloth({ ...net, rows: 2.5 }),
    /^cloth: rows must be a whole number from 2 to 1000; got 2.5/,
    RangeError,
  ],
  ['its place', () => cloth({ ...net, y: NaN }), /^cloth: y must be a finite number of metres/, RangeError],
  ['its width', () => cloth({ ...net, width: 0 }), /^cloth: width must be a positive, finite number/, RangeError],
  ['its kind', () => cloth({ ...net, kind: wrong('silk') }), /^cloth: kind must be 'cable' or 'rod'; got/, RangeError],
  [
    'its pins',
    () => cloth({ ...net, pinned: wrong('left') }),
    /^cloth: pinned must be 'top', .* got "left"/,
    TypeError,
  ],
];

describe('builders', () => {
  it.each(builders)('[B14] refuse what makes no sense: %s', (_name, build, message, type) => {
    const error = thrownBy(build as () => void);
    expect(error.message).toMatch(message);
    expect(error).toBeInstanceOf(type);
  });

  it('[B14] a free end is a point', () => {
    const from = new World().addParticle(place);
    expect(() => chain({ ...rope, from, free: 'from' })).toThrow(/^chain: from must be a point .* is free; got a part/);
  });
});

const dot = { x: 0, y: 0 };
const bar = (links: BodyPlan['links'] | unknown) =>
  aggregate({ kind: 'bar', particles: [dot, { x: 1, y: 0 }], links: wrong(links) });
const stranger = new World().addParticle({ x: 0, y: 0 });
const gone = new World().addParticle({ x: 0, y: 0 });
gone.remove();

const plans: [string, () => BodyPlan, RegExp][] = [
  ['nothing', () => wrong(undefined), /^World.addBody: a body must be what a builder such as box .*; got undefined/],
  [
    'bare data',
    () => wrong({ kind: 'bar', particles: [dot], links: [] }),
    /^World.addBody: a body must be what a builder/,
  ],
  ['no particles', () => aggregate({ kind: 'bar', particles: [], links: [] }), /a list of particles, at least one/],
  ['no links', () => bar(undefined), /and a list of links/],
  [
    'a bad particle',
    () => aggregate({ kind: 'bar', particles: [dot, { x: NaN, y: 0 }], links: [] }),
    /^World.addBody, particle 1 of the bar: x must be a finite number of metres; got NaN/,
  ],
  ['an angle', () => aggregate({ kind: 'bar', particles: [dot], links: [], angle: NaN }), /angle must be a finite/],
  ['a mass too small', () => box({ ...crate, mass: 1e-308 }), /^World.addBody, particle 0 of the box: mass must be/],
  ['no join', () => bar([{ a: 0, b: 1 }]), /^World.addBody, link 0 of the bar: join must be a function/],
  ['no such place', () => bar([{ a: 0, b: 2, join: rod }]), /b must be the place of a particle, 0 to 1; got 2/],
  ['one end twice', () => bar([{ a: 1, b: 1, join: rod }]), /a link must have two ends/],
  ['no end of its own', () => bar([{ a: dot, b: { x: 1, y: 1 }, join: rod }]), /one of the body's own particles/],
  ['a particle of another world', () => bar([{ a: 0, b: stranger, join: rod }]), /b must be a particle of this world/],
  ['a particle that was removed', () => bar([{ a: 0, b: gone, join: rod }]), /it was removed/],
];

describe('World.addBody', () => {
  it.each(plans)('[B14] leaves the world as it was, bit for bit: %s', (_name, plan, message) => {
    const world = new World();
    world.addBody(box(crate));
    const error = failsUnchanged(world, () => world.addBody(plan()));
    expect(error.message).toMatch(message);
    expect([world.bodies.length, world.links.length]).toEqual([1, 6]);
  });

  it('[B14] takes out what was built when a join of the game throws', () => {
    const world = new World();
    const joins = [rod, () => wrong({ a: 0 }), rod];
    const fails = () => {
      throw new Error('no glue');
    };
    const plan = (join: (typeof joins)[number]) =>
      bar([
        { a: 0, b: 1, join: rod },
        { a: 0, b: dot, join },
      ]);
    expect(() => world.addBody(plan(fails))).toThrow('no glue');
    expect(() => world.addBody(plan(joins[1]))).toThrow(/a link must have a method/);
    expect([world.particleCount, world.links.length, world.bodies.length]).toEqual([0, 0, 0]);
  });

  it('[B14] is for between steps', () => {
    const world = new World();
    const body = world.addBody(box(crate));
    const within = (act: () => void) => {
      const force = world.addForce({ apply: act });
      expect(() => world.step(1 / 60)).toThrow(/between steps/);
      world.removeForce(force);
    };
    within(() => world.addBody(box(crate)));
    within(() => world.removeBody(body));
    within(() => body.remove());
    expect(world.bodies).toEqual([body]);
  });
});

describe('Body', () => {
  it('[B14] once removed it says so', () => {
    const world = new World();
    const body = world.addBody(box(crate));
    body.remove();
    for (const use of [() => body.mass, () => body.pose(), () => body.applyImpulse(1, 0), () => body.remove()]) {
      expect(use).toThrow(/^Body\.\w+: the body must be in its world; this box was removed\. Ask body\.alive/);
    }
    expect(() => world.removeBody(body)).toThrow(/^World.removeBody: a body must be in the world to be taken out/);
    expect(() => world.removeBody(wrong(3))).toThrow(/got|is not/);
  });

  it('[B14] refuses pushes that are not finite, and stays as it was', () => {
    const world = new World();
    const body = world.addBody(box(crate));
    const messages = [
      () => body.applyImpulse(NaN, 0),
      () => body.applyForce(0, Infinity, 0, 0),
      () => body.applyImpulse(0, 0, NaN, 0),
      () => wrong(body.applyForce(wrong('1'), 0)),
      () => {
        body.group = 1.5;
      },
    ].map((act) => failsUnchanged(world, act).message);
    expect(messages).toEqual([
      'Body.applyImpulse: ix must be a finite number of newton-seconds; got NaN.',
      'Body.applyForce: fy must be a finite number of newtons; got Infinity.',
      'Body.applyImpulse: x must be a finite number of metres; got NaN.',
      'Body.applyForce: fx must be a finite number of newtons; got "1".',
      'Body.group: group must be a whole number from 0 to 65535; got 1.5.',
    ]);
  });
});
