import {
  box,
  cable,
  DiscContacts,
  EdgeContacts,
  type ForceGenerator,
  HalfPlane,
  impact,
  Random,
  type Resolver,
  rod,
  severity,
  substep,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { hashOf, run } from '../../helpers.ts';

/** Discs, and unless told otherwise boxes and chains, that fall into a box; some are removed on the way. */
function scene(options: { capacity?: number; resolver?: Resolver } = {}, steps = 240, links = true): World {
  const random = new Random(11);
  const world = new World({ gravity: { x: 0, y: -9.81 }, ...options });
  world.addShape(new HalfPlane({ friction: 0.5, restitution: 0.2 }));
  world.addShape(new HalfPlane({ normal: { x: 1, y: 0 } }));
  world.addShape(new HalfPlane({ normal: { x: -1, y: 0 }, point: { x: 10, y: 0 } }));
  world.addContactGenerator(new DiscContacts());
  world.addContactGenerator(new EdgeContacts(world));
  const discs = Array.from({ length: 80 }, (_, k) =>
    world.addParticle({
      x: 0.6 + (k % 16) * 0.58,
      y: 0.5 + Math.floor(k / 16),
      vx: random.between(-3, 3),
      radius: random.between(0.1, 0.25),
      mass: random.between(0.1, 5),
      restitution: random.between(0, 0.6),
      friction: 0.4,
    }),
  );
  for (let k = 0; links && k < 15; k++)
    world.addLink(k % 2 ? rod(discs[k], discs[k + 1]) : cable(discs[k], discs[k + 1]));
  for (const x of links ? [2, 5, 8] : [])
    world.addBody(box({ x, y: 7, width: 0.8, height: 0.6, radius: 0.05, angle: x, friction: 0.5 }));
  for (let step = 0; step < steps; step++) advance(world, step);
  return world;
}

/** Takes a step, before some of which a disc is removed. */
function advance(world: World, step: number): void {
  if (step % 40 === 20) world.particleAt(50 + step / 20).remove();
  world.step(1 / 60);
}

describe('the same calls', () => {
  it('[S20] give the same bits, whatever room there was for particles', () => {
    const first = hashOf(scene());
    expect(hashOf(scene())).toBe(first);
    for (const capacity of [0, 1, 100, 5000]) expect(hashOf(scene({ capacity }))).toBe(first);
  });

  it('[S20] give the same bits beside other worlds, also where one resolver serves several', () => {
    const first = hashOf(scene());
    const resolver = substep();
    const [one, other] = [scene({ resolver }, 0), scene({ resolver }, 0)];
    other.addParticle({ x: 5, y: 9, radius: 0.2 });
    for (let step = 0; step < 240; step++) {
      advance(one, step);
      other.step(1 / 60);
    }
    expect(hashOf(one)).toBe(first);
  });
});

describe('the resolver', () => {
  it.each([severity, impact, substep])('[S21] is one word of a scene: it runs under %o', (make) => {
    const world = scene({ resolver: make() }, 60);
    const { count, alive, x, y } = world.particles;
    for (let i = 0; i < count; i++) if (alive[i] === 1) expect(x[i] > 0 && x[i] < 10 && y[i] > 0).toBe(true);
  });

  it.each([1, 2, 8, 64])('[S21] takes %s small steps a step', (subSteps) => {
    const world = new World({ gravity: { x: 0, y: -9.81 }, resolver: substep({ subSteps }) });
    world.addShape(new HalfPlane());
    const disc = world.addParticle({ x: 0, y: 0.5, radius: 0.1 });
    run(world, 120);
    expect(disc.y).toBeCloseTo(0.1, 3);
  });

  it('[S21] refuses what makes no sense', () => {
    for (const subSteps of [0, 65, 1.5, Number.NaN]) expect(() => substep({ subSteps })).toThrow('substep: subSteps');
    expect(() => substep({ sleepTime: 0 })).toThrow('substep: sleepTime');
    expect(() => substep({ sleepSpeed: -1 })).toThrow('substep: sleepSpeed');
    expect(() => substep(4 as never)).toThrow('substep: options');
  });
});

describe('a step that fails', () => {
  it.each([30, 120, 200])(
    '[S23] leaves no trace in contacts: the run goes on as if it had not been, after %s steps',
    (after) => {
      const honest = scene({}, 0, false);
      const tried = scene({}, 0, false);
      let fails = false;
      const broken: ForceGenerator = {
        steady: true,
        apply: ({ fx }, { slots }) => {
          if (fails) fx[slots[0]] = Number.NaN;
        },
      };
      for (const world of [honest, tried]) world.addForce(broken, [world.particleAt(0)]);
      for (let step = 0; step < 240; step++) {
        advance(honest, step);
        fails = step === after;
        if (fails) expect(() => tried.step(1 / 60)).toThrow('finite');
        fails = false;
        advance(tried, step);
      }
      expect(hashOf(tried)).toBe(hashOf(honest));
    },
  );
});

describe('contact events', () => {
  it('[S22] come once for each touch: a ball that hops begins and ends as often as it hops', () => {
    const world = new World({ gravity: { x: 0, y: -9.81 } });
    const floor = world.addShape(new HalfPlane({ restitution: 0.5 }));
    const ball = world.addParticle({ x: 0, y: 1.1, radius: 0.1, mass: 2 });
    const told: string[] = [];
    let impulse = 0;
    world.on('contactBegin', (event) => {
      told.push('begin');
      expect([event.a, event.b, event.source, event.normalX, event.normalY]).toEqual([ball, undefined, floor, 0, 1]);
      impulse ||= event.impulse;
    });
    world.on('contactEnd', () => told.push('end'));
    run(world, 48); // falls 0.45 s, hops 0.45 s: it has touched once
    expect(told).toEqual(['begin', 'end']);
    expect(impulse / (2 * 1.5 * Math.sqrt(2 * 9.81))).toBeCloseTo(1, 1);
    run(world, 400);
    expect(told.filter((word) => word === 'begin').length).toBe(told.filter((word) => word === 'end').length + 1);
  });

  it('[S22] a contact that goes on is told once, and one that is only expected is not', () => {
    const world = new World({ gravity: { x: 0, y: -9.81 } });
    world.addShape(new HalfPlane());
    world.addContactGenerator(new DiscContacts());
    world.addParticle({ x: 0, y: 0.25, radius: 0.25 });
    world.addParticle({ x: 0, y: 0.75, radius: 0.25 });
    const passing = world.addParticle({ x: -4, y: 1.4, vx: 20, vy: 1, radius: 0.1 });
    let begun = 0;
    world.on('contactBegin', (event) => {
      if (event.a === passing || event.b === passing) throw new Error('it passes by');
      begun++;
    });
    run(world, 15);
    expect(begun).toBe(2);
  });
});
