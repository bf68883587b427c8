import type { Contacts } from '../contacts/contacts.ts';
import { requireNonNegative, requireOrdered, requirePositiveOrInfinite, requireShare } from '../math/checks.ts';
import { checkedEnds, type End, isEndAlive, particleOf } from '../particles/end.ts';
import { Particle } from '../particles/particle.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { LimitedLink } from './limited-link.ts';
import type { LinkSolver } from './link.ts';
import { linkKeeper } from './link-keeper.ts';

/** When a link gives way. */
export interface BreakingOptions {
  /** Breaks when it has to hold more. Unit: N. @default Infinity */
  breakForce?: number;
  /** Breaks when it is off its length by more than this share of it, after a step. @default Infinity */
  breakStrain?: number;
}

/** How a link gives. */
export interface GivingOptions extends BreakingOptions {
  /** How far it gives for each newton that it has to hold. The sub-step resolver alone heeds it. Unit: m/N. @default 0 */
  compliance?: number;
  /**
   * How much it calms what swings on it, 0 to 1: 0 keeps the energy, 1 takes out some ω²·h/2 of it a second, for a swing at
   * ω rad/s and small steps of h seconds. The sub-step resolver alone heeds it. @default 0
   */
  damping?: number;
}

/** What a distance link keeps. */
export interface DistanceLinkOptions extends GivingOptions {
  /** What it is, for drawing. */
  kind: string;
  /** Smallest distance of the ends. Unit: m. */
  minLength: number;
  /** Greatest distance of the ends. Unit: m. */
  maxLength: number;
  /** Share of the closing speed given back at either limit, 0 to 1. @default 0 */
  restitution?: number;
}

/** A link that keeps the distance of its two ends between a least and a greatest: see `rod` and `cable`. */
export class DistanceLink implements LimitedLink {
  /** What keeps it in the sub-step resolver. */
  readonly solver: () => LinkSolver = linkKeeper;
  readonly a: End;
  readonly b: End;
  /** What it is, for drawing: 'rod', 'cable', or a game's own word. */
  readonly kind: string;
  /** Share of the closing speed given back at either limit, 0 to 1. */
  readonly restitution: number;
  /** How far it gives for each newton that it has to hold. Unit: m/N. */
  readonly compliance: number;
  /** How much it calms what swings on it, 0 to 1. */
  readonly damping: number;
  /** Breaks when it has to hold more. Unit: N. */
  readonly breakForce: number;
  /** Breaks when it is off its length by more than this share of it. */
  readonly breakStrain: number;
  /** Whether it breaks at a force, in newtons; a link without limits has no such function. */
  readonly breaksAt?: (force: number) => boolean;
  #minLength: number;
  #maxLength: number;
  #isChanged = false;
  /** Slots of the particles; the second is -1 for a fixed point. */
  readonly #i: number;
  readonly #j: number;
  readonly #pointX: number;
  readonly #pointY: number;

  constructor(where: string, a: End, b: End, options: DistanceLinkOptions) {
    const { kind, minLength, maxLength, restitution = 0, compliance = 0, damping = 0 } = options;
    const { breakForce = Infinity, breakStrain = Infinity } = options;
    [this.a, this.b] = checkedEnds(where, a, b);
    const [first, second] = this.a instanceof Particle ? [this.a, this.b] : [this.b as Particle, this.a];
    this.#i = first.slot;
    this.#j = particleOf(second)?.slot ?? -1;
    this.#pointX = second.x;
    this.#pointY = second.y;
    requireNonNegative(where, 'minLength', minLength, 'metres');
    requirePositiveOrInfinite(where, 'maxLength', maxLength, 'metres');
    requireOrdered(where, 'length', minLength, maxLength, 'm');
    requireShare(where, 'restitution', restitution);
    requireNonNegative(where, 'compliance', compliance, 'metres per newton');
    requireShare(where, 'damping', damping);
    requirePositiveOrInfinite(where, 'breakForce', breakForce, 'newtons');
    requirePositiveOrInfinite(where, 'breakStrain', breakStrain, '');
    this.kind = kind;
    this.#minLength = minLength;
    this.#maxLength = maxLength;
    this.restitution = restitution;
    this.compliance = compliance;
    this.damping = damping;
    this.breakForce = breakForce;
    this.breakStrain = breakStrain;
    if (breakForce === Infinity && breakStrain === Infinity) return;
    this.breaksAt = (force) => force > breakForce || (breakStrain < Infinity && Math.abs(this.strain) > breakStrain);
  }

  /** Smallest distance of the ends. Unit: m. */
  get minLength(): number {
    return this.#minLength;
  }

  /** Greatest distance of the ends. Unit: m. */
  get maxLength(): number {
    return this.#maxLength;
  }

  /** Winds the link in or out. Unit: m. */
  setLength(minLength: number, maxLength: number): void {
    requireNonNegative('DistanceLink.setLength', 'minLength', minLength, 'metres');
    requirePositiveOrInfinite('DistanceLink.setLength', 'maxLength', maxLength, 'metres');
    requireOrdered('DistanceLink.setLength', 'length', minLength, maxLength, 'm');
    this.#minLength = minLength;
    this.#maxLength = maxLength;
    this.#isChanged = true;
    for (const end of [this.a, this.b]) if (isEndAlive(end)) particleOf(end)?.wake();
  }

  /** Distance of the ends now. Unit: m. */
  get length(): number {
    const dx = this.b.x - this.a.x;
    const dy = this.b.y - this.a.y;
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** How far the length is off its limits, as a share: positive when too long, negative when too short, else 0. */
  get strain(): number {
    const length = this.length;
    if (length > this.#maxLength) return length / this.#maxLength - 1;
    if (length < this.#minLength) return length / this.#minLength - 1;
    return 0;
  }

  /** Whether its length was changed since this was last asked: then it may do work. */
  takeChange(): boolean {
    const isChanged = this.#isChanged;
    this.#isChanged = false;
    return isChanged;
  }

  /** What it has stored by giving way, with its ends at given places. Unit: J. */
  energyAt(x: Float64Array, y: Float64Array): number {
    if (this.compliance === 0) return 0;
    const i = this.#i;
    const j = this.#j;
    const dx = (j < 0 ? this.#pointX : x[j]) - x[i];
    const dy = (j < 0 ? this.#pointY : y[j]) - y[i];
    const length = Math.sqrt(dx * dx + dy * dy);
    const over = length - Math.max(this.#minLength, Math.min(this.#maxLength, length));
    return (over * over) / (2 * this.compliance);
  }

  /**
   * A contact that pulls the ends together at the greatest distance, and one that holds them apart at the smallest. A rod
   * offers both each time, so that it holds its length from both sides and does not vibrate.
   */
  addContacts({ x, y }: ParticleArrays, contacts: Contacts): void {
    const i = this.#i;
    const j = this.#j;
    const dx = (j < 0 ? this.#pointX : x[j]) - x[i];
    const dy = (j < 0 ? this.#pointY : y[j]) - y[i];
    const length = Math.sqrt(dx * dx + dy * dy);
    const nx = length === 0 ? 0 : dx / length; // coincident ends define no direction: any will do
    const ny = length === 0 ? 1 : dy / length;
    const both = this.#minLength === this.#maxLength;
    for (let side = 1; side >= -1; side -= 2) {
      const over = side > 0 ? length - this.#maxLength : this.#minLength - length;
      if (over >= 0 || both) contacts.add(i, j, side * nx, side * ny, over, this.restitution);
    }
  }
}

/** The distance of two ends as they are now. Unit: m. */
export function distanceNow(a: End, b: End): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  return Math.sqrt(dx * dx + dy * dy);
}
