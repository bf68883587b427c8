import { requireNonNegative, requireOptions } from '../math/checks.ts';
import { checkedEnd, type End, particleOf, requireTwoEnds, slotOfEnd } from '../particles/end.ts';
import type { ParticleArrays } from '../particles/particle-arrays.ts';
import type { ForceGenerator } from './force-generator.ts';
import { Spring } from './spring.ts';
import { applySprings, lostParticle, type SpringKind, SpringTable } from './spring-table.ts';

/** What a spring or a bungee is made of. */
export interface SpringOptions {
  /** Tension for each metre of extension, 0 or more. Unit: N/m. */
  stiffness: number;
  /** Length at which it is without tension, 0 or more. Unit: m. @default the distance of the ends at the time */
  restLength?: number;
  /** Tension for each metre per second by which it grows longer, 0 or more. Unit: N·s/m. @default 0 */
  damping?: number;
}

/**
 * Springs, each between two particles or a particle and a fixed point: T = k·(length - rest length) + c·rate pulls each
 * end towards the other, or pushes it away where negative. It keeps its own particles: those named in `World.addForce` do
 * not matter. A spring goes with either of its particles. Ends at one point define no direction and feel no force.
 *
 * Forces make soft springs only: with the reduced mass μ of its ends, k·dt²/μ must stay below 4 and c·dt/μ below 2, or the
 * spring explodes (well below for a true period: 1 % too short at k·dt²/μ = 0.24). Something stiffer is a link.
 *
 * @example
 * ```ts
 * const springs = world.addForce(new Springs());
 * const coil = springs.add({ x: 0, y: 4 }, bob, { stiffness: 20, restLength: 1, damping: 0.5 });
 * coil.stiffness = 40;
 * ```
 */
export class Springs implements ForceGenerator, Iterable<Spring> {
  readonly #table: SpringTable;
  readonly #springs: Spring[] = [];
  #particles: ParticleArrays | undefined;
  #version = -1;

  constructor(kind: SpringKind = 'spring') {
    this.#table = new SpringTable(kind);
  }

  /** What they are, for drawing. */
  get kind(): SpringKind {
    return this.#table.kind;
  }

  /** How many there are. */
  get count(): number {
    let count = 0;
    for (const spring of this.#springs) if (spring.alive) count++;
    return count;
  }

  /** Each, in the order in which they were added; until the next step some may be gone: see `Spring.alive`. */
  get list(): readonly Spring[] {
    return this.#springs;
  }

  /** Each that is there, in the order in which they were added. */
  *[Symbol.iterator](): Generator<Spring, void, undefined> {
    for (const spring of [...this.#springs]) if (spring.alive) yield spring;
  }

  /**
   * Adds a spring.
   * @param a - A particle, or a fixed point `{ x, y }` in metres, which is copied.
   * @param b - The other end; at least one of the two is a particle.
   */
  add(a: End, b: End, options: SpringOptions): Spring {
    return this.insert(this.kind === 'spring' ? 'Springs.add' : 'Bungees.add', a, b, options, Spring);
  }

  /** @internal */
  insert<T extends Spring>(
    where: string,
    a: End,
    b: End,
    options: SpringOptions,
    Handle: new (table: SpringTable, row: number, a: End, b: End) => T,
  ): T {
    requireOptions(where, 'options', options, '{ stiffness: 20 }');
    const endA = checkedEnd(where, 'a', a);
    const endB = checkedEnd(where, 'b', b);
    requireTwoEnds(where, endA, endB);
    const dx = endB.x - endA.x;
    const dy = endB.y - endA.y;
    const { stiffness, restLength = Math.sqrt(dx * dx + dy * dy), damping = 0 } = options;
    requireNonNegative(where, 'stiffness', stiffness, 'newtons per metre');
    requireNonNegative(where, 'restLength', restLength, 'metres');
    requireNonNegative(where, 'damping', damping, 'newton-seconds per metre');

    const table = this.#table;
    const row = table.add();
    const fixed = particleOf(endA) ? endB : endA; // where neither is, it is written and not read
    table.fixedX[row] = fixed.x;
    table.fixedY[row] = fixed.y;
    table.restLength[row] = restLength;
    table.stiffness[row] = stiffness;
    table.damping[row] = damping;
    const spring = new Handle(table, row, endA, endB);
    this.#springs.push(spring);
    return spring;
  }

  /** Reads x, y, vx, vy. Adds to fx, fy. */
  apply(particles: ParticleArrays): void {
    const table = this.#table;
    if (table.dirty || this.#particles !== particles) this.#refresh(particles);
    else if (this.#version !== particles.version && lostParticle(table, particles)) this.#refresh(particles);
    this.#version = particles.version;
    applySprings(table, particles);
  }

  /** Drops what is gone, in order, and looks up the slots of the rest. */
  #refresh(particles: ParticleArrays): void {
    const table = this.#table;
    const springs = this.#springs;
    const { generation } = particles;
    let kept = 0;
    for (let s = 0; s < springs.length; s++) {
      const spring = springs[s];
      if (!spring.alive) continue;
      if (kept < s) {
        table.move(s, kept);
        spring.moveTo(kept);
        springs[kept] = spring;
      }
      const a = slotOfEnd('Springs', spring.a, particles);
      const b = slotOfEnd('Springs', spring.b, particles);
      table.slotA[kept] = a;
      table.slotB[kept] = b;
      table.generationA[kept] = generation[a]; // of a fixed point, at -1, it is written and not read
      table.generationB[kept++] = generation[b];
    }
    springs.length = table.count = kept;
    table.dirty = false;
    this.#particles = particles;
  }
}
