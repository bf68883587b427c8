import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import { requireInteger, requireNonNegative, requireOptions, requirePositiveOrInfinite } from '../../math/checks.ts';
import type { Vec2 } from '../../math/vec2.ts';
import { allFinite } from '../../particles/finite.ts';
import type { ParticleStore } from '../../particles/particle-store.ts';
import { accelerate, accelerateConstantly, damp, move } from '../../world/integrators.ts';
import type { Simulation } from '../../world/simulation.ts';
import type { Resolver } from '../resolver.ts';
import { EnergyGuard } from './energy-guard.ts';
import { HeldForces } from './held-forces.ts';
import { LinkGroups } from './link-groups.ts';
import { Sleep } from './sleep.ts';

/** How the sub-step resolver works. */
export interface SubstepOptions {
  /** Into how many small steps a step is divided, 1 to 64. More are more exact, and cost more. @default 4 */
  subSteps?: number;
  /** What touches or hangs together sleeps once all of it has been slow for so long; `Infinity`: never. Unit: s. @default 0.5 */
  sleepTime?: number;
  /** Slower than this is slow. Unit: m/s. @default 0.03 */
  sleepSpeed?: number;
}

/**
 * The resolver for games: many contacts, friction, ropes, cloth, rest. Contacts are found once a step, ahead of time. Then come small
 * steps (M. Macklin et al.: Small Steps in Physics Simulation, 2019), in each of which forces act, links are kept by solvers of
 * their own, and contacts by one pass of soft constraints (E. Catto: Solver2D, 2024); a last pass takes out the speed by which
 * penetrations were undone. It is semi-implicit, whatever the world's integrator; where there is nothing to resolve, no links, shapes or
 * contact generators, a step is taken whole, by the integrator.
 */
export function substep(options: SubstepOptions = {}): Resolver {
  requireOptions('substep', 'options', options, '{ subSteps: 4 }');
  const { subSteps = 4, sleepTime = 0.5, sleepSpeed = 0.03 } = options;
  requireInteger('substep', 'subSteps', subSteps, 1, 64);
  requirePositiveOrInfinite('substep', 'sleepTime', sleepTime, 'seconds');
  requireNonNegative('substep', 'sleepSpeed', sleepSpeed, 'metres per second');
  return new SubstepResolver(() => new SmallSteps(subSteps, new Sleep(sleepTime, sleepSpeed)));
}

/** One value serves any number of worlds: what is kept from step to step is kept for each. */
class SubstepResolver implements Resolver {
  readonly name = 'substep';
  readonly #make: () => SmallSteps;
  readonly #worlds = new WeakMap<Simulation, SmallSteps>();
  /** The world that was asked for last. */
  #simulation: Simulation | undefined;
  #steps: SmallSteps | undefined;

  constructor(make: () => SmallSteps) {
    this.#make = make;
  }

  isAtRest(simulation: Simulation): boolean {
    return this.#of(simulation).isAtRest(simulation);
  }

  addLinkImpulses(simulation: Simulation, impulses: Float64Array): void {
    this.#of(simulation).addLinkImpulses(simulation, impulses);
  }

  step(simulation: Simulation, dt: number): boolean {
    if (simulation.sources.isEmpty) return flyFreely(simulation, dt);
    return this.#of(simulation).step(simulation, dt);
  }

  #of(simulation: Simulation): SmallSteps {
    if (this.#simulation === simulation && this.#steps !== undefined) return this.#steps;
    const steps = this.#worlds.get(simulation) ?? this.#make();
    this.#worlds.set(simulation, steps);
    this.#simulation = simulation;
    this.#steps = steps;
    return steps;
  }
}

/** The step of one world. */
class SmallSteps {
  readonly #subSteps: number;
  readonly #links = new LinkGroups();
  readonly #held = new HeldForces();
  readonly #guard = new EnergyGuard();
  readonly #sleep: Sleep;

  constructor(subSteps: number, sleep: Sleep) {
    this.#subSteps = subSteps;
    this.#sleep = sleep;
  }

  isAtRest({ particles }: Simulation): boolean {
    return this.#sleep.isAtRest(particles);
  }

  addLinkImpulses({ sources }: Simulation, impulses: Float64Array): void {
    this.#links.addImpulses(sources, impulses);
  }

  step(simulation: Simulation, dt: number): boolean {
    const { particles, forces, gravity, sources, contacts, time, before } = simulation;
    const h = dt / this.#subSteps;
    this.#sleep.spread(particles);
    contacts.clear(particles.count, sources.linkedPairs());
    const { keeper } = sources;
    do keeper?.find(simulation, dt);
    while (this.#sleep.wakeTouched(contacts, particles));
    this.#links.begin(sources, particles);
    keeper?.begin(simulation, dt, h, this.#links.bodies);
    this.#held.note(particles);
    this.#guard.begin(particles, sources.links.length > 0 || someBounce(contacts));
    for (let k = 0; k < this.#subSteps; k++) {
      if (k > 0) {
        this.#held.restore(particles);
        keeper?.findMore(simulation, dt - k * h);
      }
      forces.apply(h, time + k * h);
      accelerateAll(particles, gravity, h);
      this.#guard.before(particles);
      keeper?.repeat(simulation, k === 0);
      this.#links.solve(particles, h);
      keeper?.solve(simulation);
      if (!move(particles, h)) return false;
      this.#links.finish(particles);
      this.#guard.after(particles);
      if (contacts.count > 0) {
        this.#links.straighten(particles);
        keeper?.keepOut(simulation);
      }
    }
    this.#guard.before(particles);
    keeper?.relax(simulation);
    this.#guard.after(particles);
    this.#guard.settle(simulation);
    sources.keepInFront(before);
    this.#guard.keep(particles);
    keeper?.keep(simulation);
    this.#sleep.settle(simulation, dt);
    return allFinite(particles);
  }
}

/** Whether some contact may give back what it takes. */
function someBounce({ count, restitution }: ContactBuffer): boolean {
  for (let c = 0; c < count; c++) if (restitution[c] > 0) return true;
  return false;
}

/** A world without links, shapes and contact generators has nothing to resolve: one whole step, by the world's integrator. */
function flyFreely(
  { particles, forces, sources, contacts, integrate, gravity, time }: Simulation,
  dt: number,
): boolean {
  contacts.clear(particles.count, sources.linkedPairs());
  forces.apply(dt, time);
  return integrate(particles, gravity, dt);
}

/** v' = (v + a·h)·d^h. */
function accelerateAll(particles: ParticleStore, gravity: Readonly<Vec2>, h: number): void {
  if (particles.accelerated) accelerateConstantly(particles, h);
  accelerate(particles, gravity, h);
  if (particles.damped) damp(particles, h);
}
