import { rod, severity, World } from '@mass/core';
import { PendulumMotion } from './pendulum-motion.ts';
import { PeriodMeter } from './period-meter.ts';
import type { Guide, Scene } from './scene.ts';

const g = 9.81;
const degree = Math.PI / 180;
const chart = { left: 0.2, right: 8.2, top: 2.6, middle: 0.9, half: 1.3, floor: -2.6, height: 1.6 };
const pivot = { x: -3.4, y: 0 };
const swings = 4;

export const pendulum: Scene<'amplitude' | 'length' | 'mass'> = {
  id: 'pendulum',
  figure: 'Figure 24',
  title: 'The pendulum',
  summary:
    'A mass on a rod, and beside it the exact answer: the ring, and the dotted line of its angle, from the elliptic integral, which holds at any amplitude. Wide swings take longer; the mass does not matter. The rod is the one of the thesis, which sets the velocity right after each step: it keeps its length, and loses about ω²·h of the energy each second, h being the step. The lower line shows the loss, the dots beneath it the law.',
  lookFor: 'The mass keeps to its ring, and runs ahead of it only by the little energy that the rod loses.',
  formula: String.raw`\ddot\theta=-\frac gL\sin\theta,\qquad T=4\sqrt{\frac Lg}\;K\Bigl(\sin\frac{\theta_0}2\Bigr)\approx 2\pi\sqrt{\frac Lg}\,\Bigl(1+\frac{\theta_0^2}{16}+\dots\Bigr)`,
  parameters: {
    amplitude: { label: 'Let go at', unit: '°', min: 5, max: 170, step: 5, value: 60 },
    length: { label: 'Length', unit: 'm', min: 0.5, max: 2.5, step: 0.1, value: 2.4 },
    mass: { label: 'Mass', unit: 'kg', min: 0.5, max: 5, step: 0.5, value: 1 },
  },
  show: { minX: -6.3, maxX: 8.6, minY: -3.3, maxY: 3 },
  step: 1 / 960,
  style: ({ accent, series, paper }) => ({
    particle: { fill: accent, stroke: paper, strokeWidth: 1.5 },
    groups: { 1: { fill: series[1] } },
  }),

  build({ amplitude, length, mass }) {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -g } });
    const exact = new PendulumMotion(amplitude * degree, length, g);
    const placeAt = (angle: number) => ({
      x: pivot.x + length * Math.sin(angle),
      y: pivot.y - length * Math.cos(angle),
    });
    const bob = world.addParticle({ ...placeAt(exact.amplitude), mass, radius: 0.17 + 0.06 * Math.sqrt(mass) });
    world.addLink(rod(pivot, bob, { length }));

    const span = swings * exact.period;
    const across = (t: number): number => chart.left + ((chart.right - chart.left) * t) / span;
    const angleUp = (angle: number): number => chart.middle + (chart.half * angle) / exact.amplitude;
    const energyUp = (share: number): number => chart.floor + chart.height * share;
    const most = mass * g * length * (1 - Math.cos(exact.amplitude));
    const energy = (): number =>
      ((bob.vx * bob.vx + bob.vy * bob.vy) * mass) / 2 + mass * g * (bob.y - pivot.y + length);

    const times = Array.from({ length: 193 }, (_, n) => (n / 192) * span);
    const still: Guide[] = [
      { kind: 'circle', ...pivot, radius: length, opacity: 0.25 },
      { kind: 'curve', points: [chart.left, chart.middle, chart.right, chart.middle], opacity: 0.5 },
      { kind: 'curve', points: [chart.left, chart.floor, chart.right, chart.floor], opacity: 0.5 },
      { kind: 'curve', points: [chart.left, energyUp(1), chart.right, energyUp(1)], opacity: 0.5 },
      { kind: 'curve', points: times.flatMap((t) => [across(t), angleUp(exact.angleAt(t))]), dashed: true },
      { kind: 'label', x: chart.left, y: chart.top, text: 'angle', align: 'left', tone: 'accent' },
      { kind: 'label', x: chart.left, y: energyUp(1) - 0.3, text: 'energy', align: 'left', tone: 1 },
      { kind: 'label', x: chart.right, y: energyUp(1) - 0.3, text: '100 %', align: 'right' },
      ...[1, 2, 3, 4].map((n): Guide => {
        const text = `${(n * exact.period).toFixed(2)} s`;
        return { kind: 'label', x: across(n * exact.period), y: chart.floor - 0.35, text, align: 'right' };
      }),
    ];

    let begun = 0;
    let angles: number[] = [];
    let energies: number[] = [];
    let law: number[] = [];
    let meter = new PeriodMeter();
    const begin = (): void => {
      begun = world.stepCount;
      angles = [];
      energies = [];
      law = [];
      meter = new PeriodMeter();
      Object.assign(bob, { ...placeAt(exact.amplitude), vx: 0, vy: 0 });
    };
    begin();

    return {
      world,
      actions: [{ key: 'a', label: 'Let go again', run: begin }],
      beforeStep(dt) {
        if ((world.stepCount - begun) * dt >= span) begin();
        const step = world.stepCount - begun;
        const angle = Math.atan2(bob.x - pivot.x, pivot.y - bob.y);
        meter.add(step * dt, angle);
        if (step % 16 !== 0) return;
        angles.push(across(step * dt), angleUp(angle));
        energies.push(across(step * dt), energyUp(Math.min(1.1, energy() / most)));
        law.push(across(step * dt), energyUp(Math.exp(-exact.omega * exact.omega * dt * step * dt)));
      },
      guides() {
        const ring = placeAt(exact.angleAt((world.stepCount - begun) / 960));
        return [
          ...still,
          { kind: 'curve', points: angles, tone: 'accent' },
          { kind: 'curve', points: law, dashed: true },
          { kind: 'curve', points: energies, tone: 1 },
          { kind: 'curve', points: [pivot.x, pivot.y, ring.x, ring.y], dashed: true, opacity: 0.6 },
          { kind: 'circle', ...ring, radius: bob.radius + 0.1, tone: 'ink', opacity: 0.7 },
        ];
      },
      readouts: () => [
        { label: 'Exact period', value: exact.period, unit: 's', digits: 3 },
        { label: 'measured', value: meter.period, unit: 's', digits: 3 },
        { label: 'Energy left', value: (100 * energy()) / most, unit: '%', digits: 1 },
      ],
    };
  },

  check: (run) =>
    [
      { amplitude: 10, near: 0.999 },
      { amplitude: 30, near: 0.998 },
      { amplitude: 90, near: 0.985 },
    ].flatMap(({ amplitude, near }) => {
      const trial = run({ amplitude, length: 1 });
      const { world } = trial.setup;
      const bob = world.particleAt(0);
      const exact = new PendulumMotion(amplitude * degree, 1, g);
      const energyLeft = (): number =>
        ((bob.vx * bob.vx + bob.vy * bob.vy) / 2 + g * (bob.y + 1)) / (g * (1 - Math.cos(exact.amplitude)));
      const meter = new PeriodMeter();
      let stretch = 0;
      let mostEnergy = 0;
      trial.run(3.5 * exact.period, () => {
        meter.add(world.time, bob.x - pivot.x);
        stretch = Math.max(stretch, Math.abs(Math.hypot(bob.x - pivot.x, bob.y) - 1));
        mostEnergy = Math.max(mostEnergy, energyLeft());
      });
      const law = Math.exp((-g / 960) * world.time);
      return [
        {
          name: `${amplitude}°: period as a share of the exact one`,
          value: meter.period / exact.period,
          atLeast: near,
          atMost: 1,
        },
        { name: `${amplitude}°: change of length, m`, value: stretch, atMost: 2e-9 },
        {
          name: `${amplitude}°: energy left as a share of the law`,
          value: energyLeft() / law,
          atLeast: 0.95,
          atMost: 1.05,
        },
        { name: `${amplitude}°: the most energy, as a share of that at the start`, value: mostEnergy, atMost: 1.001 },
      ];
    }),
};
