import {
  Drag,
  explicitEuler,
  type FireworkRule,
  Fireworks,
  FixedTimestep,
  forEachParticle,
  Gravity,
  type Particle,
  Random,
  World,
} from '@mass/core';
import { describe, expect, it } from 'vitest';
import { failsUnchanged } from '../helpers.ts';

/** One entry point that takes a value: what it is called in the message, and which values it must refuse. */
interface Entry {
  /** Where, as the message begins. */
  readonly where: string;
  /** The name of the value, as the message has it. */
  readonly name: string;
  /** What else the message must have: what must hold, or the mend. */
  readonly says: string;
  readonly refuses: readonly unknown[];
  readonly act: (value: never, scene: Scene) => unknown;
}

interface Scene {
  readonly world: World;
  readonly particle: Particle;
  readonly fireworks: Fireworks;
  readonly clock: FixedTimestep;
}

const notNumbers = ['1', '', null, true, {}, [1], 1n, Symbol('s'), () => 1] as const;
const notFinite = [NaN, Infinity, -Infinity, ...notNumbers];
const missing = [undefined];
const notPositive = [0, -0, -1, -Infinity, NaN];
const massless = [...notPositive, 5e-324, ...notNumbers];
const noShare = [-0.001, 1.001, 99, ...notFinite];
const notNonNegative = [-1, -5e-324, ...notFinite];
const notGroup = [-1, 0.5, 65536, ...notFinite];
const notVector = [null, 5, 'up', true];
const finite = 'must be a finite number';

const still = { minVelocity: { x: 0, y: 0 }, maxVelocity: { x: 0, y: 0 }, damping: 1 };
const spark: FireworkRule = { type: 3, minAge: 1, maxAge: 2, ...still };
const rule = (change: object) => new Fireworks({ rules: [{ ...spark, ...change } as FireworkRule] });

function add(name: string): Entry['act'] {
  return (value: never, { world }: Scene) => world.addParticle({ x: 0, y: 0, [name]: value });
}

function set(name: keyof Particle): Entry['act'] {
  return (value: never, { particle }: Scene) => Object.assign(particle, { [name]: value });
}

const options = [
  { name: 'x', says: finite, refuses: [...notFinite, ...missing] },
  { name: 'y', says: finite, refuses: [...notFinite, ...missing] },
  { name: 'vx', says: `${finite} of metres per second`, refuses: notFinite },
  { name: 'vy', says: `${finite} of metres per second`, refuses: notFinite },
  { name: 'ax', says: `${finite} of metres per second squared`, refuses: notFinite },
  { name: 'ay', says: `${finite} of metres per second squared`, refuses: notFinite },
  { name: 'mass', says: 'Use Infinity to pin the particle.', refuses: massless },
  { name: 'damping', says: 'from 0 to 1', refuses: noShare },
  { name: 'radius', says: '0 or more', refuses: notNonNegative },
  { name: 'lifetime', says: 'must be a positive number of seconds', refuses: [...notPositive, ...notNumbers] },
  { name: 'group', says: 'must be a whole number from 0 to 65535', refuses: notGroup },
] as const;

const entries: Entry[] = [
  ...options.map((o) => ({ ...o, where: 'World.addParticle', act: add(o.name) })),
  ...options.map((o) => ({
    ...o,
    where: `Particle.${o.name}`,
    refuses: [...o.refuses, ...missing],
    act: set(o.name),
  })),
  ...(
    [
      ['applyForce', 'fx', (v: never, p: Particle) => p.applyForce(v, 0)],
      ['applyForce', 'fy', (v: never, p: Particle) => p.applyForce(0, v)],
      ['applyImpulse', 'ix', (v: never, p: Particle) => p.applyImpulse(v, 0)],
      ['applyImpulse', 'iy', (v: never, p: Particle) => p.applyImpulse(0, v)],
    ] as const
  ).map(([where, name, act]) => ({
    where: `Particle.${where}`,
    name,
    says: `${finite} of newton`,
    refuses: [...notFinite, ...missing],
    act: (value: never, { particle }: Scene) => act(value, particle),
  })),
  {
    where: 'World.addParticle',
    name: 'options',
    says: 'must be an object such as { x: 0, y: 0 }',
    refuses: [undefined, null, 5, 'x'],
    act: (value, { world }) => world.addParticle(value),
  },
  {
    where: 'World.spawn',
    name: 'x',
    says: finite,
    refuses: [...notFinite, ...missing],
    act: (value, { world }) => world.spawn(value, 0),
  },
  {
    where: 'World.spawn',
    name: 'y',
    says: finite,
    refuses: [...notFinite, ...missing],
    act: (value, { world }) => world.spawn(0, value),
  },
  {
    where: 'World.spawn',
    name: 'lifetime',
    says: 'must be a positive number of seconds',
    refuses: [...notPositive, ...notNumbers],
    act: (value, { world }) => world.spawn(0, 0, value),
  },
  {
    where: 'World.step',
    name: 'dt',
    says: '0 or more; got',
    refuses: [...notNonNegative, ...missing],
    act: (value, { world }) => world.step(value),
  },
  {
    where: 'World.step',
    name: 'dt',
    says: 'Time runs forward only.',
    refuses: [-1 / 60],
    act: (value, { world }) => world.step(value),
  },
  {
    where: 'World.gravity',
    name: 'gravity',
    says: 'must be { x, y }, in metres per second squared',
    refuses: [...notVector, ...missing],
    act: (value, { world }) => (world.gravity = value),
  },
  {
    where: 'World.gravity',
    name: 'gravity.y',
    says: finite,
    refuses: [...notFinite, ...missing],
    act: (value, { world }) => (world.gravity = { x: 0, y: value }),
  },
  {
    where: 'World',
    name: 'gravity',
    says: 'must be { x, y }',
    refuses: notVector,
    act: (value) => new World({ gravity: value }),
  },
  {
    where: 'World',
    name: 'gravity.x',
    says: finite,
    refuses: [...notFinite, ...missing],
    act: (value) => new World({ gravity: { x: value, y: 0 } }),
  },
  {
    where: 'World',
    name: 'capacity',
    says: 'must be a whole number from 0 to',
    refuses: [-1, 0.5, 1e12, ...notFinite],
    act: (value) => new World({ capacity: value }),
  },
  {
    where: 'World',
    name: 'integrator',
    says: 'such as semiImplicitEuler',
    refuses: [null, 5, 'explicitEuler', {}],
    act: (value) => new World({ integrator: value }),
  },
  {
    where: 'World',
    name: 'options',
    says: 'must be an object such as',
    refuses: [null, 5, 'x'],
    act: (value) => new World(value),
  },
  {
    where: 'World.removeParticle',
    name: 'a particle',
    says: 'must be what World.addParticle returned',
    refuses: [undefined, null, 0, 'x', {}, { slot: 0, alive: true }],
    act: (value, { world }) => world.removeParticle(value),
  },
  {
    where: 'World.addForce',
    name: 'a force generator',
    says: 'Wrap a function of one particle in forEachParticle.',
    refuses: [undefined, null, 5, 'gravity', {}, () => {}, { apply: 5 }, Gravity],
    act: (value, { world }) => world.addForce(value),
  },
  {
    where: 'World.addForce',
    name: 'particles',
    says: 'Put it in [ ].',
    refuses: [null, 5, {}, true, (): void => {}],
    act: (value, { world }) => world.addForce(new Gravity({ x: 0, y: 1 }), value),
  },
  {
    where: 'World.addForce',
    name: 'a particle',
    says: 'must be what World.addParticle returned',
    refuses: [undefined, null, 0, {}],
    act: (value, { world, particle }) => world.addForce(new Gravity({ x: 0, y: 1 }), [particle, value]),
  },
  {
    where: 'World.addEffect',
    name: 'an effect',
    says: 'must have a method afterStep(world, expired, dt)',
    refuses: [undefined, null, 5, 'x', {}],
    act: (value, { world }) => world.addEffect(value),
  },
  {
    where: 'Gravity',
    name: 'g',
    says: 'must be { x, y }, in metres per second squared',
    refuses: [...notVector, ...missing],
    act: (value) => new Gravity(value),
  },
  {
    where: 'Gravity',
    name: 'g.x',
    says: finite,
    refuses: [...notFinite, ...missing],
    act: (value) => new Gravity({ x: value, y: 0 }),
  },
  { where: 'Drag', name: 'k1', says: '0 or more', refuses: notNonNegative, act: (value) => new Drag({ k1: value }) },
  { where: 'Drag', name: 'k2', says: '0 or more', refuses: notNonNegative, act: (value) => new Drag({ k2: value }) },
  {
    where: 'Drag',
    name: 'options',
    says: 'must be an object such as { k1: 0.1 }',
    refuses: [undefined, null, 0.1],
    act: (value) => new Drag(value),
  },
  {
    where: 'forEachParticle',
    name: 'updateForce',
    says: 'must be a function of a particle and the duration of the step',
    refuses: [undefined, null, 5, 'f', {}],
    act: (value) => forEachParticle(value),
  },
  {
    where: 'FixedTimestep',
    name: 'step',
    says: 'must be a positive, finite number of seconds',
    refuses: [...notPositive, Infinity, ...notNumbers],
    act: (value) => new FixedTimestep({ step: value }),
  },
  {
    where: 'FixedTimestep',
    name: 'maxSteps',
    says: 'must be a whole number from 1 to 1000',
    refuses: [0, 1.5, 1001, ...notFinite],
    act: (value) => new FixedTimestep({ maxSteps: value }),
  },
  {
    where: 'FixedTimestep',
    name: 'options',
    says: 'must be an object such as',
    refuses: [null, 60, '60'],
    act: (value) => new FixedTimestep(value),
  },
  {
    where: 'FixedTimestep.advance',
    name: 'elapsed',
    says: 'Pass the time since the last call.',
    refuses: [...notNonNegative, ...missing],
    act: (value, { clock }) => clock.advance(value, () => {}),
  },
  {
    where: 'FixedTimestep.advance',
    name: 'takeStep',
    says: 'must be a function such as (dt) => world.step(dt)',
    refuses: [undefined, null, 5, {}],
    act: (value, { clock }) => clock.advance(1, value),
  },
  {
    where: 'Random',
    name: 'seed',
    says: 'must be a whole number from 0 to 4294967295',
    refuses: [-1, 0.5, 2 ** 32, ...notFinite],
    act: (value) => new Random(value),
  },
  {
    where: 'Random.between',
    name: 'min',
    says: finite,
    refuses: [...notFinite, ...missing],
    act: (value) => new Random().between(value, 1),
  },
  {
    where: 'Random.between',
    name: 'max',
    says: finite,
    refuses: [...notFinite, ...missing],
    act: (value) => new Random().between(0, value),
  },
  {
    where: 'Random.integer',
    name: 'min',
    says: 'must be a whole number',
    refuses: [0.5, 2 ** 40, ...notFinite],
    act: (value) => new Random().integer(value, 1),
  },
  {
    where: 'Random.integer',
    name: 'max',
    says: 'must be a whole number from 0 to',
    refuses: [-1, 0.5, ...notFinite],
    act: (value) => new Random().integer(0, value),
  },
  {
    where: 'Fireworks',
    name: 'options',
    says: 'must be an object such as',
    refuses: [undefined, null, 5],
    act: (value) => new Fireworks(value),
  },
  {
    where: 'Fireworks',
    name: 'rules',
    says: 'must be a list of at least one rule',
    refuses: [undefined, null, 5, {}, []],
    act: (value) => new Fireworks({ rules: value }),
  },
  {
    where: 'Fireworks',
    name: 'a rule',
    says: 'must be an object such as',
    refuses: [undefined, null, 5],
    act: (value) => new Fireworks({ rules: [value] }),
  },
  {
    where: 'Random',
    name: 'seed',
    says: 'must be a whole number',
    refuses: [-1, 0.5, ...notFinite],
    act: (value) => new Fireworks({ rules: [spark], seed: value }),
  },
  {
    where: 'Fireworks',
    name: 'ground',
    says: 'must be an object such as',
    refuses: [null, 5],
    act: (value) => new Fireworks({ rules: [spark], ground: value }),
  },
  {
    where: 'Fireworks',
    name: 'ground.maxX',
    says: finite,
    refuses: [...notFinite, ...missing],
    act: (value) => new Fireworks({ rules: [spark], ground: { minX: 0, maxX: value, y: 0 } }),
  },
  {
    where: 'Fireworks',
    name: 'the greatest ground x',
    says: 'Swap them.',
    refuses: [-1],
    act: (value) => new Fireworks({ rules: [spark], ground: { minX: 0, maxX: value, y: 0 } }),
  },
  {
    where: 'Fireworks',
    name: 'type',
    says: 'must be a whole number from 1 to 65535',
    refuses: [0, -1, 1.5, 65536, ...notFinite, ...missing],
    act: (value) => rule({ type: value }),
  },
  ...(
    [
      ['minAge', 'positive, finite', [...notPositive, Infinity, ...notNumbers, ...missing]],
      ['maxAge', 'positive, finite', [...notPositive, Infinity, ...notNumbers, ...missing]],
      ['minVelocity', 'must be { x, y }', [...notVector, ...missing]],
      ['maxVelocity', 'must be { x, y }', [...notVector, ...missing]],
      ['damping', 'from 0 to 1', [...noShare, ...missing]],
      ['acceleration', 'must be { x, y }', notVector],
      ['mass', 'Use Infinity to pin the particle.', massless],
      ['radius', '0 or more', notNonNegative],
      ['payloads', 'must be a list such as [{ type: 2, count: 20 }]', [null, 5, {}]],
    ] as const
  ).map(([name, says, refuses]) => ({
    where: 'Fireworks, rule of type 3',
    name,
    says,
    refuses,
    act: (value: never) => rule({ [name]: value }),
  })),
  {
    where: 'Fireworks, rule of type 3',
    name: 'the greatest age',
    says: 'must be at least the smallest, 1 s',
    refuses: [0.5],
    act: (value) => rule({ maxAge: value }),
  },
  {
    where: 'Fireworks, rule of type 3',
    name: 'the greatest velocity.y',
    says: 'must be at least the smallest, 0 m/s',
    refuses: [-1],
    act: (value) => rule({ maxVelocity: { x: 0, y: value } }),
  },
  {
    where: 'Fireworks, rule of type 3',
    name: 'count of a payload',
    says: 'must be a whole number from 1 to 1000000',
    refuses: [0, -1, 1.5, 1e7, ...notFinite, ...missing],
    act: (value) => rule({ payloads: [{ type: 3, count: value }] }),
  },
  {
    where: 'Fireworks.launch',
    name: 'at',
    says: 'must be { x, y }, in metres',
    refuses: notVector,
    act: (value, { fireworks }) => fireworks.launch(3, value),
  },
  ...(['x', 'y', 'vx', 'vy'] as const).map((name) => ({
    where: 'Fireworks.launch',
    name: `at.${name}`,
    says: finite,
    refuses: notFinite,
    act: (value: never, { fireworks }: Scene) => fireworks.launch(3, { x: 0, y: 0, [name]: value }),
  })),
];

/** How a message shows a value. */
function shown(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value);
  if (typeof value === 'function') return `function ${value.name}`;
  if (Array.isArray(value)) return 'an array';
  if (typeof value === 'object' && value !== null) return 'Object';
  return String(value);
}

function scene(): Scene {
  const world = new World({ gravity: { x: 0, y: -10 } });
  const particle = world.addParticle({ x: 1, y: 2, vx: 3, vy: 4, ax: 5, damping: 0.5, lifetime: 8 });
  world.addParticle({ x: 9, y: 9 }).remove();
  world.addForce(new Drag({ k1: 1 }), [particle]);
  const fireworks = world.addEffect(new Fireworks({ rules: [spark] }));
  fireworks.launch(3);
  world.step(0.1);
  particle.applyForce(6, 7);
  const clock = new FixedTimestep();
  clock.advance(0.01, () => {});
  return { world, particle, fireworks, clock };
}

describe('bad input', () => {
  it.each(entries)('[X1] $where refuses a bad $name', ({ where, name, says, refuses, act }) => {
    const stage = scene();
    const alpha = stage.clock.alpha;
    // A bad number is a RangeError; a thing that is no number, or a number in the place of a thing, is a TypeError.
    const takesNumber = refuses.includes(NaN) || refuses.every((value) => typeof value === 'number');
    for (const value of refuses) {
      const error = failsUnchanged(stage.world, () => act(value as never, stage));
      const { message } = error;
      expect(error).toBeInstanceOf(typeof value === 'number' && takesNumber ? RangeError : TypeError);
      expect(message.startsWith(`${where}: ${name} `)).toBe(true);
      expect(message).toContain(says);
      expect(message).toContain(`got ${shown(value)}.`);
      expect(stage.clock.alpha).toBe(alpha);
    }
  });

  it('[X1] after all of it the world goes on as if nothing had happened', () => {
    const [tried, plain] = [scene(), scene()];
    for (const { refuses, act } of entries) {
      for (const value of refuses) failsUnchanged(tried.world, () => act(value as never, tried));
    }
    for (const { world, fireworks } of [tried, plain]) {
      for (let i = 0; i < 20; i++) {
        fireworks.launch(3);
        world.step(0.1);
      }
    }
    expect(failsUnchanged(tried.world, () => tried.world.step(-1)).message).toContain('got -1.');
    expect(Array.from(tried.world.particles.x)).toEqual(Array.from(plain.world.particles.x));
    expect(Array.from(tried.world.particles.y)).toEqual(Array.from(plain.world.particles.y));
  });

  it('[X2] the limits themselves are welcome', () => {
    const { world, particle, clock } = scene();
    world.addParticle({ x: -0, y: 1e300, mass: Infinity, damping: 0, radius: 0, lifetime: 5e-324, group: 65535 });
    world.addParticle({ x: 0, y: 0, mass: 1e-300, damping: 1 });
    particle.damping = 0;
    particle.damping = 1;
    particle.lifetime = Infinity;
    world.step(0);
    world.step(5e-324);
    expect(clock.advance(0, () => {})).toBe(0);
    new Drag({});
    new Drag({ k1: 0, k2: 0 });
    new Random(0);
    new Random(0xffffffff);
    new World({ capacity: 0, integrator: explicitEuler }).addParticle({ x: 0, y: 0 });
  });

  it('[X3] the same effect twice is an error, and an effect or force that is not there cannot be taken out', () => {
    const { world, fireworks } = scene();
    expect(failsUnchanged(world, () => world.addEffect(fireworks)).message).toMatch(
      /^World\.addEffect: .* in the world already/,
    );
    world.removeEffect(fireworks);
    expect(failsUnchanged(world, () => world.removeEffect(fireworks)).message).toMatch(
      /^World\.removeEffect: .* is not\.$/,
    );
    expect(failsUnchanged(world, () => world.removeForce(new Drag({}))).message).toMatch(
      /^World\.removeForce: .* is not\.$/,
    );
  });
});
