import { DiscContacts } from '../../collision/disc-contacts.ts';
import { SCENERY } from '../../contacts/contact-buffer.ts';
import { allFinite } from '../../particles/finite.ts';
import { damp } from '../../world/integrators.ts';
import type { Simulation } from '../../world/simulation.ts';
import type { Resolver } from '../resolver.ts';
import { Corrections } from './corrections.ts';
import { findDiscTouches, findShapeTouches } from './find-touches.ts';
import { Flight } from './flight.ts';
import { Impacts } from './impacts.ts';
import { Places } from './places.ts';
import { Rests } from './rests.ts';
import { Schedule } from './schedule.ts';
import { Touches } from './touches.ts';

/**
 * The resolver for billiards: from one impact to the next, each at its own time, so that nothing passes through anything and
 * nothing overlaps. Between impacts the flight is exact for accelerations that last the step; the world's `integrator` is not used.
 * Impacts at one time are resolved one after the other, the lowest slots first.
 *
 * The ten steps of the thesis, but event by event (B. D. Lubachevsky, *How to simulate billiards and similar systems*, 1991):
 * touches are found on the ways, not where these end, and after an impact only those that took part are predicted anew.
 */
export function impact(): Resolver {
  return new ImpactResolver();
}

class ImpactResolver implements Resolver {
  readonly name = 'impact';
  readonly #flight = new Flight();
  readonly #touches = new Touches();
  readonly #rests = new Rests(this.#flight, this.#touches);
  readonly #schedule = new Schedule(this.#flight);
  readonly #impacts = new Impacts(this.#flight, this.#touches, this.#rests);
  readonly #corrections = new Corrections(this.#flight, this.#touches);
  readonly #places = new Places();
  #discSource = 0;

  step(simulation: Simulation, dt: number): boolean {
    const { particles, forces, gravity } = simulation;
    forces.apply(dt, simulation.time);
    const finite = this.#flight.begin(particles, gravity, dt);
    if (finite) {
      this.#begin(simulation);
      this.#schedule.predictAll();
      this.#runImpacts(simulation);
    }
    this.#flight.finish();
    if (particles.damped) damp(particles, dt);
    if (!allFinite(particles)) return false;
    if (this.#rests.isCrowded) this.#findTouches(simulation, true);
    this.#corrections.apply(simulation, dt, this.#rests.isCrowded);
    return allFinite(particles);
  }

  /** Finds what touches as the step begins, and supports what rests. Reads the flight. Writes touches, vx, vy, ax, ay. */
  #begin(simulation: Simulation): void {
    const { particles, sources, contacts } = simulation;
    const touches = this.#touches;
    const rests = this.#rests;
    const shapes = sources.shapes.list;
    const firstShape = sources.links.length;
    const discs = sources.generators.list.findIndex((generator) => generator instanceof DiscContacts);
    this.#discSource = firstShape + shapes.length + discs;
    contacts.clear(particles.count, sources.linkedPairs());
    touches.clear(particles.count);
    rests.begin();
    this.#schedule.begin(shapes, contacts, discs >= 0);
    this.#findTouches(simulation, false);
    if (touches.count === 0) return;
    rests.settleAll();
    this.#schedule.findPairs();
  }

  /** Finds what touches or nearly does now. Reads the flight. Adds touches. */
  #findTouches({ sources, contacts }: Simulation, crowded: boolean): void {
    const { pairs } = this.#schedule;
    this.#schedule.findPairs();
    findShapeTouches(this.#flight, sources.shapes.list, sources.links.length, this.#places, this.#touches, crowded);
    findDiscTouches(this.#flight, pairs, contacts, this.#discSource, this.#touches, crowded);
  }

  /** Takes one touch after the other until the step ends. Reads and writes all of the flight. */
  #runImpacts({ sources }: Simulation): void {
    const schedule = this.#schedule;
    const firstShape = sources.links.length;
    const rests = this.#rests;
    const { duration } = this.#flight;
    for (let i = schedule.next; schedule.timeOf(i) < duration || rests.dueTime < duration; i = schedule.next) {
      const now = Math.min(schedule.timeOf(i), rests.dueTime);
      if (now === rests.dueTime) {
        rests.relieveAll(now);
        this.#predictCluster(now);
        continue;
      }
      const partner = schedule.partnerOf(i);
      if (!schedule.isCurrent(i)) {
        schedule.predict(i, now);
      } else if (partner < 0) {
        this.#impacts.hitShape(i, sources.shapes.list[~partner], firstShape + ~partner, now);
        this.#predict(i, SCENERY, now);
      } else {
        this.#impacts.hitDisc(i, partner, this.#discSource, now);
        this.#predict(i, partner, now);
      }
    }
  }

  /** Predicts anew the two that touched, and those that rest on them and whose ways changed. */
  #predict(i: number, j: number, now: number): void {
    const schedule = this.#schedule;
    schedule.turn(i, now);
    if (j !== SCENERY) schedule.turn(j, now);
    this.#predictCluster(now);
    schedule.predict(i, now);
    if (j !== SCENERY) schedule.predict(j, now);
  }

  /** Predicts anew those whose ways the support changed. */
  #predictCluster(now: number): void {
    const { slots, slotCount } = this.#rests.cluster;
    const schedule = this.#schedule;
    for (let s = 0; s < slotCount; s++) schedule.turn(slots[s], now);
    for (let s = 0; s < slotCount; s++) schedule.predict(slots[s], now);
  }
}
