import type { ContactBuffer } from '../../contacts/contact-buffer.ts';
import type { ParticleArrays } from '../../particles/particle-arrays.ts';
import type { Simulation } from '../../world/simulation.ts';
import { ContactMotion } from './contact-motion.ts';
import { ContactRange } from './contact-range.ts';
import { ContactRows } from './contact-rows.ts';
import { giveBackEdges, solveEdges } from './edge-contacts.ts';
import { EdgeRows } from './edge-rows.ts';
import { ImpulseMemory } from './impulse-memory.ts';
import { RIGID, type Softness, softness } from './softness.ts';
import { giveBack, solveContacts, takeBackPush } from './solve-contacts.ts';

/** Stiffness of contacts, of two particles and with scenery. Unit: Hz. */
const HERTZ = 60;
const SCENERY_HERTZ = 120;

/** Contacts creep apart and do not bounce. */
const DAMPING_RATIO = 10;

/** The contacts of a step, from their discovery to their impulses. */
export class ContactSolver {
  readonly #rows = new ContactRows();
  readonly #edges = new EdgeRows();
  readonly #memory = new ImpulseMemory();
  readonly #motion = new ContactMotion();
  readonly #range = new ContactRange();
  #h = 0;
  #soft = RIGID;
  #scenerySoft = RIGID;
  /** Closing speed up to which a contact rests: what gravity gives in a step; and up to which it is calm. Unit: m/s. */
  #resting = 0;
  #calm = 0;

  /**
   * Finds the contacts of the step. Reads the particles, links, shapes and generators. Writes the contacts.
   * @param ahead - How far ahead to look. Unit: s.
   */
  find({ contacts, gravity, particles, sources }: Simulation, ahead: number): void {
    const g = Math.sqrt(gravity.x * gravity.x + gravity.y * gravity.y);
    contacts.lookAhead = ahead;
    contacts.margin = g * ahead * ahead;
    this.#range.note(particles, contacts);
    sources.gather(contacts, ahead, true);
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
      this.#scenerySoft = softness(SCENERY_HERTZ, DAMPING_RATIO, h);
    }
    this.#makeRows(simulation, false);
  }

  /** Looks for contacts again, within the step, if something may go farther than they were looked for. */
  findAgain(simulation: Simulation, rest: number): void {
    if (this.#rows.count === 0 || !this.#range.isLeft(simulation.particles, rest)) return;
    this.keep(simulation);
    this.find(simulation, rest);
    this.#makeRows(simulation, true);
  }

  #makeRows({ contacts, particles, sources }: Simulation, within: boolean): void {
    const rows = this.#rows;
    rows.reserve(contacts.count);
    this.#memory.recall(contacts, rows, sources.links.length, this.#h, within);
    rows.build(contacts, particles);
    this.#edges.build(contacts, rows, particles);
    this.#motion.begin(contacts, rows, this.#edges, particles);
  }

  /** Begins a small step with what the contacts did in the last one. Writes vx, vy. */
  repeat(particles: ParticleArrays): void {
    if (this.#rows.count > 0) this.#motion.repeat(particles);
  }

  /** One pass over the contacts. Reads x, y. Writes vx, vy. */
  solve({ contacts, particles }: Simulation): void {
    if (this.#rows.count === 0) return;
    this.#motion.note(particles);
    this.#pass(contacts, particles, this.#soft, this.#scenerySoft);
    this.#motion.learn(particles);
  }

  /** Takes out the speed by which penetrations were undone, then gives back what hits give back. Reads x, y. Writes vx, vy. */
  relax({ contacts, particles }: Simulation): void {
    const rows = this.#rows;
    takeBackPush(contacts, rows, particles, this.#scenerySoft.biasRate);
    this.#edges.uncount(contacts);
    this.#pass(contacts, particles, RIGID, RIGID);
    giveBack(contacts, rows, particles, this.#resting);
    giveBackEdges(this.#edges, contacts, particles, this.#resting);
  }

  /** Keeps the impulses for the next step. Reads the contacts. */
  keep({ contacts, sources }: Simulation): void {
    this.#edges.report(this.#rows);
    this.#memory.keep(contacts, this.#rows, sources.links.length, this.#h);
  }

  /** What cannot give way has the last word: scenery. */
  #pass(contacts: ContactBuffer, particles: ParticleArrays, soft: Softness, scenerySoft: Softness): void {
    const { count, sceneryStart, sceneryEnd } = contacts;
    const rows = this.#rows;
    const h = this.#h;
    const calm = this.#calm;
    solveContacts(contacts, rows, 0, sceneryStart, particles, soft, h, calm);
    solveContacts(contacts, rows, sceneryEnd, count, particles, soft, h, calm);
    solveEdges(this.#edges, contacts, particles, soft, h, calm);
    solveContacts(contacts, rows, sceneryStart, sceneryEnd, particles, scenerySoft, h, calm);
  }
}
