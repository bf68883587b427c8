import type { Link } from '../links/link.ts';
import { requireFinite, requireInteger } from '../math/checks.ts';
import type { Particle } from '../particles/particle.ts';
import type { BodyParts, BodySite } from './body-parts.ts';
import { angularVelocityOf, inertiaOf, kineticEnergyOf, massOf, meanOf, rotationOf, spread } from './rigid-motion.ts';

/** Where a body is and how it is turned: for drawing. */
export interface Pose {
  /** Centre of mass. Unit: m. */
  x: number;
  y: number;
  /** Orientation, counter-clockwise. Unit: rad, -π to π. */
  angle: number;
}

/**
 * An aggregate: particles that links hold together, seen as one thing. It is a view: all that it tells is found from its
 * particles at the time, all that it is told goes to them, and the step knows nothing of it. Made by `World.addBody`.
 *
 * It lives as long as one of its particles does. Particles that were removed, and the links that went with them or broke, are
 * no longer of the body: mass, centre and all else are those of what is left.
 */
export class Body {
  /** What it is, for drawing: 'box', 'chain', or a game's own word. */
  readonly kind: string;
  /** Whether the outline is a ring to be filled, or a line. */
  readonly closed: boolean;
  readonly #site: BodySite;
  readonly #members: readonly Particle[];
  readonly #links: readonly Link[];
  readonly #shape: { readonly x: Float64Array; readonly y: Float64Array };
  readonly #shapeAngle: number;
  #version = -1;
  #particles: readonly Particle[] = [];
  #slots: number[] = [];
  #indices: number[] = [];

  /** @internal */
  constructor(site: BodySite, parts: BodyParts, members: readonly Particle[], links: readonly Link[]) {
    this.kind = parts.kind;
    this.closed = parts.closed ?? true;
    this.#site = site;
    this.#members = members;
    this.#links = links;
    this.#shape = {
      x: Float64Array.from(parts.particles, (particle) => particle.x),
      y: Float64Array.from(parts.particles, (particle) => particle.y),
    };
    this.#shapeAngle = parts.angle ?? 0;
  }

  /** Whether one of its particles is in the world. */
  get alive(): boolean {
    return this.#living().length > 0;
  }

  /** Whether all of its particles are in the world. */
  get whole(): boolean {
    return this.#living().length === this.#members.length;
  }

  /** Its particles that are left, in the order in which they were planned: for a ring, the outline. */
  get particles(): readonly Particle[] {
    this.#living();
    return this.#particles;
  }

  /** Its links that are left. It looks through the links of the world: not for every frame of many bodies. */
  get links(): readonly Link[] {
    return this.alive ? this.linksAmong(new Set(this.#site.links)) : [];
  }

  /**
   * Its links that are among those that are left in the world.
   * @internal
   */
  linksAmong(left: ReadonlySet<Link>): readonly Link[] {
    return this.#links.filter((link) => left.has(link));
  }

  /** Sum of the masses. Unit: kg. */
  get mass(): number {
    return massOf(this.#site.particles, this.#slotsOf('mass'));
  }

  /** Centre of mass; where particles are pinned, the middle of those. Unit: m. */
  get x(): number {
    return meanOf(this.#site.particles.x, this.#site.particles, this.#slotsOf('x'));
  }

  /** Centre of mass, up. Unit: m. */
  get y(): number {
    return meanOf(this.#site.particles.y, this.#site.particles, this.#slotsOf('y'));
  }

  /** Velocity of the centre: momentum over mass. Unit: m/s. */
  get vx(): number {
    return meanOf(this.#site.particles.vx, this.#site.particles, this.#slotsOf('vx'));
  }

  /** Velocity of the centre, up. Unit: m/s. */
  get vy(): number {
    return meanOf(this.#site.particles.vy, this.#site.particles, this.#slotsOf('vy'));
  }

  /** Moment of inertia about the centre. Unit: kg·m². */
  get inertia(): number {
    return inertiaOf(this.#site.particles, this.#slotsOf('inertia'));
  }

  /** Angular momentum about the centre over the moment of inertia, counter-clockwise; 0 for a single point. Unit: rad/s. */
  get angularVelocity(): number {
    return angularVelocityOf(this.#site.particles, this.#slotsOf('angularVelocity'));
  }

  /** Kinetic energy of all its particles. Unit: J. */
  get kineticEnergy(): number {
    return kineticEnergyOf(this.#site.particles, this.#slotsOf('kineticEnergy'));
  }

  /**
   * Orientation, counter-clockwise: the rotation that fits the shape as it was built best. It is for drawing and decisions of
   * the game; the last bit may differ from one JavaScript engine to the next. Unit: rad, -π to π.
   */
  get angle(): number {
    return this.#angleAt(this.#slotsOf('angle'), 1);
  }

  /** A number of the game's own, 0 to 65535, which styles choose by: that of its first particle. Set, it goes to all. */
  get group(): number {
    return this.#site.particles.group[this.#slotsOf('group')[0]];
  }
  set group(value: number) {
    requireInteger('Body.group', 'group', value, 0, 65535);
    for (const slot of this.#slotsOf('group')) this.#site.particles.group[slot] = value;
  }

  /**
   * Where to draw it, between the last two states.
   * @param alpha - Share of the step: 0 is before it, 1 after it. @default 1
   * @param pose - Written to and returned, so that a frame makes no objects.
   */
  pose(alpha: number = 1, pose: Pose = { x: 0, y: 0, angle: 0 }): Pose {
    const { particles } = this.#site;
    const slots = this.#slotsOf('pose');
    pose.x = meanOf(particles.x, particles, slots, particles.previousX, alpha);
    pose.y = meanOf(particles.y, particles, slots, particles.previousY, alpha);
    pose.angle = this.#angleAt(slots, alpha);
    return pose;
  }

  /**
   * Hits the body at a point. Velocity changes by J/M and angular velocity by r × J/I, at once, as those of a rigid body: each
   * particle's velocity changes by J/M + (r × J/I) × r_i. A chain is hit as if it were stiff. Unit: N·s.
   * @param x - Where. Unit: m. @default the centre
   * @param y - Where. Unit: m. @default the centre
   */
  applyImpulse(ix: number, iy: number, x: number = this.x, y: number = this.y): void {
    const slots = this.#slotsOf('applyImpulse');
    requirePush('Body.applyImpulse', 'newton-seconds', { ix, iy }, x, y);
    const { particles } = this.#site;
    this.wake();
    spread({ x: ix, y: iy, atX: x, atY: y }, particles, slots, [particles.vx, particles.vy], false);
  }

  /**
   * Pushes the body at a point during the next step, as a rigid body: each particle gets the force m_i·(F/M + (r × F/I) × r_i).
   * Unit: N.
   * @param x - Where. Unit: m. @default the centre
   * @param y - Where. Unit: m. @default the centre
   */
  applyForce(fx: number, fy: number, x: number = this.x, y: number = this.y): void {
    const slots = this.#slotsOf('applyForce');
    requirePush('Body.applyForce', 'newtons', { fx, fy }, x, y);
    const { particles } = this.#site;
    this.wake();
    spread({ x: fx, y: fy, atX: x, atY: y }, particles, slots, [particles.fx, particles.fy], true);
  }

  /** Wakes its particles, and with them all that touches them. */
  wake(): void {
    for (const particle of this.#particles) if (particle.alive) particle.wake();
  }

  /** Takes its particles, and with them its links, out of the world. */
  remove(): void {
    this.#slotsOf('remove');
    for (const particle of this.#particles) this.#site.removeParticle(particle);
  }

  #angleAt(slots: readonly number[], alpha: number): number {
    const angle = this.#shapeAngle + rotationOf(this.#shape, this.#indices, this.#site.particles, slots, alpha);
    return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  }

  /** The slots of the particles that are left. */
  #living(): readonly number[] {
    const { version } = this.#site.particles;
    if (version === this.#version) return this.#slots;
    this.#version = version;
    if (this.#particles.length > 0 && this.#particles.every((particle) => particle.alive)) return this.#slots;
    this.#indices = [...this.#members.keys()].filter((index) => this.#members[index].alive);
    this.#particles = this.#indices.map((index) => this.#members[index]);
    this.#slots = this.#particles.map((particle) => particle.slot);
    return this.#slots;
  }

  #slotsOf(member: string): readonly number[] {
    const slots = this.#living();
    if (slots.length === 0) {
      throw new Error(
        `Body.${member}: the body must be in its world; this ${this.kind} was removed. ` +
          'Ask body.alive before using one that may be out of date.',
      );
    }
    return slots;
  }
}

function requirePush(where: string, unit: string, push: Record<string, number>, x: number, y: number): void {
  for (const [name, value] of Object.entries(push)) requireFinite(where, name, value, unit);
  requireFinite(where, 'x', x, 'metres');
  requireFinite(where, 'y', y, 'metres');
}
