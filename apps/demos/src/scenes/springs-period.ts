import { Box, Springs, severity, World } from '@mass/core';
import { PeriodMeter } from './period-meter.ts';
import type { Guide, Scene } from './scene.ts';

const times = [1, 4, 9, 16];
const rest = 4;
const chart = 9;
const xOf = (lane: number): number => 1.45 * lane - 5.7;

export const springsPeriod: Scene<'stiffness' | 'mass' | 'stretch'> = {
  id: 'springs-period',
  figure: 'Figure 6',
  title: 'Springs of different stiffness',
  summary:
    'Equal masses on springs of one rest length, pulled down by the same stretch and let go; nothing weighs anything here. The stiffness goes as 1, 4, 9 and 16, the periods therefore as 1, 1/2, 1/3 and 1/4. Each mass draws its own line; the dots are the closed form, drawn beforehand. The stretch does not enter the period: change it and see. Take hold of a mass and pull.',
  lookFor:
    'Four times the stiffness is half the period: all four meet again at the bottom whenever the softest gets there.',
  formula: String.raw`m\,\ddot x=-k\,x\qquad\Rightarrow\qquad x(t)=x_0\cos\omega t,\qquad T=\frac{2\pi}{\omega}=2\pi\sqrt{\frac{m}{k}}`,
  parameters: {
    stiffness: { label: 'Softest spring', unit: 'N/m', min: 2, max: 8, step: 0.5, value: 4 },
    mass: { label: 'Each mass', unit: 'kg', min: 0.5, max: 2, step: 0.1, value: 1 },
    stretch: { label: 'Stretch at the start', unit: 'm', min: 0.5, max: 2, step: 0.1, value: 1.7 },
  },
  show: { minX: -7.9, maxX: 10.1, minY: -4.5, maxY: 4.7 },
  step: 1 / 120,
  style: ({ series, paper, quiet, ink }) => ({
    particle: { stroke: paper, strokeWidth: 1.5 },
    springs: { colorBy: { by: 'stiffness', from: 2, to: 64, colors: [quiet, ink] } },
    groups: Object.fromEntries(times.map((_, lane) => [lane, { fill: series[lane + 1] }])),
  }),

  build({ stiffness, mass, stretch }) {
    const world = new World({ resolver: severity() });
    const springs = world.addForce(new Springs());
    world.addShape(new Box({ centre: { x: -3.525, y: 4.2 }, width: 6.2, height: 0.4 }));
    const bobs = times.map((factor, lane) => {
      const bob = world.addParticle({ x: xOf(lane), y: -stretch, mass, radius: 0.36, group: lane });
      springs.add({ x: xOf(lane), y: rest }, bob, { stiffness: factor * stiffness, restLength: rest });
      return bob;
    });

    const omegas = times.map((factor) => Math.sqrt((factor * stiffness) / mass));
    const length = (2 * 2 * Math.PI) / omegas[0];
    const across = (t: number): number => (chart * t) / length;
    const beforehand = omegas.map((omega, lane): Guide => {
      const ts = Array.from({ length: 241 }, (_, n) => (n / 240) * length);
      const points = ts.flatMap((t) => [across(t), -stretch * Math.cos(omega * t)]);
      return { kind: 'curve', points, dashed: true, tone: lane, opacity: 0.6 };
    });
    const label = (x: number, y: number, text: string): Guide => ({ kind: 'label', x, y, text, tone: 'ink' });
    const words: Guide[] = [
      { kind: 'curve', points: [-6.4, 0, chart, 0], opacity: 0.5 },
      ...['k', 'T', 'seen'].map((text, row): Guide => {
        return { kind: 'label', x: -7.7, y: -2.7 - 0.65 * row, text, align: 'left' };
      }),
      ...times.map((factor, lane) => label(xOf(lane), -2.7, `${factor * stiffness}`)),
      ...omegas.map((omega, lane) => label(xOf(lane), -3.35, ((2 * Math.PI) / omega).toFixed(2))),
      ...[1, 2].map((n) => label((chart * n) / 2, -2.7, `${((n * length) / 2).toFixed(2)} s`)),
    ];

    let begun = 0;
    let lines: number[][] = [];
    let meters: PeriodMeter[] = [];
    const seen = times.map(() => '');
    const begin = (): void => {
      begun = world.stepCount;
      lines = bobs.map(() => []);
      meters = bobs.map(() => new PeriodMeter());
      for (const [lane, bob] of bobs.entries()) Object.assign(bob, { x: xOf(lane), y: -stretch, vx: 0, vy: 0 });
    };
    begin();

    return {
      world,
      beforeStep(dt) {
        // Two periods of the softest are whole periods of all: they begin again where they are.
        if ((world.stepCount - begun) * dt >= length) begin();
        const time = (world.stepCount - begun) * dt;
        for (const [lane, { y }] of bobs.entries()) {
          lines[lane].push(across(time), y);
          meters[lane].add(time, y);
          if (meters[lane].period > 0) seen[lane] = meters[lane].period.toFixed(2);
        }
      },
      guides: () => [
        ...words,
        ...beforehand,
        ...lines.map((points, tone): Guide => ({ kind: 'curve', points, tone, bold: true })),
        ...seen.map((text, lane) => label(xOf(lane), -4, text)),
        ...bobs.map(({ x, y }, lane): Guide => {
          return { kind: 'curve', points: [x, y, lines[lane].at(-2) ?? 0, y], tone: lane, opacity: 0.3 };
        }),
      ],
      readouts: () => [
        { label: 'Longest period', value: (2 * Math.PI) / omegas[0], unit: 's' },
        { label: 'Shortest', value: (2 * Math.PI) / omegas[3], unit: 's' },
      ],
    };
  },

  check(run) {
    const trial = run();
    const meters = times.map(() => new PeriodMeter());
    trial.run(6.2, () => {
      const { world } = trial.setup;
      for (const [lane, meter] of meters.entries()) meter.add(world.time, world.particleAt(lane).y);
    });
    return times.map((factor, lane) => {
      const share = meters[lane].period / (2 * Math.PI * Math.sqrt(1 / (4 * factor)));
      return { name: `k = ${4 * factor}: period as a share of 2π·√(m/k)`, value: share, atLeast: 0.99, atMost: 1.01 };
    });
  },
};
