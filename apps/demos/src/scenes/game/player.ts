import type { Action, Point, Pointer } from '../scene.ts';
import type { Play } from './play.ts';
import { FORK } from './sling.ts';

/** How near the fork a pointer must come down to take the ball: as much as a finger needs on a phone. Unit: m. */
const REACH = 2;

/** A turn by some 1.9 degrees from + - * / alone: a scene gives the same bits everywhere. */
const T = 1 / 60;
const COS = (1 - T * T) / (1 + T * T);
const SIN = (2 * T) / (1 + T * T);

/** Where the keys begin to aim. Unit: m. */
const FIRST_PULL: Point = { x: -1.5, y: -0.9 };

/** Whoever plays: a hand, keys, or, until one of them comes, the game itself, which shows how it is done. */
export class Player implements Pointer {
  readonly actions: readonly Action[];
  readonly #play: Play;
  #plays = false;
  #held: Point = FORK;
  #pull: Point = FIRST_PULL;
  #dt = 1 / 60;

  constructor(play: Play) {
    this.#play = play;
    this.actions = [
      { key: 'ArrowLeft', label: 'Higher', run: () => this.#turn(COS, SIN) },
      { key: 'ArrowRight', label: 'Lower', run: () => this.#turn(COS, -SIN) },
      { key: 'ArrowUp', label: 'Stronger', run: () => this.#turn(1.05, 0) },
      { key: 'ArrowDown', label: 'Weaker', run: () => this.#turn(1 / 1.05, 0) },
      { key: 'Enter', label: 'Throw', run: () => this.#throw() },
      { key: 't', label: 'Try again', run: () => this.#take(() => play.again()) },
      { key: 'n', label: 'Next level', run: () => this.#take(() => play.next()) },
    ];
  }

  /** Whether somebody plays. */
  get plays(): boolean {
    return this.#plays;
  }

  down(at: Point): boolean {
    const dx = at.x - FORK.x;
    const dy = at.y - FORK.y;
    if (dx * dx + dy * dy > REACH * REACH) return false;
    this.#take();
    this.#held = at;
    return this.#play.phase === 'aim';
  }

  move(at: Point): void {
    this.#aim(at.x - this.#held.x, at.y - this.#held.y);
  }

  up(at: Point): void {
    this.move(at);
    this.#play.release();
  }

  /** A tap beside the ball: takes over, or goes on where the game waits for it. */
  goOn(): void {
    const { phase } = this.#play;
    const played = this.#plays;
    this.#take();
    if (!played) return;
    if (phase === 'won') this.#play.next();
    if (phase === 'lost') this.#play.again();
  }

  beforeStep(dt: number): void {
    this.#dt = dt;
    this.#play.tend();
    if (!this.#plays) this.#show();
  }

  /** The first key or touch ends the showing, and the game begins. */
  #take(work: () => void = () => {}): void {
    if (!this.#plays) this.#play.restart();
    this.#plays = true;
    work();
  }

  #aim(x: number, y: number): void {
    this.#play.aim(x, y, this.#dt);
    if (this.#play.aimed) this.#pull = this.#play.pull;
  }

  #turn(c: number, s: number): void {
    this.#take();
    const { aimed } = this.#play;
    const { x, y } = this.#pull;
    if (aimed) this.#aim(c * x - s * y, s * x + c * y);
    else this.#aim(x, y);
  }

  #throw(): void {
    this.#take();
    const { phase } = this.#play;
    if (phase === 'won' || phase === 'lost') {
      this.goOn();
      return;
    }
    if (!this.#play.aimed) this.#aim(this.#pull.x, this.#pull.y);
    this.#play.release();
  }

  /** Plays the throws of the level that win. */
  #show(): void {
    const play = this.#play;
    if (play.phase === 'lost' || (play.phase === 'won' && play.elapsed > 6)) play.restart();
    if (play.phase !== 'aim') return;
    const thrown = play.level.throws - play.throwsLeft;
    const { solution } = play.level;
    const { x, y, after: soon } = solution[thrown % solution.length];
    const after = thrown < solution.length ? soon : soon + 3; // what is falling may fall
    const share = Math.max(0, Math.min(1, (play.elapsed - after + 0.9) / 0.7));
    const eased = share * share * (3 - 2 * share);
    if (eased > 0) play.aim(x * eased, y * eased, this.#dt);
    if (play.elapsed >= after - this.#dt / 2) play.release();
  }
}
