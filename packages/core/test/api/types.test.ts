import {
  Drag,
  type Effect,
  explicitEuler,
  Fireworks,
  FixedTimestep,
  type ForceGenerator,
  type ForceTargets,
  forEachParticle,
  Gravity,
  type Integrator,
  type Particle,
  type ParticleArrays,
  type ParticleOptions,
  type ParticleSpawner,
  type Random,
  type SlotList,
  semiImplicitEuler,
  type Vec2,
  vec2,
  World,
  type WorldOptions,
} from '@mass/core';
import { expectTypeOf, it } from 'vitest';

it('[A2] the types of the world', () => {
  expectTypeOf(World).toBeConstructibleWith();
  expectTypeOf(World).toBeConstructibleWith({ gravity: { x: 0, y: -9.81 }, integrator: explicitEuler, capacity: 100 });
  expectTypeOf<World['addParticle']>().toEqualTypeOf<(options: ParticleOptions) => Particle>();
  expectTypeOf<World['step']>().toEqualTypeOf<(dt: number) => void>();
  expectTypeOf<World['particles']>().toEqualTypeOf<ParticleArrays>();
  expectTypeOf<World['gravity']>().toEqualTypeOf<Readonly<Vec2>>();
  expectTypeOf<World['particleAt']>().toEqualTypeOf<(slot: number) => Particle>();
  expectTypeOf<World['removeParticle']>().toEqualTypeOf<(particle: Particle) => void>();
  expectTypeOf<World>().toExtend<ParticleSpawner>();
  expectTypeOf<WorldOptions['integrator']>().toEqualTypeOf<Integrator | undefined>();
  expectTypeOf(semiImplicitEuler).toEqualTypeOf<Integrator>();
});

it('[A2] what is added comes back with its own type', () => {
  const world = new World();
  expectTypeOf(world.addForce(new Drag({ k1: 1 }))).toEqualTypeOf<Drag>();
  expectTypeOf(world.addForce(new Gravity({ x: 0, y: 1 }), new Set<Particle>())).toEqualTypeOf<Gravity>();
  const own = {
    strength: 5,
    apply({ fx }: ParticleArrays) {
      fx.fill(0);
    },
  };
  expectTypeOf(world.addForce(own).strength).toEqualTypeOf<number>();
  const still = { minVelocity: { x: 0, y: 0 }, maxVelocity: { x: 0, y: 0 }, damping: 1 };
  const fireworks = new Fireworks({ rules: [{ type: 1, minAge: 1, maxAge: 1, ...still }] });
  expectTypeOf(world.addEffect(fireworks)).toEqualTypeOf<Fireworks>();
});

it('[A2] the types of a particle', () => {
  type Numbers = 'x' | 'y' | 'vx' | 'vy' | 'ax' | 'ay' | 'mass' | 'damping' | 'radius' | 'lifetime' | 'group';
  expectTypeOf<Pick<Particle, Numbers>>().toEqualTypeOf<Record<Numbers, number>>();
  expectTypeOf<Pick<Particle, 'slot' | 'alive' | 'inverseMass'>>().toEqualTypeOf<{
    readonly slot: number;
    readonly alive: boolean;
    readonly inverseMass: number;
  }>();
  expectTypeOf<Particle['applyForce']>().toEqualTypeOf<(fx: number, fy: number) => void>();
  expectTypeOf<Particle['applyImpulse']>().toEqualTypeOf<(ix: number, iy: number) => void>();
  expectTypeOf<Particle['remove']>().toEqualTypeOf<() => void>();
  expectTypeOf<Pick<ParticleOptions, 'x' | 'y'>>().toEqualTypeOf<{ x: number; y: number }>();
});

it("[A2] the types of a game's own force and effect", () => {
  expectTypeOf<ForceGenerator['apply']>().parameter(0).toEqualTypeOf<ParticleArrays>();
  expectTypeOf<ForceGenerator['apply']>().parameter(1).toEqualTypeOf<ForceTargets>();
  expectTypeOf<ForceGenerator['apply']>().parameter(2).toEqualTypeOf<number>();
  expectTypeOf<ForceTargets>().toExtend<SlotList>();
  expectTypeOf<ForceTargets['particle']>().toEqualTypeOf<(index: number) => Particle>();
  expectTypeOf(forEachParticle).toEqualTypeOf<
    (updateForce: (particle: Particle, dt: number) => void) => ForceGenerator
  >();
  expectTypeOf<Effect['afterStep']>().toEqualTypeOf<(world: ParticleSpawner, expired: SlotList, dt: number) => void>();
});

it('[A2] the types of the rest', () => {
  expectTypeOf<FixedTimestep['advance']>().toEqualTypeOf<(elapsed: number, takeStep: (dt: number) => void) => number>();
  expectTypeOf<Random['next']>().toEqualTypeOf<() => number>();
  expectTypeOf(vec2.add).toEqualTypeOf<(a: Readonly<Vec2>, b: Readonly<Vec2>) => Vec2>();
});

/** Never called: each line is an error for the compiler, or the type check of this file fails. */
export function mistakes(world: World, particle: Particle): void {
  // @ts-expect-error the position is asked for
  world.addParticle({ x: 1 });
  // @ts-expect-error no such option
  world.addParticle({ x: 1, y: 2, weight: 3 });
  // @ts-expect-error a number, not a string
  world.addParticle({ x: 1, y: '2' });
  // @ts-expect-error left out, not undefined
  world.addParticle({ x: 1, y: 2, mass: undefined });
  // @ts-expect-error no such option
  new World({ gravitation: { x: 0, y: 1 } });
  // @ts-expect-error a value, not a name
  new World({ integrator: 'explicit' });
  // @ts-expect-error the duration is asked for
  world.step();
  // @ts-expect-error the coefficients are asked for
  new Drag();
  // @ts-expect-error no such coefficient
  new Drag({ k3: 1 });
  // @ts-expect-error the step is not an option of advance
  new FixedTimestep({ steps: 1 });
  // @ts-expect-error a list
  world.addForce(new Gravity({ x: 0, y: 1 }), particle);
  // @ts-expect-error an effect is no force
  world.addForce({ afterStep() {} });
  const velocities = { minVelocity: { x: 0, y: 0 }, maxVelocity: { x: 0, y: 0 } };
  // @ts-expect-error a damping is asked for
  new Fireworks({ rules: [{ type: 1, minAge: 1, maxAge: 1, ...velocities }] });
  // @ts-expect-error set the mass
  particle.inverseMass = 1;
  // @ts-expect-error a slot is given by the world
  particle.slot = 1;
  // @ts-expect-error whether it lives is for the world to say
  particle.alive = false;
  // @ts-expect-error write to the arrays, do not replace them
  world.particles.x = new Float64Array(1);
  // @ts-expect-error steps make the time
  world.time = 5;
  // @ts-expect-error a copy that is kept: set the whole
  world.gravity.y = 5;
}
