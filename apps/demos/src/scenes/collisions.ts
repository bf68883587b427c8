import { DiscContacts, type Particle, severity, World } from '@mass/core';
import type { Guide, Point, Readout } from './scene.ts';

/** How two discs are to collide: the first flies, the second is at rest. */
export interface Hit {
  /** Unit: kg. */
  readonly masses: readonly [number, number];
  /** Where they are when they touch. Unit: m. */
  readonly at: readonly [Point, Point];
  /** Unit: m. */
  readonly radii: readonly [number, number];
  /** Velocity of the first. Unit: m/s. */
  readonly v: Point;
  readonly restitution: number;
}

/** Where each of the two is and flies to, before and after. */
interface Way {
  readonly particle: Particle;
  readonly mass: number;
  readonly at: Point;
  readonly before: Point;
  readonly after: Point;
}

const step = 1 / 60;
/** From the start to the hit, in whole steps: so it is found just where it happens. */
const untilHit = 54;
/** From one mark to the next, in steps. */
const flash = 15;

/** Pairs of discs that collide all at one time, again and again, beside the closed form of the hit. */
export class Collisions {
  readonly world: World = new World({ resolver: severity() });
  readonly ways: readonly Way[];
  readonly #steps: number;
  readonly #rail: number;
  readonly #rings: Guide[] = [];
  #dots: Guide[] = [];
  #begun = 0;

  /**
   * `after` is how long the discs are followed after the hit, in s. The marks of the first lie by `rail` under the way, those
   * of the second over it, so that they are told apart where both go one way, in m.
   */
  constructor(hits: readonly Hit[], { after, rail = 0 }: { after: number; rail?: number }) {
    this.world.addContactGenerator(new DiscContacts());
    this.#rail = rail;
    this.#steps = untilHit + Math.round(after / step);
    this.ways = hits.flatMap((hit) => this.#add(hit));
    this.restart();
    for (let n = untilHit % flash; n <= this.#steps; n += flash) {
      this.#rings.push(...this.#marks(n, 0.11, false, (way) => placeAt(way, n)));
    }
  }

  /** A mark for each disc at a place; before the hit for the first alone, and only where it does not come back the same way. */
  #marks(n: number, radius: number, filled: boolean, place: (way: Way) => Point): Guide[] {
    const moving = this.ways.filter(({ particle }) => n > untilHit || (particle.group === 0 && this.#rail === 0));
    return moving.map((way) => {
      const { x, y } = place(way);
      const tone = way.particle.group;
      return { kind: 'circle', x, y: tone === 0 ? y - this.#rail : y + this.#rail, radius, filled, tone };
    });
  }

  /** v_a' = v_a + J n / m_a and v_b' = -J n / m_b, with J = -(1 + e) v_a·n / (1/m_a + 1/m_b). */
  #add({ masses, at, radii, v, restitution }: Hit): Way[] {
    const [a, b] = at;
    const distance = Math.hypot(a.x - b.x, a.y - b.y);
    const n = { x: (a.x - b.x) / distance, y: (a.y - b.y) / distance };
    const J = (-(1 + restitution) * (v.x * n.x + v.y * n.y)) / (1 / masses[0] + 1 / masses[1]);
    return [v, { x: 0, y: 0 }].map((before, which) => {
      const mass = masses[which];
      const change = (which === 0 ? J : -J) / mass;
      return {
        ...{ mass, at: at[which], before, after: { x: before.x + change * n.x, y: before.y + change * n.y } },
        particle: this.world.addParticle({ ...at[which], mass, radius: radii[which], restitution, group: which }),
      };
    });
  }

  restart(): void {
    this.#begun = this.world.stepCount;
    this.#dots = [];
    for (const way of this.ways) {
      Object.assign(way.particle, { ...placeAt(way, 0), vx: way.before.x, vy: way.before.y });
    }
  }

  /** To be called before each step: leaves the marks, and begins again. */
  beforeStep(): void {
    const n = this.world.stepCount - this.#begun;
    if (n % flash === untilHit % flash) this.#dots.push(...this.#marks(n, 0.07, true, ({ particle }) => particle));
    if (n > this.#steps + 10) this.restart();
  }

  /** The closed form as rings, a dot where a disc was at the time of its ring, and the centre of mass of each pair. */
  guides(): Guide[] {
    const centres: Guide[] = [];
    for (let n = 0; n < this.ways.length; n += 2) {
      const [a, b] = [this.ways[n], this.ways[n + 1]];
      const part = a.mass / (a.mass + b.mass);
      const x = part * a.particle.x + (1 - part) * b.particle.x;
      const y = part * a.particle.y + (1 - part) * b.particle.y;
      centres.push({ kind: 'circle', x, y, radius: 0.06, filled: true, tone: 'ink' });
    }
    return [...this.#rings, ...this.#dots, ...centres];
  }

  readouts(): Readout[] {
    let momentum = 0;
    let energy = 0;
    let start = 0;
    for (const {
      particle: { vx, vy },
      mass,
      before,
    } of this.ways) {
      momentum += mass * (before.x === 0 ? vy : vx);
      energy += (mass * (vx * vx + vy * vy)) / 2;
      start += (mass * (before.x * before.x + before.y * before.y)) / 2;
    }
    return [
      { label: 'Momentum', value: momentum, unit: 'kg·m/s' },
      { label: 'Kinetic energy', value: energy, unit: 'J' },
      { label: 'of', value: start, unit: 'J at the start' },
    ];
  }
}

/** Where a disc is after so many steps. */
function placeAt({ at, before, after }: Way, n: number): Point {
  const t = (n - untilHit) * step;
  const v = t < 0 ? before : after;
  return { x: at.x + v.x * t, y: at.y + v.y * t };
}
