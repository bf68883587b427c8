import { Collisions } from './collisions.ts';
import type { Guide, Point, Scene } from './scene.ts';

const speed = 2.4;
const xOf = (column: number): number => 6 * (column - 1);
const radiusOf = (mass: number): number => 0.5 * Math.cbrt(mass);
const rowsOf = (ratio: number) =>
  [
    [ratio, 1],
    [1, 1],
    [1, ratio],
  ] as const;

export const glancingMasses: Scene<'offset' | 'ratio' | 'restitution'> = {
  id: 'glancing-masses',
  figure: 'Figure 20',
  title: 'Glancing collisions',
  summary:
    'The same three pairs, but the ball that flies does not meet the other head on. Only the part of the motion along the contact normal, the line of the two centres, is exchanged; the part across it stays. So the one that was hit always leaves along the normal. Two equal balls part at a right angle when the restitution is 1, as on a billiard table; a heavy ball is hardly turned aside, a light one bounces off.',
  lookFor: 'Equal balls part at a right angle, whatever the offset; every dot falls into the ring of the closed form.',
  formula: String.raw`J=-\frac{(1+e)\,(\mathbf v_a-\mathbf v_b)\cdot\hat{\mathbf n}}{1/m_a+1/m_b},\qquad\mathbf v_a'=\mathbf v_a+\frac{J}{m_a}\,\hat{\mathbf n},\quad\mathbf v_b'=\mathbf v_b-\frac{J}{m_b}\,\hat{\mathbf n}`,
  parameters: {
    offset: { label: 'Offset, over the sum of radii', min: -0.9, max: 0.9, step: 0.05, value: -0.55 },
    ratio: { label: 'Mass ratio', unit: '×', min: 1.5, max: 8, step: 0.5, value: 4 },
    restitution: { label: 'Restitution', min: 0, max: 1, step: 0.05, value: 1 },
  },
  show: { minX: -9, maxX: 9, minY: -4.6, maxY: 5.6 },
  poster: 1.9,
  style: ({ series, paper, ink }) => ({
    background: paper,
    groups: { 0: { fill: series[1] }, 1: { fill: series[3] } },
    velocities: { color: ink, scale: 0.4 },
  }),

  build({ offset, ratio, restitution }) {
    const rows = rowsOf(ratio);
    const collisions = new Collisions(
      rows.map((pair, column) => {
        const radii = [radiusOf(pair[0]), radiusOf(pair[1])] as const;
        const reach = radii[0] + radii[1];
        const x = xOf(column);
        const first = { x: x + offset * reach, y: -reach * Math.sqrt(1 - offset * offset) };
        return { masses: pair, radii, at: [first, { x, y: 0 }] as const, v: { x: 0, y: speed }, restitution };
      }),
      { after: 1.5 },
    );
    const words = rows.flatMap(([a, b], column): Guide[] => {
      const [first, second] = [collisions.ways[2 * column], collisions.ways[2 * column + 1]];
      const dot = first.after.x * second.after.x + first.after.y * second.after.y;
      const speeds = Math.hypot(first.after.x, first.after.y) * Math.hypot(second.after.x, second.after.y);
      const angle = (Math.acos(Math.min(1, dot / speeds)) * 180) / Math.PI;
      return [
        { kind: 'label', x: xOf(column), y: 5.2, text: `${a} : ${b}`, tone: 'ink' },
        { kind: 'label', x: xOf(column), y: -4.2, text: `apart by ${angle.toFixed(0)}°` },
        { kind: 'curve', points: normal(first.at, second.at), dashed: true, opacity: 0.8 },
      ];
    });
    return {
      world: collisions.world,
      actions: [{ key: 'h', label: 'Hit again', run: () => collisions.restart() }],
      beforeStep: () => collisions.beforeStep(),
      guides: () => [...words, ...collisions.guides()],
      readouts: () => collisions.readouts(),
    };
  },

  check: (run) =>
    [-0.55, 0, 0.9].flatMap((offset) =>
      [1, 0.5].flatMap((restitution) => {
        const ratio = 4;
        const trial = run({ offset, ratio, restitution });
        const { vx, vy } = trial.setup.world.particles;
        trial.run(1.5);
        const n = { x: offset, y: -Math.sqrt(1 - offset * offset) };
        return rowsOf(ratio).flatMap(([a, b], column) => {
          const [i, j] = [2 * column, 2 * column + 1];
          const closing = speed * n.y;
          const along = (slot: number): number => vx[slot] * n.x + vy[slot] * n.y;
          const across = (slot: number): number => vx[slot] * n.y - vy[slot] * n.x;
          const name = `${a} : ${b}, offset ${offset}, e = ${restitution}`;
          return [
            {
              name: `${name}: first along the normal, off`,
              value: along(i) - ((a - restitution * b) / (a + b)) * closing,
            },
            {
              name: `${name}: second along the normal, off`,
              value: along(j) - (((1 + restitution) * a) / (a + b)) * closing,
            },
            { name: `${name}: first across it, off`, value: across(i) + speed * n.x },
            { name: `${name}: second across it`, value: across(j) },
            {
              name: `${name}: momentum, off`,
              value: Math.hypot(a * vx[i] + b * vx[j], a * vy[i] + b * vy[j] - a * speed),
            },
          ].map((finding) => ({ ...finding, atLeast: -1e-12, atMost: 1e-12 }));
        });
      }),
    ),
};

/** The line of the two centres, to the far side of the one that is hit. */
const normal = (a: Point, b: Point): number[] => {
  const reach = 3.4 / Math.hypot(b.x - a.x, b.y - a.y);
  return [a.x, a.y, b.x + (b.x - a.x) * reach, b.y + (b.y - a.y) * reach];
};
