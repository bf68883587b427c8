import {
  Box,
  type Contacts,
  type DistanceLink,
  type ForceGenerator,
  type Link,
  type Particle,
  type ParticleArrays,
  rod,
  severity,
  World,
} from '@mass/core';
import type { Guide, Scene } from './scene.ts';

const g = 9.81;
const bays = 6;
const bay = 2;
const span = bays * bay;
const nodeMass = 60;
const steps = 240;
const levels = 5;
const wheel = 0.42;

/** A link of this scene's own: a rod that tells how it is strained by what it calls itself. Force: positive when pulled, N. */
class Member implements Link {
  readonly a: Particle;
  readonly b: Particle;
  readonly rod: DistanceLink;
  kind = 'idle';
  force = 0;

  constructor(a: Particle, b: Particle) {
    this.a = a;
    this.b = b;
    this.rod = rod(a, b);
  }

  addContacts(particles: ParticleArrays, contacts: Contacts): void {
    this.rod.addContacts(particles, contacts);
  }
}

/** A weight that rolls along a row of particles: the two that it is between carry it, by the law of the lever. */
class RollingLoad implements ForceGenerator {
  x = 0;
  weight = 0;
  readonly #row: readonly Particle[];

  constructor(row: readonly Particle[]) {
    this.#row = row;
  }

  /** Adds to fy. */
  apply({ fy }: ParticleArrays): void {
    const at = Math.min(bays - 1e-9, Math.max(0, this.x / bay));
    const n = Math.floor(at);
    fy[this.#row[n].slot] -= this.weight * (n + 1 - at);
    fy[this.#row[n + 1].slot] -= this.weight * (at - n);
  }
}

/** Moment in the middle of the bridge, of its own weight and of a load at x. Unit: N·m. */
function middleMoment(load: number, x: number): number {
  const own = nodeMass * g;
  const inner = Array.from({ length: 2 * bays - 1 }, (_, n) => ((n + 1) * bay) / 2);
  const each = (weight: number, at: number): number => (weight * Math.min(at, span - at)) / 2;
  // The upper nodes stand over the middles of the bays, the inner lower ones between the bays.
  return inner.reduce((sum, at) => sum + each(own, at), each(load, x));
}

export const rods: Scene<'load' | 'height' | 'speed'> = {
  id: 'rods',
  figure: 'Figure 23',
  title: 'A bridge of rods',
  summary:
    'Thirteen particles and twenty-three rods; the left end is pinned, the right one lies on a smooth pier. A weight rolls to and fro. What is pulled is blue, what is pushed is orange, the more the thicker: the lower rods are always pulled, the upper ones always pushed, and the slanting ones change over as the weight passes. A truss twice as high has half the force in its chords. Lift the bridge, or pull at any node: it turns on its pin, and nothing bends.',
  lookFor: 'The slanting rods change from pull to push as the weight passes, and no rod changes its length.',
  formula: String.raw`N_{\text{upper}}=-\frac{M}{h},\qquad M=\frac{P\,x}{2}+M_{\text{own weight}}\quad\Bigl(x\le\tfrac L2\Bigr)`,
  parameters: {
    load: { label: 'Rolling weight', unit: 'kN', min: 0, max: 40, step: 1, value: 20, live: true },
    height: { label: 'Height of the truss', unit: 'm', min: 1, max: 3, step: 0.1, value: 1.8 },
    speed: { label: 'Its speed', unit: 'm/s', min: 0, max: 6, step: 0.5, value: 3, live: true },
  },
  show: { minX: -1.6, maxX: 13.6, minY: -1.9, maxY: 3.4 },
  step: 1 / steps,
  poster: 2,
  style: ({ ink, accent, series, quiet, paper }) => ({
    particle: { fill: ink, minRadius: 4, stroke: paper, strokeWidth: 1 },
    groups: { 1: { fill: series[3], stroke: ink, strokeWidth: 1.5 }, 2: { fill: series[1] } },
    pins: null,
    links: {
      idle: { color: quiet, width: 2 },
      ...Object.fromEntries(
        Array.from({ length: levels }, (_, n) => [
          [`pulled ${n + 1}`, { color: series[1], width: 2 + 1.3 * n, alpha: 0.55 + 0.09 * (n + 1) }],
          [`pushed ${n + 1}`, { color: accent, width: 2 + 1.3 * n, alpha: 0.55 + 0.09 * (n + 1) }],
        ]).flat(),
      ),
    },
  }),

  build(values) {
    const { height } = values;
    const world = new World({ gravity: { x: 0, y: -g }, resolver: severity({ iterations: 500 }) });
    const lower = Array.from({ length: bays + 1 }, (_, n) =>
      world.addParticle({ x: n * bay, y: 0, mass: n === 0 ? Infinity : nodeMass, radius: 0.11 }),
    );
    const upper = Array.from({ length: bays }, (_, n) =>
      world.addParticle({ x: (n + 0.5) * bay, y: height, mass: nodeMass, radius: 0.11 }),
    );
    const members: Member[] = [];
    const join = (a: Particle, b: Particle): Member => {
      const member = world.addLink(new Member(a, b));
      members.push(member);
      return member;
    };
    for (let n = 0; n < bays; n++) {
      join(lower[n], lower[n + 1]);
      join(lower[n], upper[n]);
      join(upper[n], lower[n + 1]);
      if (n > 0) join(upper[n - 1], upper[n]);
    }
    const middle = members.find(({ a, b }) => a === upper[bays / 2 - 1] && b === upper[bays / 2]) as Member;
    world.addShape(new Box({ centre: { x: -0.6, y: -1.61 }, width: 1.6, height: 3 }));
    world.addShape(new Box({ centre: { x: span + 0.6, y: -1.61 }, width: 1.6, height: 3 }));

    const roller = world.addParticle({ x: 0, y: 0, radius: wheel, mass: Infinity, group: 1 });
    const load = world.addForce(new RollingLoad(lower));
    let travelled = 0.1 * span;
    let statics = 0; // smoothed alike

    /** What each rod had to hold in the last step, smoothed over a few steps. */
    function measure(dt: number): void {
      const { count, source, impulse, normalX, normalY } = world.contacts;
      const forces = new Float64Array(members.length);
      for (let c = 0; c < count; c++) {
        const member = members[source[c]];
        if (member === undefined) continue;
        const along = (member.b.x - member.a.x) * normalX[c] + (member.b.y - member.a.y) * normalY[c];
        forces[source[c]] += (Math.sign(along) * impulse[c]) / dt;
      }
      const most = middleMoment(Math.max(10, values.load) * 1000, span / 2) / height;
      for (const [n, member] of members.entries()) {
        member.force += Math.min(1, 30 * dt) * (forces[n] - member.force);
        const level = Math.min(levels, Math.ceil((levels * Math.abs(member.force)) / most - 0.2));
        member.kind = level < 1 ? 'idle' : `${member.force > 0 ? 'pulled' : 'pushed'} ${level}`;
      }
    }

    return {
      world,
      beforeStep(dt) {
        measure(dt);
        travelled = (travelled + values.speed * dt) % (2 * span);
        statics += Math.min(1, 30 * dt) * (-middleMoment(load.weight, load.x) / height - statics);
        load.x = travelled < span ? travelled : 2 * span - travelled;
        load.weight = values.load * 1000;
        // The weight is drawn where it stands on the deck.
        const n = Math.min(bays - 1, Math.floor(load.x / bay));
        const share = load.x / bay - n;
        const [a, b] = [lower[n], lower[n + 1]];
        const rise = wheel + a.radius;
        roller.x = a.x + share * (b.x - a.x) - ((b.y - a.y) / bay) * rise;
        roller.y = a.y + share * (b.y - a.y) + ((b.x - a.x) / bay) * rise;
      },
      guides: (): Guide[] => [
        { kind: 'label', x: roller.x, y: roller.y + 0.7, text: `${values.load} kN`, tone: 'ink' },
        { kind: 'label', x: span / 2, y: -1.2, text: 'pulled', tone: 2, align: 'right' },
        { kind: 'label', x: span / 2 + 0.4, y: -1.2, text: 'pushed', tone: 'accent', align: 'left' },
      ],
      readouts: () => [
        { label: 'Middle of the upper chord', value: middle.force / 1000, unit: 'kN', digits: 1 },
        { label: 'by statics', value: statics / 1000, unit: 'kN', digits: 1 },
        { label: 'Greatest strain', value: 100 * strainOf(members), unit: '%', digits: 3 },
      ],
    };
  },

  check(run) {
    const trial = run({ speed: 0, load: 30 });
    const { world } = trial.setup;
    const members = world.links as readonly Member[];
    const readout = (n: number): number => trial.setup.readouts?.()[n].value ?? Number.NaN;
    trial.run(2);
    const still = readout(0) / readout(1);

    const rolling = run();
    const rollingMembers = rolling.setup.world.links as readonly Member[];
    const slanting = rollingMembers[4 * 2]; // the lower node of the third bay to its upper one
    let [strain, pull, push] = [0, 0, 0];
    rolling.run(8, () => {
      strain = Math.max(strain, strainOf(rollingMembers));
      pull = Math.max(pull, slanting.force);
      push = Math.min(push, slanting.force);
    });

    let pulled = 0;
    const corner = world.particleAt(bays + 1 + 2);
    trial.run(1, () => {
      corner.applyForce(8000, 30_000);
      pulled = Math.max(pulled, strainOf(members));
    });
    return [
      { name: 'force in the upper chord as a share of statics', value: still, atLeast: 0.98, atMost: 1.02 },
      { name: 'strain of any rod while the weight rolls', value: strain, atMost: 0.002 },
      { name: 'a slanting rod is pulled, N', value: pull, atLeast: 3000 },
      { name: 'and pushed, N', value: push, atMost: -3000 },
      { name: 'strain of any rod while a node is dragged', value: pulled, atMost: 0.002 },
      { name: 'how far the node was lifted, m', value: corner.y - 1.8, atLeast: 0.1 },
    ];
  },
};

function strainOf(members: readonly Member[]): number {
  return Math.max(...members.map(({ rod: { strain } }) => Math.abs(strain)));
}
