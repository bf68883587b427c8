import { Box, type Particle, type Spring, Springs, severity, World } from '@mass/core';
import { PeriodMeter } from './period-meter.ts';
import type { Guide, Scene } from './scene.ts';

const lanes = [1, 2, 3, 4];
const rest = 7.5;
const floor = -3;
const height = 4.4;
const yOf = (lane: number): number => 5.2 - 0.85 * lane;
const kinetic = ({ mass, vx, vy }: Particle): number => (mass * (vx * vx + vy * vy)) / 2;

export const springsAmplitude: Scene<'stretch' | 'stiffness' | 'mass'> = {
  id: 'springs-amplitude',
  figure: 'Figure 7',
  title: 'One spring, four stretches',
  summary:
    'The same spring and the same mass four times, stretched by one, two, three and four parts. Above, the springs; the rings are the closed form. Below, their energy: the dot on the curve is the potential energy at that stretch, the level line is all the energy that the spring was given, and the bright line between the two is what is kinetic just now. Twice the stretch is four times the energy.',
  lookFor:
    'However far they swing, all pass the middle together; there the energy is all kinetic, at the ends all potential.',
  formula: String.raw`E=\underbrace{\tfrac12 m\,v^2}_{\text{kinetic}}+\underbrace{\tfrac12 k\,x^2}_{\text{potential}}=\tfrac12 k\,x_0^2,\qquad x(t)=x_0\cos\Bigl(\sqrt{k/m}\;t\Bigr)`,
  parameters: {
    stretch: { label: 'Widest stretch', unit: 'm', min: 3, max: 7, step: 0.2, value: 6 },
    stiffness: { label: 'Stiffness', unit: 'N/m', min: 2, max: 20, step: 0.5, value: 5 },
    mass: { label: 'Each mass', unit: 'kg', min: 0.5, max: 3, step: 0.1, value: 1 },
  },
  show: { minX: -8.6, maxX: 9.4, minY: -3.5, maxY: 5.8 },
  step: 1 / 240,
  style: ({ series, accent, paper }) => ({
    particle: { fill: series[1], stroke: paper, strokeWidth: 1.5 },
    groups: { 1: { fill: series[1] }, 2: { fill: accent } },
    springs: { diameter: 13 },
  }),

  build({ stretch, stiffness, mass }) {
    const world = new World({ resolver: severity() });
    const springs = world.addForce(new Springs());
    world.addShape(new Box({ centre: { x: -rest - 0.2, y: yOf(1.5) }, width: 0.4, height: 3.3 }));
    const starts = lanes.map((lane) => (stretch * lane) / lanes.length);
    const pairs = starts.map((start, lane): [Particle, Spring] => {
      const bob = world.addParticle({ x: start, y: yOf(lane), mass, radius: 0.26, group: 1 });
      return [bob, springs.add({ x: -rest, y: yOf(lane) }, bob, { stiffness, restLength: rest })];
    });

    const most = (stiffness * stretch * stretch) / 2;
    const up = (energy: number): number => floor + (height * energy) / most;
    const well = Array.from({ length: 65 }, (_, n) => ((n - 32) / 32) * stretch * 1.06);
    const still: Guide[] = [
      { kind: 'curve', points: [0, floor, 0, yOf(-0.5)], dashed: true },
      { kind: 'curve', points: well.flatMap((x) => [x, up((stiffness * x * x) / 2)]), tone: 'ink' },
      { kind: 'label', x: -7.9, y: floor + 0.85, text: 'kinetic', tone: 'accent', align: 'left' },
      { kind: 'label', x: -7.9, y: floor + 0.2, text: 'potential', tone: 1, align: 'left' },
    ];
    for (const start of starts) {
      const energy = (stiffness * start * start) / 2;
      const text = `${energy.toFixed(energy < 100 ? 1 : 0)} J`;
      still.push({ kind: 'curve', points: [-start, up(energy), 7.3, up(energy)], opacity: 0.6 });
      still.push({ kind: 'label', x: 7.5, y: up(energy), text, align: 'left', tone: 'ink' });
    }

    const omega = Math.sqrt(stiffness / mass);
    const [widest, widestSpring] = pairs[pairs.length - 1];
    return {
      world,
      guides: () => [
        ...still,
        ...starts.map((start, lane): Guide => {
          const x = start * Math.cos(omega * world.time);
          return { kind: 'circle', x, y: yOf(lane), radius: 0.34, tone: 'ink', opacity: 0.45 };
        }),
        ...pairs.flatMap(([bob, spring]): Guide[] => {
          const x = spring.extension;
          const potential = up(spring.energy);
          const all = up(spring.energy + kinetic(bob));
          return [
            { kind: 'curve', points: [x, floor, x, potential], tone: 1, bold: true },
            { kind: 'curve', points: [x, potential, x, all], tone: 'accent', bold: true },
            { kind: 'circle', x, y: potential, radius: 0.1, filled: true, tone: 1 },
          ];
        }),
      ],
      readouts: () => [
        { label: 'Widest: kinetic', value: kinetic(widest), unit: 'J', digits: 1 },
        { label: 'potential', value: widestSpring.energy, unit: 'J', digits: 1 },
        { label: 'sum', value: kinetic(widest) + widestSpring.energy, unit: 'J', digits: 1 },
      ],
    };
  },

  check(run) {
    const trial = run();
    const { world } = trial.setup;
    const seen = lanes.map((lane) => {
      const bob = world.particleAt(lane - 1);
      return { bob, start: bob.x, least: 0, most: 0, fastest: 0, meter: new PeriodMeter() };
    });
    trial.run(12, () => {
      for (const each of seen) {
        each.least = Math.min(each.least, each.bob.x);
        each.most = Math.max(each.most, each.bob.x);
        each.fastest = Math.max(each.fastest, kinetic(each.bob));
        each.meter.add(world.time, each.bob.x);
      }
    });
    const near = { atLeast: 0.99, atMost: 1.01 };
    return seen.flatMap(({ start, least, most, fastest, meter }) => [
      { name: `${start}: swing as a share of twice the stretch`, value: (most - least) / (2 * start), ...near },
      {
        name: `${start}: period as a share of 2π·√(m/k)`,
        value: meter.period / (2 * Math.PI * Math.sqrt(1 / 5)),
        ...near,
      },
      { name: `${start}: most kinetic energy as a share of k·x₀²/2`, value: fastest / (2.5 * start * start), ...near },
    ]);
  },
};
