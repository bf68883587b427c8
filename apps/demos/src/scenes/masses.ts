import { Collisions } from './collisions.ts';
import type { Guide, Scene } from './scene.ts';

const speed = 2;
const yOf = (row: number): number => 1.5 * (2 - row);
const radiusOf = (mass: number): number => 0.28 * Math.cbrt(mass);
const rowsOf = (ratio: number) =>
  [
    [ratio ** 2, 1],
    [ratio, 1],
    [1, 1],
    [1, ratio],
    [1, ratio ** 2],
  ] as const;

export const masses: Scene<'ratio' | 'restitution'> = {
  id: 'masses',
  figure: 'Figure 19',
  title: 'Collisions of different masses',
  summary:
    'In each row a ball flies into one at rest, all at the same speed. The heavy one goes on and drives the light one before it; of two alike the first hands on its motion, all of it at restitution 1; the light one comes back. A ring is where the closed form has a ball at each quarter of a second, the dot in it is where it was. The small dot between them is their centre of mass: the hit does not concern it.',
  lookFor: 'Every dot falls into its ring, and the centre of mass of each pair goes on as if nothing had happened.',
  formula: String.raw`v_a'=\frac{m_a-e\,m_b}{m_a+m_b}\,v,\qquad v_b'=\frac{(1+e)\,m_a}{m_a+m_b}\,v`,
  parameters: {
    ratio: { label: 'Mass ratio from row to row', unit: '×', min: 1.5, max: 3, step: 0.1, value: 2.5 },
    restitution: { label: 'Restitution', min: 0, max: 1, step: 0.05, value: 1 },
  },
  show: { minX: -6.6, maxX: 11.5, minY: -3.9, maxY: 4.3 },
  poster: 1.9,
  style: ({ series, paper, ink }) => ({
    background: paper,
    groups: { 0: { fill: series[1] }, 1: { fill: series[3] } },
    velocities: { color: ink, scale: 0.4 },
  }),

  build({ ratio, restitution }) {
    const rows = rowsOf(ratio);
    const collisions = new Collisions(
      rows.map((pair, row) => {
        const radii = [radiusOf(pair[0]), radiusOf(pair[1])] as const;
        const at = [
          { x: -radii[0], y: yOf(row) },
          { x: radii[1], y: yOf(row) },
        ] as const;
        return { masses: pair, radii, at, v: { x: speed, y: 0 }, restitution };
      }),
      { after: 2.25, rail: 0.17 },
    );
    const words = rows.flatMap(([a, b], row): Guide[] => [
      { kind: 'label', x: -6.5, y: yOf(row), text: `${round(a)} : ${round(b)}`, tone: 'ink', align: 'left' },
      {
        kind: 'label',
        x: 9.8,
        y: yOf(row),
        text: collisions.ways[2 * row].after.x.toFixed(2),
        tone: 0,
        align: 'right',
      },
      {
        kind: 'label',
        x: 11.4,
        y: yOf(row),
        text: collisions.ways[2 * row + 1].after.x.toFixed(2),
        tone: 1,
        align: 'right',
      },
    ]);
    const heads: Guide[] = [
      { kind: 'label', x: -6.5, y: 4, text: 'kg', align: 'left' },
      { kind: 'label', x: 11.4, y: 4, text: 'm/s after', align: 'right' },
      { kind: 'curve', points: [0, -3.7, 0, 3.7], dashed: true, opacity: 0.6 },
    ];
    return {
      world: collisions.world,
      actions: [{ key: 'h', label: 'Hit again', run: () => collisions.restart() }],
      beforeStep: () => collisions.beforeStep(),
      guides: () => [...heads, ...words, ...collisions.guides()],
      readouts: () => collisions.readouts(),
    };
  },

  check: (run) =>
    [1, 0.5, 0].flatMap((restitution) => {
      const ratio = 3;
      const trial = run({ ratio, restitution });
      const { vx } = trial.setup.world.particles;
      trial.run(1.5);
      return rowsOf(ratio).flatMap(([a, b], row) => {
        const exactA = ((a - restitution * b) / (a + b)) * speed;
        const exactB = (((1 + restitution) * a) / (a + b)) * speed;
        const lost = (((1 - restitution ** 2) * a * b) / (a + b) / 2) * speed ** 2;
        const energy = (a * vx[2 * row] ** 2 + b * vx[2 * row + 1] ** 2) / 2;
        const name = `${a} : ${b}, e = ${restitution}`;
        return [
          { name: `${name}: velocity of the first, off`, value: vx[2 * row] - exactA },
          { name: `${name}: velocity of the second, off`, value: vx[2 * row + 1] - exactB },
          { name: `${name}: momentum, off`, value: a * vx[2 * row] + b * vx[2 * row + 1] - a * speed },
          { name: `${name}: energy lost, off`, value: (a * speed ** 2) / 2 - energy - lost },
        ].map((finding) => ({ ...finding, atLeast: -1e-12, atMost: 1e-12 }));
      });
    }),
};

const round = (value: number): string => `${Math.round(value * 100) / 100}`;
