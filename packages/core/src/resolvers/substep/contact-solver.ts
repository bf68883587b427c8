import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { Simulation } from '../../world/simulation.ts';
import { ContactMotion } from './contact-motion.ts';
import { ContactRange } from './contact-range.ts';
import { ContactRows } from './contact-rows.ts';
import { ImpulseMemory } from './impulse-memory.ts';
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

/** Contacts creep apart and do not bounce. */
const DAMPING_RATIO = 10;

/** The contacts of a step, from their discovery to their impulses. */
export class ContactSolver {
  readonly #rows = new ContactRows();
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
   * @param further - Keeps those that there are.
   */
  find({ contacts, gravity, particles, sources }: Simulation, ahead: number, further = false): void {
    const g = Math.sqrt(gravity.x * gravity.x + gravity.y * gravity.y);
    contacts.lookAhead = ahead;
    contacts.margin = g * ahead * ahead;
    this.#range.note(particles, contacts);
    sources.gather(contacts, ahead, true, further);
  }

  /**
   * Makes rows of the contacts. Reads the contacts and particles. Writes the rows.
   * @param dt - Duration of the step. Unit: s.
   * @param h - Duration of a small step. Unit: s.
   */
  begin(simulation: Simulation, dt: number, h: number): void {
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
    this.#rows.build(contacts, particles, 0);
    this.#motion.begin(contacts, this.#rows, particles);
  }

  /** Looks for more contacts, within the step, if something may go where none were looked for. */
  findMore(simulation: Simulation, rest: number): void {
    const known = this.#rows.count;
    if (!this.#range.isLeft(simulation.particles, rest)) return;
    this.find(simulation, rest, true);
    this.#rows.reserve(simulation.contacts.count);
    this.#rows.forget(known);
    this.#rows.build(simulation.contacts, simulation.particles, known);
  }

  /** Begins a small step with what the contacts did in the last one. Writes vx, vy. */
  repeat(particles: ParticleArrays): void {
    if (this.#rows.count > 0) this.#motion.repeat(particles);
  }

  /** One pass over the contacts. Reads x, y. Writes vx, vy. */
  solve({ contacts, particles }: Simulation): void {
    if (this.#rows.count === 0) return;
    this.#motion.note(particles);
    this.#pass(contacts, particles, this.#soft, this.#edgeSoft);
    this.#motion.learn(particles);
  }

  /** Undoes by position what moved particles into scenery since. Writes x, y. */
  keepOut({ contacts, particles }: Simulation): void {
    keepOut(contacts, this.#rows, contacts.sceneryStart, contacts.sceneryEnd, particles);
    keepOut(contacts, this.#rows, contacts.sceneryEnd, contacts.count, particles);
  }

  /** Takes out the speed by which penetrations were undone, then gives back what hits give back. Reads x, y. Writes vx, vy. */
  relax({ contacts, particles }: Simulation): void {
    const rows = this.#rows;
    takeBackPush(contacts, rows, particles, this.#soft.biasRate);
    this.#pass(contacts, particles, RIGID, RIGID);
    giveBack(contacts, rows, particles, this.#resting);
  }

  /** Keeps the impulses for the next step. Reads the contacts. */
  keep({ contacts, sources }: Simulation): void {
    this.#memory.keep(contacts, this.#rows, sources.links.length, this.#h);
  }

  /** What cannot give way has the last word: scenery. */
  #pass(contacts: ContactBuffer, particles: ParticleArrays, soft: Softness, edgeSoft: Softness): void {
    const { count, sceneryStart, sceneryEnd } = contacts;
    const edgesStart = Math.max(sceneryEnd, contacts.edgesStart);
    const edgesEnd = Math.max(edgesStart, contacts.edgesEnd);
    const rows = this.#rows;
    const h = this.#h;
    const calm = this.#calm;
    solveContacts(contacts, rows, 0, sceneryStart, particles, soft, h, calm);
    solveContacts(contacts, rows, sceneryEnd, edgesStart, particles, soft, h, calm);
    solveContacts(contacts, rows, edgesEnd, count, particles, soft, h, calm);
    solveEdges(contacts, rows, edgesStart, edgesEnd, particles, soft, edgeSoft, h, calm);
    solveContacts(contacts, rows, sceneryStart, sceneryEnd, particles, soft, h, calm);
  }
}
