import { absent, wrong } from '../math/checks.ts';
import type { Body } from './body.ts';
import type { BodySite } from './body-parts.ts';
import type { BodyPlan } from './body-plan.ts';

/** The bodies of one world, in order of addition. */
export class Bodies {
  readonly #site: BodySite;
  readonly #list: Body[] = [];
  #version = 0;

  constructor(site: BodySite) {
    this.#site = site;
  }

  /** Those that live. */
  get list(): readonly Body[] {
    const { version } = this.#site.particles;
    if (version === this.#version) return this.#list;
    this.#version = version;
    let kept = 0;
    for (const body of this.#list) {
      if (body.alive) this.#list[kept++] = body;
    }
    this.#list.length = kept;
    return this.#list;
  }

  /** Builds a body, or throws the error that says why it cannot be built. */
  add(where: string, plan: BodyPlan): Body {
    if (typeof plan?.build !== 'function') {
      throw wrong(where, 'a body must be what a builder such as box or aggregate returns', plan);
    }
    const body = plan.build(where, this.#site);
    this.#list.push(body);
    return body;
  }

  /** Takes a body out: its particles and, with them, its links. */
  remove(where: string, body: Body): void {
    if (!this.list.includes(body)) throw absent(where, 'a body', body);
    body.remove();
  }
}
