import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { ContactBuffer, SomeSlots } from '../contact-buffer.ts';
import type { ContactKeeper, ContactScene } from '../contact-keeper.ts';
import { ContactMotion } from './contact-motion.ts';
import { ContactRange } from './contact-range.ts';
import { ContactRows } from './contact-rows.ts';
import { ImpulseMemory } from './impulse-memory.ts';
import type { RigidMotion } from './rigid-motion.ts';
import { RIGID, type Softness, softness } from './softness.ts';
import { giveBack, keepOut, solveContacts, takeBackPush } from './solve-contacts.ts';
import { solveEdges } from './solve-edges.ts';

/** Stiffness of contacts of two particles, and with scenery. Unit: Hz. */
const HERTZ = 60;

/**
 * With edges, behind which rods give way by turns, contacts must be softer, or stacks of boxes rock for ever: 20 Hz at 4 small steps in
 * 1/60 s, 50 Hz at 8. Found by trying stacks of 2 to 10 boxes.
 */
const edgeHertz = (h: number): number => Math.max(10, Math.min(HERTZ, (1 / h - 80) / 8));

/** How often what is deep in scenery is taken out of it: from one of two walls it comes into the other. */
const MOST_TIMES = 32;

/** Contacts creep apart and do not bounce. */
const DAMPING_RATIO = 10;

/** The contacts of a step, from their discovery to their impulses. */
export class ContactSolver implements ContactKeeper {
  readonly #rows = new ContactRows();
  /** The rigid bodies of the step. */
  #bodies: RigidMotion | undefined;
  readonly #memory = new ImpulseMemory();
  readonly #motion = new ContactMotion();
  readonly #range = new ContactRange();
  #h = 0;
  #soft = RIGID;
  #edgeSoft = RIGID;
  /** Closing speed up to which a contact rests: what gravity gives in a step; and up to which it is calm. Unit: m/s. */
  #resting = 0;
  #calm = 0;

  /**
   * Finds the contacts of the step. Reads the particles, links, shapes and generators. Writes the contacts.
   * @param ahead - How far ahead to look. Unit: s.
   * @param only - Keeps those that there are, and looks for more of these particles alone.
   */
  find({ contacts, gravity, particles, sources }: ContactScene, ahead: number, only?: SomeSlots): void {
    const g = Math.sqrt(gravity.x * gravity.x + gravity.y * gravity.y);
    contacts.lookAhead = ahead;
    contacts.margin = g * ahead * ahead;
    contacts.only = only;
    this.#range.note(particles, contacts);
    sources.gather(contacts, ahead, true);
    contacts.only = undefined;
  }

  /**
   * Makes rows of the contacts. Reads the contacts and particles. Writes the rows.
   * @param dt - Duration of the step. Unit: s.
   * @param h - Duration of a small step. Unit: s.
   * @param bodies - Rigid bodies that links make.
   */
  begin(simulation: ContactScene, dt: number, h: number, bodies: RigidMotion | undefined): void {
    const { x, y } = simulation.gravity;
    this.#resting = Math.sqrt(x * x + y * y) * dt;
    this.#rows.fallX = x * h;
    this.#rows.fallY = y * h;
    this.#calm = 2 * this.#resting;
    if (h !== this.#h) {
      this.#h = h;
      this.#soft = softness(HERTZ, DAMPING_RATIO, h);
      this.#edgeSoft = softness(edgeHertz(h), DAMPING_RATIO, h);
    }
    const { contacts, particles, sources } = simulation;
    this.#rows.reserve(contacts.count);
    this.#memory.recall(contacts, this.#rows, sources.links.length, h);
    this.#bodies = bodies;
    this.#makeRows(simulation, 0);
    this.#motion.begin(contacts, this.#rows, particles);
  }

  /** Looks for more contacts, within the step, of what may go where none were looked for. */
  findMore(simulation: ContactScene, rest: number): void {
    const known = this.#rows.count;
    const left = this.#range.findLeft(simulation.particles, rest);
    if (left === undefined) return;
    this.find(simulation, rest, left);
    this.#rows.reserve(simulation.contacts.count);
    this.#rows.forget(known);
    this.#makeRows(simulation, known);
  }

  #makeRows({ contacts, particles }: ContactScene, from: number): void {
    this.#rows.build(contacts, particles, from);
    this.#bodies?.rows.build(contacts, this.#rows, this.#bodies, particles);
  }

  /** Begins a small step with what the contacts did in the last one. Writes vx, vy. */
  repeat({ contacts, particles }: ContactScene, first: boolean): void {
    if (this.#rows.count === 0) return;
    if (!first && this.#rows.fresh > 0) this.#motion.forgetHits(contacts, this.#rows, particles, this.#resting);
    this.#motion.repeat(particles);
  }

  /** One pass over the contacts. Reads x, y. Writes vx, vy. */
  solve({ contacts, particles }: ContactScene): void {
    if (this.#rows.count === 0) return;
    this.#passBodies(contacts, particles, this.#soft, true);
    this.#motion.note(particles);
    this.#pass(contacts, particles, this.#soft, this.#edgeSoft);
    this.#motion.learn(particles);
  }

  /** Undoes by position what moved particles into scenery since. Writes x, y. */
  keepOut({ contacts, particles }: ContactScene): void {
    const { count, sceneryStart, sceneryEnd } = contacts;
    for (let n = 0; n < MOST_TIMES; n++) {
      const some = keepOut(contacts, this.#rows, sceneryStart, sceneryEnd, particles);
      const late = keepOut(contacts, this.#rows, sceneryEnd, count, particles);
      if (!some && !late) break;
    }
  }

  /** Takes out the speed by which penetrations were undone, then gives back what hits give back. Reads x, y. Writes vx, vy. */
  relax({ contacts, particles }: ContactScene): void {
    const rows = this.#rows;
    this.#bodies?.rows.weigh(contacts, rows, this.#bodies, particles);
    takeBackPush(contacts, rows, this.#bodies, particles, this.#soft.biasRate);
    this.#passBodies(contacts, particles, RIGID, false);
    this.#pass(contacts, particles, RIGID, RIGID);
    giveBack(contacts, rows, this.#bodies, particles, this.#resting);
  }

  /** Keeps the impulses for the next step. Reads the contacts. */
  keep({ contacts, sources }: ContactScene): void {
    this.#memory.keep(contacts, this.#rows, sources.links.length, this.#h);
  }

  /** What cannot give way has the last word: scenery. */
  #pass(contacts: ContactBuffer, particles: ParticleArrays, soft: Softness, edgeSoft: Softness): void {
    const { count, sceneryStart, sceneryEnd } = contacts;
    const edgesStart = Math.max(sceneryEnd, contacts.edgesStart);
    const edgesEnd = Math.max(edgesStart, contacts.edgesEnd);
    this.#passRows(0, sceneryStart, contacts, particles, soft);
    this.#passRows(sceneryEnd, edgesStart, contacts, particles, soft);
    this.#passRows(edgesEnd, count, contacts, particles, soft);
    this.#passRows(edgesStart, edgesEnd, contacts, particles, soft, edgeSoft);
    this.#passRows(sceneryStart, sceneryEnd, contacts, particles, soft);
  }

  /** One pass over those of some rows that are not of rigid bodies, run by run. */
  #passRows(
    start: number,
    end: number,
    contacts: ContactBuffer,
    particles: ParticleArrays,
    soft: Softness,
    edgeSoft?: Softness,
  ): void {
    const rows = this.#rows;
    const { ofBody } = rows;
    const someAreOfBodies = (this.#bodies?.rows.count ?? 0) > 0;
    for (let from = start; from < end; ) {
      let to = end;
      if (someAreOfBodies) {
        while (from < end && ofBody[from] === 1) from++;
        to = from;
        while (to < end && ofBody[to] === 0) to++;
      }
      if (edgeSoft === undefined) solveContacts(contacts, rows, from, to, particles, soft, this.#h, this.#calm);
      else solveEdges(contacts, rows, from, to, particles, soft, edgeSoft, this.#h, this.#calm);
      from = to;
    }
  }

  #passBodies(contacts: ContactBuffer, particles: ParticleArrays, soft: Softness, begins: boolean): void {
    this.#bodies?.rows.pass(contacts, this.#rows, this.#bodies, particles, soft, this.#h, this.#calm, begins);
  }
}
