import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ContactSources } from '../contacts/contact-sources.ts';
import type { Link } from '../links/link.ts';
import type { Resolver } from '../resolvers/resolver.ts';
import type { EventQueue } from './events.ts';
import type { Simulation } from './simulation.ts';

/** Takes out the links that give way. A world none of whose links can break pays nothing for it. */
export class LinkBreaker {
  #impulses = new Float64Array(0);
  /** Numbers of the links that may break, and the version of the list that this was found for. */
  readonly #breakable: number[] = [];
  #version = -1;

  /** Asks the links that may break, after a step, whether they hold. Takes links out; adds events. */
  breakLinks(simulation: Simulation, resolver: Resolver, events: EventQueue, dt: number): void {
    const { contacts, sources } = simulation;
    const { links } = sources;
    this.#findBreakable(sources);
    if (this.#breakable.length === 0) return;
    this.#sumImpulses(contacts, links.length);
    resolver.addLinkImpulses?.(simulation, this.#impulses);
    let broken: Set<Link> | undefined;
    for (const l of this.#breakable) {
      const force = this.#impulses[l] / dt;
      if (!links[l].breaksAt?.(force)) continue;
      broken ??= new Set();
      broken.add(links[l]);
      events.add('linkBroke', { link: links[l], force });
    }
    if (broken !== undefined) sources.removeLinks(broken);
  }

  #findBreakable({ links, linkVersion }: ContactSources): void {
    if (this.#version === linkVersion) return;
    this.#version = linkVersion;
    this.#breakable.length = 0;
    for (let l = 0; l < links.length; l++) if (links[l].breaksAt !== undefined) this.#breakable.push(l);
  }

  #sumImpulses({ count, source, impulse }: ContactBuffer, linkCount: number): void {
    if (this.#impulses.length < linkCount) this.#impulses = new Float64Array(linkCount * 2);
    this.#impulses.fill(0, 0, linkCount);
    for (let c = 0; c < count; c++) {
      if (source[c] < linkCount) this.#impulses[source[c]] += impulse[c];
    }
  }
}
