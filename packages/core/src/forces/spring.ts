import { requireNonNegative } from '../math/checks.ts';
import { type End, isEndAlive, particleOf } from '../particles/end.ts';
import { type SpringKind, type SpringTable, tension } from './spring-table.ts';

/**
 * One spring or bungee of a batch: made by `Springs.add`, `Bungees.add`, `spring` or `bungee`. It goes with either of its
 * particles; using one that is gone is an error, `alive` tells.
 */
export class Spring {
  /** The end that it was given first: a particle, or a fixed point. */
  readonly a: End;
  /** The end that it was given second: a particle, or a fixed point. */
  readonly b: End;
  readonly #table: SpringTable;
  #row: number;
  #removed = false;

  /** @internal */
  constructor(table: SpringTable, row: number, a: End, b: End) {
    this.#table = table;
    this.#row = row;
    this.a = a;
    this.b = b;
  }

  /** What it is, for drawing: a spring has coils and pushes too, a bungee is a cord that only pulls. */
  get kind(): SpringKind {
    return this.#table.kind;
  }

  /** Whether it is still there: neither removed nor without one of its particles. */
  get alive(): boolean {
    return !this.#removed && isEndAlive(this.a) && isEndAlive(this.b);
  }

  /** Length at which it is without tension, 0 or more. Unit: m. */
  get restLength(): number {
    return this.#of('restLength').restLength[this.#row];
  }
  set restLength(value: number) {
    requireNonNegative('Spring.restLength', 'restLength', value, 'metres');
    this.#of('restLength').restLength[this.#row] = value;
  }

  /** Tension for each metre of extension, 0 or more. Unit: N/m. */
  get stiffness(): number {
    return this.#of('stiffness').stiffness[this.#row];
  }
  set stiffness(value: number) {
    requireNonNegative('Spring.stiffness', 'stiffness', value, 'newtons per metre');
    this.#of('stiffness').stiffness[this.#row] = value;
  }

  /** Tension for each metre per second by which it grows longer, 0 or more. Unit: N·s/m. */
  get damping(): number {
    return this.#of('damping').damping[this.#row];
  }
  set damping(value: number) {
    requireNonNegative('Spring.damping', 'damping', value, 'newton-seconds per metre');
    this.#of('damping').damping[this.#row] = value;
  }

  /** Distance of the ends now. Unit: m. */
  get length(): number {
    this.#of('length');
    const dx = this.b.x - this.a.x;
    const dy = this.b.y - this.a.y;
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** How much longer than at rest it is; negative when shorter. Unit: m. */
  get extension(): number {
    return this.length - this.restLength;
  }

  /** Tension now: positive where it pulls the ends together, negative where it pushes them apart. Unit: N. */
  get force(): number {
    const length = this.length;
    if (length === 0) return 0;
    const a = particleOf(this.a);
    const b = particleOf(this.b);
    const ux = (b ? b.vx : 0) - (a ? a.vx : 0);
    const uy = (b ? b.vy : 0) - (a ? a.vy : 0);
    const rate = ((this.b.x - this.a.x) * ux + (this.b.y - this.a.y) * uy) / length;
    return tension(this.kind, this.stiffness, this.damping, length - this.restLength, rate);
  }

  /** Energy stored now, k·extension²/2; none in a slack bungee. Unit: J. */
  get energy(): number {
    const extension = this.kind === 'bungee' ? Math.max(0, this.extension) : this.extension;
    return (this.stiffness * extension * extension) / 2;
  }

  /** Takes it away; its ends stay. */
  remove(): void {
    this.#of('remove').dirty = true;
    this.#removed = true;
  }

  /** @internal */
  moveTo(row: number): void {
    this.#row = row;
  }

  #of(member: string): SpringTable {
    if (!this.alive) {
      const why = this.#removed ? 'it was removed' : 'one of its particles was removed';
      throw new Error(`Spring.${member}: the ${this.kind} must still be there; ${why}. Ask alive before using it.`);
    }
    return this.#table;
  }
}
