import { Box, DiscContacts, impact, rod, severity, World } from '@mass/core';
import type { Guide, Scene } from './scene.ts';

const g = 9.81;
const count = 5;
const length = 2.5;
const radius = 0.34;
const steps = 480;
const pinOf = (n: number): number => (n - (count - 1) / 2) * 2 * radius;

export const newtonsCradle: Scene<'raised' | 'angle' | 'restitution' | 'byImpact'> = {
  id: 'newtons-cradle',
  figure: 'Chapter 8',
  title: 'Newton’s cradle',
  summary:
    'Five equal balls on rods, all but touching. The blow runs through the row one contact at a time, the most severe first, within a single step, and as many balls leave as came. Equal masses swap their velocities; with a restitution below one they share them, until all swing together. The last slider hands the same contacts and rods to the impact resolver, which goes from one impact to the next.',
  lookFor: 'As many balls leave on the one side as came in on the other, and the rest stand still.',
  formula: String.raw`v_a'=\frac{(1-c)\,v_a+(1+c)\,v_b}{2},\qquad v_b'=\frac{(1+c)\,v_a+(1-c)\,v_b}{2}`,
  parameters: {
    raised: { label: 'Balls raised', min: 1, max: 4, step: 1, value: 1 },
    angle: { label: 'Raised by', unit: '°', min: 10, max: 60, step: 5, value: 35 },
    restitution: { label: 'Restitution', min: 0.5, max: 1, step: 0.01, value: 1 },
    byImpact: { label: 'Resolver: severity 0, impact 1', min: 0, max: 1, step: 1, value: 0 },
  },
  show: { minX: -4.1, maxX: 4.1, minY: -3.05, maxY: 0.45 },
  step: 1 / steps,
  poster: 1.15,
  style: ({ series, accent, ink }) => ({
    particle: { fill: series[0], stroke: ink, strokeWidth: 1.5 },
    groups: { 1: { fill: accent } },
    links: { rod: { width: 1.5 } },
  }),

  build({ raised, angle, restitution, byImpact }) {
    const world = new World({ gravity: { x: 0, y: -g }, resolver: byImpact === 1 ? impact() : severity() });
    world.addContactGenerator(new DiscContacts());
    world.addShape(new Box({ centre: { x: 0, y: 0.12 }, width: 4.4, height: 0.24 }));
    const balls = Array.from({ length: count }, (_, n) => {
      const x = pinOf(n);
      const ball = world.addParticle({ x, y: -length, radius, restitution, group: n < raised ? 1 : 0 });
      world.addLink(rod({ x, y: 0 }, ball));
      return ball;
    });
    const tilt = (angle * Math.PI) / 180;
    const raise = (): void => {
      for (const [n, ball] of balls.entries()) {
        const at = n < raised ? tilt : 0;
        Object.assign(ball, { x: pinOf(n) - length * Math.sin(at), y: -length * Math.cos(at), vx: 0, vy: 0 });
      }
    };
    raise();
    const most = raised * g * length * (1 - Math.cos(tilt));
    const energy = (): number =>
      balls.reduce((sum, { y, vx, vy }) => sum + (vx * vx + vy * vy) / 2 + g * (y + length), 0) / most;
    const low = -length * Math.cos(tilt);
    const reach = length * Math.sin(tilt);

    return {
      world,
      actions: [{ key: 'a', label: 'Raise again', run: raise }],
      beforeStep() {
        if (energy() < 0.03) raise();
      },
      guides: (): Guide[] => [
        { kind: 'circle', x: pinOf(0) - reach, y: low, radius: radius + 0.05, opacity: 0.5 },
        { kind: 'circle', x: pinOf(count - 1) + reach, y: low, radius: radius + 0.05, opacity: 0.5 },
      ],
      readouts: () => [
        { label: 'Momentum', value: balls.reduce((sum, { vx }) => sum + vx, 0), unit: 'kg·m/s', digits: 2 },
        { label: 'Energy left', value: 100 * energy(), unit: '%', digits: 1 },
      ],
    };
  },

  check: (run) =>
    [0, 1].flatMap((byImpact) =>
      [1, 2, 3, 4].flatMap((raised) => {
        const trial = run({ raised, byImpact });
        const { world } = trial.setup;
        const swings = Array.from({ length: count }, (_, n) => {
          return (): number => (Math.asin((world.particleAt(n).x - pinOf(n)) / length) * 180) / Math.PI;
        });
        // The turning point on the other side, after the first blow, and on this side, after nine more.
        const turn = (side: 1 | -1): number[] => {
          let [best, least] = [-Infinity, [] as number[]];
          trial.run(1.62, () => {
            const now = swings.map((swing) => side * swing());
            const sum = now.reduce((a, b) => a + b);
            if (sum > best) [best, least] = [sum, now];
          });
          return least;
        };
        const name = `${byImpact ? 'impact' : 'severity'}, ${raised} raised`;
        const first = turn(1);
        const after = turn(-1);
        const findings = [first, [...after].reverse()].flatMap((angles, pass) => [
          {
            name: `${name}, blow ${pass + 1}: the least angle of those that leave`,
            value: Math.min(...angles.slice(count - raised)),
            atLeast: 35 * 0.97,
          },
          {
            name: `${name}, blow ${pass + 1}: the most angle of those that stay`,
            value: Math.max(...angles.slice(0, count - raised).map(Math.abs)),
            atMost: 0.3,
          },
        ]);
        return findings;
      }),
    ),
};
