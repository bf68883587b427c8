import { Box, cable, severity, World } from '@mass/core';
import { PendulumMotion } from './pendulum-motion.ts';
import type { Guide, Scene } from './scene.ts';

const g = 9.81;
const degree = Math.PI / 180;
const fewest = 9;
const most = 13;
const round = 30;
const chart = { left: 2.6, right: 6.4, middle: -1.55, half: 0.95 };

export const cablesHanging: Scene<'balls' | 'amplitude'> = {
  id: 'cables-hanging',
  figure: 'Figure 21',
  title: 'Cables: a wave of pendulums',
  summary:
    'Each ball hangs on a cable of its own. The lengths are such that in half a minute the longest swings 9 times, the next 10 times, and so on: they fall out of step, make waves, stand in two rows, and meet again. On the right is the angle of each; the dotted line is the closed form. A cable pulls and never pushes: lift a ball and its cable hangs slack until the ball has fallen as far as it reaches.',
  lookFor: 'The balls swing as a snake that winds, breaks up in rows, and after 30 seconds stands in line again.',
  formula: String.raw`L_n=\frac{g}{(2\pi)^2}\Bigl(\frac{30\text{ s}}{n}\Bigr)^{2}\cdot\bigl(1-\tfrac{\theta_0^2}{8}+\dots\bigr),\qquad|\mathbf p_a-\mathbf p_b|\le L_n`,
  parameters: {
    balls: { label: 'Balls', min: 3, max: 16, step: 1, value: 14 },
    amplitude: { label: 'Let go at', unit: '°', min: 5, max: 60, step: 1, value: 32 },
  },
  show: { minX: -2.2, maxX: 6.8, minY: -3.35, maxY: 0.55 },
  step: 1 / 1920,
  poster: 4.6,
  style: ({ series, paper, quiet }) => {
    const colors = [series[5], series[1], series[4], series[3], series[2]];
    return {
      particle: { stroke: paper, strokeWidth: 1.25, minRadius: 3.5 },
      groups: {
        ...Object.fromEntries(Array.from({ length: 16 }, (_, n) => [n, { fill: mix(colors, n / most) }])),
        16: { fill: quiet },
      },
      links: { cable: { width: 1 } },
      pins: null,
    };
  },

  build({ balls, amplitude }) {
    const world = new World({ resolver: severity(), gravity: { x: 0, y: -g }, capacity: balls + 1 });
    world.addShape(new Box({ centre: { x: 0, y: 0.13 }, width: 2.4, height: 0.26 }));
    const pivot = world.addParticle({ x: 0, y: 0, mass: Infinity, radius: 0.05, group: 16 });
    // All swing alike, each at its own pace.
    const motion = new PendulumMotion(amplitude * degree, 1, g);
    const angleAt = (swings: number, time: number): number =>
      motion.angleAt(((time % round) / round) * swings * motion.period);
    const hung = Array.from({ length: balls }, (_, n) => {
      const swings = fewest + n;
      const length = (round / (swings * motion.period)) ** 2;
      const ball = world.addParticle({ x: 0, y: -length, radius: 0.085, group: Math.min(n, 15) });
      return { ball, swings, length, link: world.addLink(cable(pivot, ball)) };
    });

    let begun = 0;
    const begin = (): void => {
      begun = world.stepCount;
      for (const { ball, length } of hung) {
        const angle = motion.amplitude;
        Object.assign(ball, { x: length * Math.sin(angle), y: -length * Math.cos(angle), vx: 0, vy: 0 });
      }
    };
    begin();

    const angleOf = ({ ball }: (typeof hung)[number]): number => Math.atan2(ball.x, -ball.y);
    const across = (swings: number): number =>
      chart.left + ((chart.right - chart.left) * (swings - fewest)) / (balls - 1);
    const up = (angle: number): number => chart.middle + (chart.half * angle) / motion.amplitude;
    const axis: Guide[] = [
      { kind: 'curve', points: [chart.left, chart.middle, chart.right, chart.middle], opacity: 0.5 },
      { kind: 'label', x: chart.left, y: up(-1.45 * motion.amplitude), text: 'long', align: 'left' },
      { kind: 'label', x: chart.right, y: up(-1.45 * motion.amplitude), text: 'short', align: 'right' },
    ];
    const time = (): number => (world.stepCount - begun) / 1920;
    const off = (): number => {
      const now = time();
      return Math.max(...hung.map((each) => Math.abs(angleOf(each) - angleAt(each.swings, now))));
    };

    return {
      world,
      actions: [{ key: 'a', label: 'Let go again', run: begin }],
      beforeStep() {
        // Once in line again, they begin again where they are; unless somebody has meanwhile taken hold of one.
        if (time() >= round && off() < motion.amplitude / 2) begin();
      },
      guides() {
        const now = time();
        const wave = Array.from({ length: 241 }, (_, n) => fewest + ((balls - 1) * n) / 240);
        return [
          ...axis,
          { kind: 'curve', points: wave.flatMap((n) => [across(n), up(angleAt(n, now))]), dashed: true },
          ...hung.map((each): Guide => {
            const y = up(angleOf(each));
            return { kind: 'circle', x: across(each.swings), y, radius: 0.085, filled: true, tone: each.ball.group };
          }),
        ];
      },
      readouts: () => [
        { label: 'In line again in', value: Math.max(0, round - time()), unit: 's', digits: 0 },
        { label: 'Off the closed form, at most', value: off() / degree, unit: '°', digits: 1 },
        {
          label: 'Longest strain',
          value: 100 * Math.max(...hung.map(({ link }) => link.strain)),
          unit: '%',
          digits: 4,
        },
      ],
    };
  },

  check(run) {
    const trial = run();
    const { world } = trial.setup;
    const balls = Array.from({ length: world.particleCount - 1 }, (_, n) => world.particleAt(n + 1));
    const share = (n: number): number => Math.atan2(balls[n].x, -balls[n].y) / (32 * degree);
    let strain = 0;
    const watch = (): void => {
      for (const { strain: now } of world.links as readonly { strain?: number }[]) strain = Math.max(strain, now ?? 0);
    };
    trial.run(round / 2, watch);
    const rows = balls.map((_, n) => (n % 2 === 0 ? -1 : 1) * share(n));
    trial.run(round / 2 - 1 / 1920, watch);
    const line = balls.map((_, n) => share(n));

    const lifted = run({ balls: 3 });
    const ball = lifted.setup.world.particleAt(1);
    Object.assign(ball, { x: 0, y: -0.5, vx: 0, vy: 0 });
    lifted.run(0.4);
    return [
      { name: 'half way: two rows, the least share of the amplitude', value: Math.min(...rows), atLeast: 0.88 },
      { name: 'after 30 s: one line, the least share of the amplitude', value: Math.min(...line), atLeast: 0.72 },
      { name: 'after 30 s: the most', value: Math.max(...line), atMost: 1 },
      { name: 'strain of any cable at any time', value: strain, atMost: 1e-8 },
      { name: 'a ball that was lifted falls freely, m', value: -0.5 - ball.y, atLeast: 0.78, atMost: 0.79 },
    ];
  },
};

/** A colour between those given, `share` of the way along them. */
function mix(colors: readonly string[], share: number): string {
  const at = Math.min(1, share) * (colors.length - 1);
  const first = Math.min(Math.floor(at), colors.length - 2);
  const channel = (color: string, n: number): number => Number.parseInt(color.slice(1 + 2 * n, 3 + 2 * n), 16);
  const blend = [0, 1, 2].map((n) => {
    const [a, b] = [channel(colors[first], n), channel(colors[first + 1], n)];
    return Math.round(a + (b - a) * (at - first))
      .toString(16)
      .padStart(2, '0');
  });
  return `#${blend.join('')}`;
}
