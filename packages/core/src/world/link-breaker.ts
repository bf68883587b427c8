import type { ContactBuffer } from '../contacts/contact-buffer.ts';
import type { ContactSources } from '../contacts/contact-sources.ts';
import type { Link } from '../links/link.ts';
import type { EventQueue } from './events.ts';

/** Takes out the links that give way. */
export class LinkBreaker {
  #impulses = new Float64Array(0);

  /** Asks each link, after a step, whether it holds. Reads the contacts' impulses. Takes links out; adds events. */
  breakLinks(contacts: ContactBuffer, sources: ContactSources, events: EventQueue, dt: number): void {
    const { links } = sources;
    if (links.length === 0) return;
    this.#sumImpulses(contacts, links.length);
    let broken: Link[] | undefined;
    for (let l = 0; l < links.length; l++) {
      const force = this.#impulses[l] / dt;
      if (!links[l].breaksAt?.(force)) continue;
      broken = [...(broken ?? []), links[l]];
      events.add('linkBroke', { link: links[l], force });
    }
    for (const link of broken ?? []) sources.removeLink('World.step', link);
  }

  #sumImpulses({ count, source, impulse }: ContactBuffer, linkCount: number): void {
    if (this.#impulses.length < linkCount) this.#impulses = new Float64Array(linkCount * 2);
    this.#impulses.fill(0, 0, linkCount);
    for (let c = 0; c < count; c++) {
      if (source[c] < linkCount) this.#impulses[source[c]] += impulse[c];
    }
  }
}
