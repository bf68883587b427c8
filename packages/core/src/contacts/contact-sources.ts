import type { Places, Shape, ShapeFinder } from '../collision/shape.ts';
import type { Link } from '../links/link.ts';
import { requireFunction } from '../math/checks.ts';
import { Members } from '../math/members.ts';
import { checkedEnd, isEndAlive, particleOf } from '../particles/end.ts';
import type { ParticleStore } from '../particles/particle-store.ts';
import { type ContactBuffer, pairKey } from './contact-buffer.ts';
import type { ContactGenerator } from './contact-generator.ts';
import type { ContactKeeper } from './contact-keeper.ts';
import { dropRepeated } from './drop-repeated.ts';

/** Where a contact comes from. */
export type ContactSource = Link | Shape | ContactGenerator;

/** All that finds contacts: first the links, then the static shapes, then the other generators, each in order of addition. */
export class ContactSources {
  readonly shapes: Members<Shape> = new Members('a shape', 'findSurface(x, y, reach, surface)');
  readonly generators: Members<ContactGenerator> = new Members(
    'a contact generator',
    'addContacts(particles, contacts, dt)',
  );
  readonly #links: Members<Link> = new Members('a link', 'addContacts(particles, contacts, dt)');
  readonly #linkedPairs = new Set<number>();
  readonly #store: ParticleStore;
  /** Comes with the first shape. */
  #shapeFinder: ShapeFinder | undefined;
  #keeper: ContactKeeper | undefined;
  #makeKeeper: (() => ContactKeeper) | undefined;
  /** Whether some link is kept by its contacts. */
  #hasPlainLinks = false;
  #removals = 0;
  #pairsAreOld = false;
  #linkVersion = 0;

  constructor(store: ParticleStore) {
    this.#store = store;
  }

  /** The links whose ends all live. */
  get links(): readonly Link[] {
    this.#dropDead();
    return this.#links.list;
  }

  addLink(where: string, link: Link): void {
    this.#dropDead();
    this.#links.check(where, link);
    checkedEnd(where, "the link's a", link.a);
    checkedEnd(where, "the link's b", link.b);
    this.#links.add(where, link);
    this.#makeKeeper ??= link.keeper;
    this.#pairsAreOld = true;
  }

  removeLink(where: string, link: Link): void {
    this.#dropDead();
    this.#links.remove(where, link);
    this.#pairsAreOld = true;
  }

  /** Takes out links that are in the world, all at once. */
  removeLinks(links: ReadonlySet<Link>): void {
    this.#links.keep((link) => !links.has(link));
    this.#pairsAreOld = true;
  }

  addShape(where: string, shape: Shape): void {
    this.shapes.check(where, shape);
    requireFunction(where, 'the finder of a shape', shape.finder, 'such as shapeFinder');
    this.shapes.add(where, shape);
    this.#shapeFinder = shape.finder(this.#shapeFinder);
    this.#makeKeeper ??= this.#shapeFinder.keeper;
  }

  addGenerator(where: string, generator: ContactGenerator): void {
    this.generators.add(where, generator);
    this.#makeKeeper ??= generator.keeper;
  }

  /** What keeps the contacts that are found in small steps; none where nothing finds any. */
  get keeper(): ContactKeeper | undefined {
    this.#keeper ??= this.#makeKeeper?.();
    if (this.#keeper === undefined && (this.#hasPlainLinks || this.generators.list.length > 0)) {
      throw new Error(
        'World.step: what finds contacts must name what keeps them; nothing does. Give it { keeper: contactKeeper }.',
      );
    }
    return this.#keeper;
  }

  /** Whether there is nothing that could find a contact. */
  get isEmpty(): boolean {
    return this.links.length + this.shapes.list.length + this.generators.list.length === 0;
  }

  /** What found the contacts whose `source` is a number. */
  at(source: number): ContactSource {
    const shape = source - this.#links.list.length;
    if (shape < 0) return this.#links.list[source];
    const generator = shape - this.shapes.list.length;
    return generator < 0 ? this.shapes.list[shape] : this.generators.list[generator];
  }

  /** Changes whenever a link came or went. */
  get linkVersion(): number {
    this.linkedPairs();
    return this.#linkVersion;
  }

  /**
   * Finds the contacts of this moment, and those that the buffer looks ahead to. Reads the particles. Writes the contacts.
   * @param without - Leaves out the links that have a solver of their own.
   */
  gather(contacts: ContactBuffer, dt: number, without = false): void {
    const store = this.#store;
    const { links } = this;
    const shapes = this.shapes.list;
    const generators = this.generators.list;
    const further = contacts.only !== undefined;
    const known = further ? contacts.count : 0;
    if (!further) contacts.clear(store.count, this.linkedPairs());
    contacts.linkVersion = this.linkVersion;
    let source = 0;
    for (let l = 0; l < links.length; l++) {
      contacts.currentSource = source++;
      if (!without || links[l].solver === undefined) links[l].addContacts(store, contacts, dt);
    }
    const sceneryStart = contacts.count;
    this.#shapeFinder?.find(shapes, source, store, contacts, dt);
    if (!further) {
      contacts.sceneryStart = sceneryStart;
      contacts.sceneryEnd = contacts.count;
    }
    source += shapes.length;
    for (let g = 0; g < generators.length; g++) {
      contacts.currentSource = source++;
      generators[g].addContacts(store, contacts, dt);
    }
    if (further) dropRepeated(contacts, known);
  }

  /** Finds what touches sensors among the static shapes, or touches these as a sensor, now. Reads the particles. Writes sensors. */
  findSensors(contacts: ContactBuffer, dt: number): void {
    const shapes = this.shapes.list;
    const { sensor } = this.#store;
    if (!shapes.some((shape) => shape.sensor) && sensor.indexOf(1) < 0) return;
    this.#shapeFinder?.find(shapes, this.links.length, this.#store, contacts, dt, true);
  }

  /** Puts what has gone through a shape since the step began back in front of it. Writes x, y, vx, vy. */
  keepInFront(before: Places): void {
    this.#shapeFinder?.keepInFront(this.shapes.list, this.#store, before);
  }

  /** Takes out the links that lost an end. */
  #dropDead(): void {
    if (this.#removals === this.#store.removals) return;
    this.#removals = this.#store.removals;
    const before = this.#links.list.length;
    this.#links.keep(isWhole);
    this.#pairsAreOld ||= this.#links.list.length < before;
  }

  /** Pairs of slots that a link joins, as `pairKey`. */
  linkedPairs(): ReadonlySet<number> {
    if (!this.#pairsAreOld) return this.#linkedPairs;
    this.#pairsAreOld = false;
    this.#linkedPairs.clear();
    this.#linkVersion++;
    this.#hasPlainLinks = this.#links.list.some(({ solver }) => solver === undefined);
    for (const link of this.#links.list) {
      const a = particleOf(link.a);
      const b = particleOf(link.b);
      if (a !== undefined && b !== undefined) this.#linkedPairs.add(pairKey(a.slot, b.slot));
    }
    return this.#linkedPairs;
  }
}

/** Whether both ends of a link are there; if not, the one that is wakes: nothing holds it any more. */
function isWhole({ a, b }: Link): boolean {
  if (isEndAlive(a) && isEndAlive(b)) return true;
  for (const end of [a, b]) if (isEndAlive(end)) particleOf(end)?.wake();
  return false;
}
