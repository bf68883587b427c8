import { type Resolver, severity, World } from '@mass/core';
import { Again } from './again.ts';
import type { Guide, Scene, Values } from './scene.ts';
import { wrongResolver } from './wrong-resolver.ts';

const rows = [2.75, 0.35, -2.75];
const radiusOf = (mass: number): number => (mass === Infinity ? 1.3 : 0.75 * Math.cbrt(mass));

/** As the listing has it: the sign reversed, and both the same way. */
const asPrinted = (a: number, b: number) => [-a / (a + b), -b / (a + b)] as const;

/** Three pairs of discs inside each other. Of what is left of the depth, a share is reported at each step. */
function pairsIn(resolver: Resolver, values: Values<'depth' | 'mass' | 'share'>) {
  const { depth } = values;
  const world = new World({ resolver });
  const pairs = [1, values.mass, Infinity].map((mass, row) => {
    const startA = depth / 2 - radiusOf(1);
    const startB = radiusOf(mass) - depth / 2;
    const shared = { y: rows[row], damping: 0.05 };
    const a = world.addParticle({ ...shared, x: startA, mass: 1, radius: radiusOf(1) });
    const group = mass === Infinity ? 2 : 1;
    const b = world.addParticle({ ...shared, x: startB, mass, radius: radiusOf(mass), group });
    const partB = 1 / (1 + mass); // in inverse proportion to mass
    return {
      a,
      b,
      mass,
      y: rows[row],
      startA,
      startB,
      endA: startA - depth * (1 - partB),
      endB: startB + depth * partB,
    };
  });
  world.addContactGenerator({
    addContacts({ x, y, radius }, contacts) {
      for (const {
        a: { slot: i },
        b: { slot: j },
      } of pairs) {
        const distance = Math.max(1e-9, Math.hypot(x[i] - x[j], y[i] - y[j]));
        const left = radius[i] + radius[j] - distance;
        if (left <= 0) continue;
        contacts.add(i, j, (x[i] - x[j]) / distance, (y[i] - y[j]) / distance, values.share * left, 0);
      }
    },
  });
  return { world, pairs };
}

type Pairs = ReturnType<typeof pairsIn>['pairs'];

/** Where the discs started, where they should end, and how far they are. */
function marks(pairs: Pairs): Guide[] {
  return pairs.flatMap(({ a, b, mass, y, startA, startB, endA, endB }): Guide[] => {
    const tick = (x: number): Guide => ({ kind: 'curve', points: [x, y - 0.24, x, y + 0.24], tone: 'accent' });
    return [
      { kind: 'circle', x: startA, y, radius: a.radius, opacity: 0.7 },
      { kind: 'circle', x: startB, y, radius: b.radius, opacity: 0.7 },
      tick(endA),
      tick(endB),
      { kind: 'arrow', from: { x: startA, y }, to: a, tone: 'ink' },
      { kind: 'arrow', from: { x: startB, y }, to: b, tone: 'ink' },
      { kind: 'label', x: endA, y: y - b.radius - 0.28, text: '1 kg', tone: 'ink' },
      {
        kind: 'label',
        x: endB,
        y: y - b.radius - 0.28,
        text: mass === Infinity ? '∞' : `${mass} kg`,
        tone: 'ink',
      },
    ];
  });
}

export const interpenetration: Scene<'depth' | 'mass' | 'share'> = {
  id: 'interpenetration',
  figure: 'Figure 14',
  title: 'Inside each other',
  summary:
    'Steps are finite, so bodies are found partly inside each other. They are moved apart along the normal by the penetration d, each in inverse proportion to its mass: the light one gives way to the heavy one, and what cannot move does not. It is done within a step; here a share of it each step, to be seen. In the printed listing the sign is reversed, and both go the same way. Take a disc and push it into another.',
  lookFor:
    'On the right each disc stops at its tick; on the left the equal pair runs off as it was, still in each other.',
  formula: String.raw`\Delta\mathbf p_a=\frac{m_b}{m_a+m_b}\,d\,\hat{\mathbf n},\qquad\Delta\mathbf p_b=-\frac{m_a}{m_a+m_b}\,d\,\hat{\mathbf n}`,
  parameters: {
    depth: { label: 'Penetration', unit: 'm', min: 0.2, max: 1.4, step: 0.05, value: 0.9 },
    mass: { label: 'Heavier disc', unit: 'kg', min: 1, max: 6, step: 0.25, value: 4 },
    share: { label: 'Resolved in each step', min: 0.005, max: 1, step: 0.005, value: 0.015, live: true },
  },
  show: { minX: -3.9, maxX: 3.9, minY: -4.6, maxY: 4.5 },
  poster: 1.2,
  style: ({ series, paper, quiet }) => ({
    background: paper,
    particle: { alpha: 0.75 },
    groups: { 0: { fill: series[1] }, 1: { fill: series[4] }, 2: { fill: quiet } },
  }),

  build(values) {
    const wrong = pairsIn(wrongResolver({ moves: asPrinted }), values);
    const right = pairsIn(severity(), values);
    const again = new Again([wrong.world, right.world], 4, 'i', 'Into each other again', () => {
      for (const { a, b, y, startA, startB } of [...wrong.pairs, ...right.pairs]) {
        Object.assign(a, { x: startA, y, vx: 0, vy: 0 });
        Object.assign(b, { x: startB, y, vx: 0, vy: 0 });
      }
    });
    return {
      world: wrong.world,
      label: 'As printed',
      beside: [{ world: right.world, label: 'By inverse mass', guides: () => marks(right.pairs) }],
      actions: [again.action],
      beforeStep: () => again.beforeStep(),
      guides: () => marks(wrong.pairs),
    };
  },

  check(run) {
    const depth = 0.8;
    const { setup, run: go } = run({ depth, mass: 4, share: 1 });
    const startA = depth / 2 - radiusOf(1);
    go(0.1);
    const { x: right } = setup.beside![0].world.particles;
    const exact = [0.5, 0.8, 1].flatMap((part, row) => [
      { name: `pair ${row + 1}: how far the left disc is off`, value: right[2 * row] - startA + part * depth },
      {
        name: `pair ${row + 1}: how far apart they are`,
        value: right[2 * row + 1] - right[2 * row] - [1.5, 0.75 * (1 + Math.cbrt(4)), 2.05][row],
      },
    ]);
    const slow = run({ depth });
    slow.run(3.9);
    const { x: wrong } = slow.setup.world.particles;
    return [
      ...exact.map((finding) => ({ ...finding, atLeast: -1e-12, atMost: 1e-12 })),
      { name: 'as printed, equal pair: depth that is left', value: 1.5 - (wrong[1] - wrong[0]), atLeast: depth - 1e-9 },
      { name: 'as printed, equal pair: how far it ran', value: wrong[0] - startA, atLeast: 2 },
    ];
  },
};
