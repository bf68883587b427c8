import { aggregate, Bungees, type ForceGenerator, type Particle, type World } from '@mass/core';
import type { Point } from '../scene.ts';
import { BALL, SLING } from './groups.ts';

/** Where a ball rests before it is pulled back: halfway between the tips. Unit: m. */
export const FORK: Point = { x: 0, y: 2.7 };
export const BALL_RADIUS = 0.32;
/** Unit: m. */
const MOST_PULL = 2.3;
/** Of each of the two bands. Unit: N/m. */
const STIFFNESS = 20;
const tips = [
  { x: FORK.x - 0.45, y: FORK.y },
  { x: FORK.x + 0.45, y: FORK.y },
];

/** A slingshot: two rubber bands from the tips of a fork to a ball. What a pull does, the springs of the engine decide. */
export class Sling {
  readonly #world: World;
  readonly #mass: number;
  readonly #air: readonly ForceGenerator[];
  readonly #bands: Bungees;
  #ball: Particle | undefined;
  #pull: Point = { x: 0, y: 0 };
  #released = false;

  /** `air` is what acts on a ball from the moment that it is let go, besides gravity. */
  constructor(world: World, mass: number, air: readonly ForceGenerator[]) {
    this.#world = world;
    this.#mass = mass;
    this.#air = air;
    this.#bands = world.addForce(new Bungees());
  }

  /** The ball between the bands, from `load` until it flies free. */
  get ball(): Particle | undefined {
    return this.#ball;
  }

  /** How far the ball is pulled back. Unit: m. */
  get pull(): Point {
    return this.#pull;
  }

  /** Puts a new ball between the bands. It is held: pinned, until it is let go. */
  load(): void {
    this.#pull = { x: 0, y: 0 };
    this.#released = false;
    this.#ball = this.#world.addParticle({
      ...FORK,
      ...{ mass: Infinity, radius: BALL_RADIUS, restitution: 0.35, group: BALL },
    });
    for (const tip of tips) this.#bands.add(tip, this.#ball, { stiffness: STIFFNESS, restLength: 0 });
  }

  /** Pulls the ball back by a vector, no farther than the bands reach and not into the ground. Unit: m. */
  pullTo(x: number, y: number): void {
    if (!this.#ball || this.#released) return;
    const length = Math.sqrt(x * x + y * y);
    const share = length > MOST_PULL ? MOST_PULL / length : 1;
    this.#pull = { x: x * share, y: Math.max(BALL_RADIUS - FORK.y, y * share) };
    this.#ball.x = FORK.x + this.#pull.x;
    this.#ball.y = FORK.y + this.#pull.y;
  }

  /** Lets go: from here on the bands pull. Returns the ball. */
  release(): Particle | undefined {
    if (!this.#ball || this.#released) return undefined;
    this.#released = true;
    this.#ball.mass = this.#mass;
    for (const force of this.#air) this.#world.addForce(force, [this.#ball]);
    return this.#ball;
  }

  /** Frees the ball as soon as it has passed the fork. Called between steps; returns whether a ball flies free. */
  tend(): boolean {
    const ball = this.#ball;
    if (!ball || !this.#released) return this.#released;
    if ((ball.x - FORK.x) * this.#pull.x + (ball.y - FORK.y) * this.#pull.y > 0) return false;
    for (const band of this.#bands) band.remove();
    this.#ball = undefined;
    return true;
  }
}

/** The fork, as something to see: a body without size, which nothing touches. */
export function addFork(world: World): void {
  const outline = [-0.13, 0, 0.13, 0, 0.13, 1.7, 0.56, 2.3, 0.56, 2.8, 0.36, 2.8, 0.36, 2.4, 0, 1.92];
  const right = Array.from({ length: 8 }, (_, n) => ({ x: outline[2 * n], y: outline[2 * n + 1] }));
  const left = right.slice(2, 7).map(({ x, y }) => ({ x: -x, y }));
  world.addBody(
    aggregate({
      kind: 'fork',
      particles: [...right, ...left.reverse()].map((at) => ({ ...at, mass: Infinity, group: SLING })),
      links: [],
    }),
  );
}

/** A second world with the same sling and air: what happens there first happens here a moment later. */
export interface Foresight {
  readonly world: World;
  readonly sling: Sling;
}

/** The way of a ball after such a pull, from where it flies free: x and y in turn, until it touches something. Unit: m. */
export function foresee({ world, sling }: Foresight, pull: Point, dt: number, seconds: number): number[] {
  sling.load();
  sling.pullTo(pull.x, pull.y);
  const ball = sling.release();
  const points: number[] = [];
  const steps = Math.round(seconds / dt);
  for (let step = 0; ball && step < 4 * steps && points.length < 2 * steps; step++) {
    world.step(dt);
    if (world.contacts.count > 0) break;
    if (sling.tend()) points.push(ball.x, ball.y);
  }
  ball?.remove();
  return points;
}
