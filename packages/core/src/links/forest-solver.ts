import type { ParticleArrays } from '../particles/particle-arrays.ts';
import { ROD } from './aim.ts';
import { eliminate } from './eliminate.ts';
import { ForestTable } from './forest-table.ts';
import { type ForestLayout, layOutForests } from './lay-out-forests.ts';
import type { LimitedLink } from './limited-link.ts';
import type { LinkSolver } from './link.ts';
import { linkGraph } from './link-graph.ts';
import { spanningForests } from './spanning-forests.ts';
import { gather, substitute } from './substitute.ts';

/** Mass of an end that nothing moves, in masses of its neighbour: finite, so that two such ends hold what is between them. */
const HEAVY = 1e9;
/** How often a forest is solved anew without the links that would push where they can only pull. */
const ROUNDS = 8;

/** Makes what keeps links of limited length in the sub-step resolver. */
export function forestSolver(): LinkSolver {
  return new ForestSolver();
}

/**
 * Keeps links by solving the trees that they make, each directly and in linear time. Loops are dealt out to several forests,
 * solved one after the other; each link then starts from the tension that it had a small step before.
 */
class ForestSolver implements LinkSolver {
  impulse: Float64Array = new Float64Array(0);
  readonly #table = new ForestTable();
  #links: readonly LimitedLink[] = [];
  #layout: ForestLayout = { ranges: [0], groups: [0] };
  #lastH = 0;
  #wasMovable = new Uint8Array(0);

  setLinks(links: readonly LimitedLink[], particles: ParticleArrays): void {
    const tensions = this.#tensionsOf(links);
    const graph = linkGraph(links, particles);
    this.#layout = layOutForests(this.#table, links, graph, spanningForests(graph));
    this.#links = links;
    this.#wasMovable = new Uint8Array(particles.count);
    for (let s = 0; s < particles.count; s++) this.#wasMovable[s] = particles.inverseMass[s] > 0 ? 1 : 0;
    if (this.impulse.length < links.length) this.impulse = new Float64Array(links.length);
    const { count, link, tension } = this.#table;
    for (let k = 0; k < count; k++) tension[k] = link[k] < 0 ? 0 : tensions[link[k]];
  }

  begin(particles: ParticleArrays): void {
    this.impulse.fill(0);
    const t = this.#table;
    for (let k = 0; k < t.count; k++) {
      const s = t.slot[k];
      const p = t.parent[k];
      t.moves[k] = s >= 0 && particles.inverseMass[s] > 0 && particles.asleep[s] === 0 ? 1 : 0;
      t.mass[k] = t.moves[k] === 1 ? particles.mass[s] : p < 0 ? 1 : HEAVY * t.mass[p];
      const l = t.link[k];
      t.inverseMass[k] =
        (s < 0 ? 0 : particles.inverseMass[s]) + (p < 0 || t.slot[p] < 0 ? 0 : particles.inverseMass[t.slot[p]]);
      if (l < 0) continue;
      const link = this.#links[l];
      t.minLength[k] = link.minLength;
      t.maxLength[k] = link.maxLength;
      t.compliance[k] = link.compliance;
      t.damping[k] = link.damping;
      t.restitution[k] = link.restitution;
      if (link.minLength === link.maxLength) t.side[k] = ROD;
      else if (t.side[k] === ROD) t.side[k] = 0;
    }
  }

  solve(particles: ParticleArrays, h: number): void {
    const { ranges, groups } = this.#layout;
    for (let g = 0; g < groups.length - 1; g++) {
      if (groups[g + 1] - groups[g] > 1) this.#startAgain(ranges[groups[g]], ranges[groups[g + 1]], particles, h);
      for (let r = groups[g]; r < groups[g + 1]; r++) this.#solveRange(ranges[r], ranges[r + 1], particles, h);
    }
    this.#lastH = h;
  }

  #startAgain(from: number, to: number, particles: ParticleArrays, h: number): void {
    const t = this.#table;
    const ratio = this.#lastH > 0 ? h / this.#lastH : 0;
    const { vx, vy, inverseMass } = particles;
    gather(t, from, to, particles);
    for (let k = from; k < to; k++) {
      const p = t.parent[k];
      if (p < 0) continue;
      const start = t.tension[k] * ratio;
      t.start[k] = start;
      const jx = start * (t.x[p] - t.x[k]);
      const jy = start * (t.y[p] - t.y[k]);
      if (t.moves[k] === 1) {
        const s = t.slot[k];
        vx[s] += jx * inverseMass[s];
        vy[s] += jy * inverseMass[s];
      }
      if (t.moves[p] === 1) {
        const s = t.slot[p];
        vx[s] -= jx * inverseMass[s];
        vy[s] -= jy * inverseMass[s];
      }
    }
  }

  #solveRange(from: number, to: number, particles: ParticleArrays, h: number): void {
    const t = this.#table;
    gather(t, from, to, particles);
    for (let round = 0; round < ROUNDS; round++) {
      if (!(eliminate(t, from, to, h, 0, round > 0) || eliminate(t, from, to, h, 1, true))) return;
      substitute(t, from, to, particles);
      if (!this.#letGo(from, to)) break;
    }
    for (let k = from; k < to; k++) {
      if (t.link[k] >= 0) this.impulse[t.link[k]] += t.tension[k] * t.maxLength[k];
    }
  }

  #letGo(from: number, to: number): boolean {
    const { side, tension } = this.#table;
    let any = false;
    for (let k = from; k < to; k++) {
      if (side[k] === ROD || side[k] * tension[k] >= 0) continue;
      side[k] = 0;
      any = true;
    }
    return any;
  }

  #tensionsOf(links: readonly LimitedLink[]): Float64Array {
    const { count, link, tension } = this.#table;
    const old = new Float64Array(this.#links.length);
    for (let k = 0; k < count; k++) if (link[k] >= 0) old[link[k]] = tension[k];
    const tensions = new Float64Array(links.length);
    let o = 0;
    for (let l = 0; l < links.length; l++) {
      let at = o;
      while (at < old.length && this.#links[at] !== links[l]) at++;
      if (at === old.length) break; // it is new, and so are those after it
      tensions[l] = old[at];
      o = at + 1;
    }
    return tensions;
  }
}
