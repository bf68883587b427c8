import {
  type Buoyancy,
  type ContactEvent,
  DiscContacts,
  type Fireworks,
  HalfPlane,
  type Particle,
  Random,
  severity,
  World,
} from '@mass/core';
import type { Point } from '../scene.ts';
import { BALL, BURST, DUST, SPLASH, WEIGHT } from './groups.ts';
import { airOf, type Level, levels, type Place } from './levels.ts';
import { addFork, type Foresight, foresee, Sling } from './sling.ts';
import { sparksOf } from './sparks.ts';

const GRAVITY = { x: 0, y: -9.81 };
export const HIT_POINTS = 100;
export const SPARED_POINTS = 50;
/** Density of a ball in water, as a share: it sinks, slowly. */
const BALL_DENSITY = 1300;
/** From a throw to the next ball; to the end of the last. Units: s. */
const RELOAD = 1.3;
const LAST = 5;
/** From a win to the next level. Unit: s. */
const PAUSE = 2.6;
/** The shortest pull that is a throw; a shorter one puts the ball back. Unit: m. */
const LEAST_PULL = 0.35;

/** What the game is waiting for: an aim, a new ball, or somebody to go on. */
export type Phase = 'aim' | 'flight' | 'won' | 'lost';

/** Points that were just made, and where. */
export interface Prize extends Point {
  readonly points: number;
  readonly time: number;
}

/** The rules: what counts, what comes next. It hands data to the world and hears of hits by events; it moves nothing itself. */
export class Play {
  readonly world: World = new World({ gravity: GRAVITY, resolver: severity({ iterations: 1000 }) });
  /** Points that were just made. */
  prizes: readonly Prize[] = [];
  readonly #mass: number;
  readonly #sparks: Fireworks;
  readonly #random: Random;
  readonly #first: number;
  #ground: HalfPlane = new HalfPlane();
  #sling: Sling;
  #foresight: Foresight;
  #place: Place = { targets: [] };
  #level = 0;
  #targets = new Set<Particle>();
  #dry: Particle[] = [];
  #phase: Phase = 'aim';
  #since = 0;
  #lastThrow = 0;
  #thrown = 0;
  #score = 0;
  /** Of the score, what this level gave. */
  #won = 0;
  #path: readonly number[] = [];
  #lastPath: readonly number[] = [];

  /** `first` is the level to begin with, from 0; mass is that of a ball. Unit: kg. */
  constructor(first: number, mass: number, seed: number) {
    this.#first = first;
    this.#mass = mass;
    this.#sparks = this.world.addEffect(sparksOf(seed));
    this.#random = new Random(seed);
    this.world.addContactGenerator(new DiscContacts());
    this.world.on('contactBegin', (event) => this.#touch(event));
    this.#sling = new Sling(this.world, mass, []);
    this.#foresight = { world: this.world, sling: this.#sling };
    this.restart();
  }

  get level(): Level {
    return levels[this.#level];
  }

  /** Which level it is, from 0. */
  get number(): number {
    return this.#level;
  }

  get phase(): Phase {
    return this.#phase;
  }

  /** Since the phase began. Unit: s. */
  get elapsed(): number {
    return this.world.time - this.#since;
  }

  get score(): number {
    return this.#score;
  }

  get throwsLeft(): number {
    return this.level.throws - this.#thrown;
  }

  get targets(): ReadonlySet<Particle> {
    return this.#targets;
  }

  /** How far the ball is pulled back. Unit: m. */
  get pull(): Point {
    return this.#sling.pull;
  }

  /** Whether the ball is pulled back far enough to be thrown. */
  get aimed(): boolean {
    const { x, y } = this.pull;
    return this.#phase === 'aim' && x * x + y * y >= LEAST_PULL * LEAST_PULL;
  }

  /** The first second of flight after this pull: x and y in turn. Empty without a pull. Unit: m. */
  get path(): readonly number[] {
    return this.#path;
  }

  /** The same of the throw before. */
  get lastPath(): readonly number[] {
    return this.#lastPath;
  }

  /** Whether a hand may drag it: not the ball that the bands hold, nor what only glitters. */
  takes(particle: Particle): boolean {
    return particle !== this.#sling.ball && particle.group < DUST;
  }

  /** From the first level, with no points. */
  restart(): void {
    this.#score = 0;
    this.#begin(this.#first);
  }

  /** The same level once more; points made in it are lost. */
  again(): void {
    this.#score -= this.#won;
    this.#begin(this.#level);
  }

  /** The next level; after the last the first. */
  next(): void {
    if (this.#level === levels.length - 1) this.#score = 0;
    this.#begin((this.#level + 1) % levels.length);
  }

  /** Pulls the ball back by a vector. Unit: m. */
  aim(x: number, y: number, dt: number): void {
    if (this.#phase !== 'aim') return;
    this.#sling.pullTo(x, y);
    this.#path = this.aimed ? this.#foresee(dt) : [];
  }

  /** Lets go; a ball that was hardly pulled goes back. */
  release(): void {
    if (!this.aimed) {
      if (this.#phase === 'aim') this.#sling.pullTo(0, 0);
      this.#path = [];
      return;
    }
    const ball = this.#sling.release();
    if (!ball) return;
    ball.lifetime = LAST + 1;
    const { water, liquid } = this.#place;
    if (water && liquid) {
      this.world.addForce(water, [ball]);
      liquid.setHull(ball, { volume: ball.mass / BALL_DENSITY, maxDepth: ball.radius });
    }
    this.#dry.push(ball);
    this.#lastPath = this.#path;
    this.#path = [];
    this.#thrown++;
    this.#lastThrow = this.world.time;
    this.#enter('flight');
  }

  /** Looks on, before each step. */
  tend(): void {
    const { time, stepCount } = this.world;
    this.#sling.tend();
    this.#splash();
    if (this.level.wind && stepCount % 8 === 0) this.#blow(this.level.wind);
    if (this.prizes.length > 0) this.prizes = this.prizes.filter((prize) => time - prize.time < 1.2);
    const sinceThrow = time - this.#lastThrow;
    if (this.#phase === 'flight' && this.throwsLeft > 0 && sinceThrow >= RELOAD && !this.#sling.ball) {
      this.#sling.load();
      this.#enter('aim');
    }
    if (this.#phase === 'flight' && this.throwsLeft === 0 && sinceThrow >= LAST) this.#enter('lost');
    if (this.#phase === 'won' && this.elapsed >= PAUSE && this.#level < levels.length - 1) this.next();
    if (this.#phase === 'won' && this.#level === levels.length - 1 && stepCount % 24 === 0) this.#celebrate();
  }

  #begin(level: number): void {
    const { world } = this;
    for (const force of [...world.forces]) world.removeForce(force);
    for (const shape of [...world.shapes]) world.removeShape(shape);
    const { alive, count } = world.particles;
    for (let slot = count - 1; slot >= 0; slot--) if (alive[slot] === 1) world.particleAt(slot).remove();
    this.#level = level;
    this.#won = 0;
    this.#thrown = 0;
    this.#dry = [];
    this.#path = [];
    this.#lastPath = [];
    this.prizes = [];
    this.#ground = world.addShape(new HalfPlane({ restitution: 0.2 }));
    addFork(world);
    this.#place = this.level.build(world);
    this.#targets = new Set(this.#place.targets);
    this.#sling = new Sling(world, this.#mass, airOf(this.level));
    this.#sling.load();
    const ahead = new World({ gravity: GRAVITY, resolver: severity({ iterations: 1000 }) });
    for (const shape of world.shapes) ahead.addShape(shape);
    this.#foresight = { world: ahead, sling: new Sling(ahead, this.#mass, airOf(this.level)) };
    this.#enter('aim');
  }

  #enter(phase: Phase): void {
    this.#phase = phase;
    this.#since = this.world.time;
  }

  #foresee(dt: number): number[] {
    const points = foresee(this.#foresight, this.pull, dt, 1);
    const { liquid } = this.#place;
    if (!liquid) return points;
    const wet = points.findIndex((y, n) => n % 2 === 1 && points[n - 1] > 7.6 && y < liquid.levelAt(points[n - 1]));
    return wet < 0 ? points : points.slice(0, wet - 1);
  }

  #touch({ a, b, source }: ContactEvent): void {
    if (this.level.hit === 'fall') {
      if (source === this.#ground) this.#hit(a);
    } else if (b && isHard(a)) {
      this.#hit(b);
    } else if (b && isHard(b)) {
      this.#hit(a);
    }
  }

  #hit(target: Particle): void {
    if (!this.#targets.delete(target)) return;
    const { x, y } = target;
    this.#score += HIT_POINTS;
    this.#won += HIT_POINTS;
    this.#award(x, y);
    this.#sparks.launch(BURST, { x, y, vx: target.vx * 0.3, vy: Math.max(0, target.vy * 0.3) });
    target.remove();
    if (this.#targets.size > 0) return;
    this.#score += SPARED_POINTS * this.throwsLeft;
    this.#won += SPARED_POINTS * this.throwsLeft;
    this.#path = [];
    this.#enter('won');
  }

  /** Points made at nearly the same time and place are one prize: they can be read. */
  #award(x: number, y: number): void {
    const { time } = this.world;
    const near = this.prizes.find((each) => time - each.time < 0.7 && Math.abs(each.x - x) < 3);
    const points = HIT_POINTS + (near?.points ?? 0);
    this.prizes = [...this.prizes.filter((each) => each !== near), { x: near?.x ?? x, y: near?.y ?? y, points, time }];
  }

  #splash(): void {
    const { liquid } = this.#place;
    if (!liquid || this.#dry.length === 0) return;
    this.#dry = this.#dry.filter((ball) => ball.alive && !this.#isWet(ball, liquid));
  }

  #isWet({ x, y, radius }: Particle, liquid: Buoyancy): boolean {
    if (x < 7.6 || x > 16.4 || y - radius > liquid.levelAt(x)) return false;
    this.#sparks.launch(SPLASH, { x, y: liquid.levelAt(x) + 0.05 });
    return true;
  }

  /** What the wind carries, so that it is seen. */
  #blow(wind: number): void {
    const y = this.#random.between(2.6, 11.5);
    this.world.addParticle({ x: 17.6, y, vx: wind, ay: -GRAVITY.y, mass: 0.01, lifetime: 2.9, group: DUST });
  }

  #celebrate(): void {
    this.#sparks.launch(BURST, { x: this.#random.between(1, 15), y: this.#random.between(5, 11) });
  }
}

function isHard({ alive, group }: Particle): boolean {
  return alive && (group === BALL || group === WEIGHT);
}
