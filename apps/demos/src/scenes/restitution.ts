import { HalfPlane, impact, type Particle, World } from '@mass/core';
import { Again } from './again.ts';
import type { Guide, Scene } from './scene.ts';

const lanes = 7;
const height = 5;
const period = 8;
const xOf = (lane: number): number => 1.5 * (lane - (lanes - 1) / 2);
/** The smaller the bouncier. */
const radiusOf = (lane: number): number => 0.2 + 0.07 * lane;

export const restitution: Scene<'most' | 'gravity'> = {
  id: 'restitution',
  figure: 'Figure 18',
  title: 'Restitution',
  summary:
    'Seven balls are dropped from one height; the smaller, the bouncier. Restitution is the share e of the closing speed that a hit gives back. Height goes with the square of the speed, so each bounce reaches e² of the height before: after n of them e²ⁿ·h. The lines are these heights, drawn beforehand; a dot is where the foot of a ball was as it turned round. The resolver steps from impact to impact, so no height is lost to the length of a step. Take a ball and throw it.',
  lookFor: 'Every ball turns round just as its foot is on the next line, bounce after bounce.',
  formula: String.raw`v_s'=-e\,v_s\qquad\Rightarrow\qquad h_n=e^{2n}\,h`,
  parameters: {
    most: { label: 'Restitution of the bounciest', min: 0.5, max: 1, step: 0.01, value: 0.94 },
    gravity: { label: 'Gravity', unit: 'm/s²', min: 1, max: 25, step: 0.01, value: 9.81 },
  },
  show: { minX: -5.6, maxX: 5.6, minY: -0.7, maxY: 6.2 },
  poster: 1.5,
  style: ({ series, paper }) => ({
    background: paper,
    groups: Object.fromEntries(Array.from({ length: lanes }, (_, lane) => [lane, { fill: series[lane + 1] }])),
  }),

  build({ most, gravity }) {
    const world = new World({ gravity: { x: 0, y: -gravity }, resolver: impact() });
    world.addShape(new HalfPlane());
    const shares = Array.from({ length: lanes }, (_, lane) => (most * (lanes - lane)) / lanes);
    const balls = shares.map((share, lane) => {
      const radius = radiusOf(lane);
      return world.addParticle({ x: xOf(lane), y: height + radius, radius, restitution: share, group: lane });
    });
    const dashes = shares.flatMap((share, lane): Guide[] => {
      const reach = radiusOf(lane) + 0.12;
      const x = xOf(lane);
      const heights = Array.from({ length: 16 }, (_, n) => height * share ** (2 * n)).filter((h) => h > 0.1);
      return [
        ...heights.map((h): Guide => {
          return { kind: 'curve', points: [x - reach, h, x + reach, h], tone: lane, opacity: 0.75 };
        }),
        { kind: 'label', x, y: -0.32, text: share.toFixed(2), tone: 'ink' },
      ];
    });
    let dots: Guide[] = [];
    const before = balls.map(() => 0);
    const again = new Again([world], period, 'd', 'Drop again', () => {
      dots = [];
      before.fill(0);
      for (const [lane, ball] of balls.entries()) {
        Object.assign(ball, { x: xOf(lane), y: height + ball.radius, vx: 0, vy: 0 });
      }
    });
    return {
      world,
      actions: [again.action],
      beforeStep() {
        again.beforeStep();
        if (again.touched) dots = [];
        for (const [lane, ball] of balls.entries()) {
          if (before[lane] > 0 && ball.vy <= 0) dots.push(turn(ball, gravity));
          before[lane] = ball.vy;
        }
      },
      guides: () => [{ kind: 'label', x: -5.25, y: -0.32, text: 'e', tone: 'ink' }, ...dashes, ...dots],
    };
  },

  check(run) {
    const trial = run();
    const { vy, y, restitution: shares } = trial.setup.world.particles;
    const before = new Float64Array(lanes);
    const bounces = new Int32Array(lanes);
    const worst = new Float64Array(lanes);
    trial.run(period - 0.1, () => {
      for (let lane = 0; lane < lanes; lane++) {
        if (before[lane] > 0 && vy[lane] <= 0) {
          const exact = height * shares[lane] ** (2 * ++bounces[lane]);
          const reached = y[lane] - radiusOf(lane) + vy[lane] ** 2 / (2 * 9.81);
          if (exact > 0.2) worst[lane] = Math.max(worst[lane], Math.abs(reached / exact - 1));
        }
        before[lane] = vy[lane];
      }
    });
    return [
      ...Array.from(worst, (off, lane) => ({
        name: `ball ${lane}: heights over e²ⁿ h, less 1`,
        value: off,
        atMost: 1e-12,
      })),
      { name: 'bounces of the bounciest', value: bounces[0], atLeast: 4 },
      { name: 'bounces of the dullest', value: bounces[lanes - 1], atLeast: 1 },
    ];
  },
};

/** A dot where the lowest point of a ball was when it turned round: found from its speed now. */
function turn({ x, y, vy, radius }: Particle, gravity: number): Guide {
  return { kind: 'circle', x, y: y - radius + vy ** 2 / (2 * gravity), radius: 0.06, filled: true, tone: 'ink' };
}
