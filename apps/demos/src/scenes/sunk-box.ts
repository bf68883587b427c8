import { box, forEachParticle, type Resolver, severity, World } from '@mass/core';
import { Again } from './again.ts';
import type { Guide, Scene, Values } from './scene.ts';
import { wrongResolver } from './wrong-resolver.ts';

const radius = 2.3;
const size = 1;
const corner = 0.08;

/** A planet that cannot move, its pull, and a box that is sunk into it. */
function planetWith(resolver: Resolver, values: Values<'depth' | 'pull' | 'share'>) {
  const world = new World({ resolver });
  const planet = world.addParticle({ x: 0, y: 0, mass: Infinity, radius });
  const crate = world.addBody(
    box({ x: 0, y: 0, width: size - 2 * corner, height: size - 2 * corner, radius: corner, damping: 0.6, group: 1 }),
  );
  const towards = (x: number, y: number) => {
    const distance = Math.max(1e-9, Math.hypot(x - planet.x, y - planet.y));
    return { distance, nx: (x - planet.x) / distance, ny: (y - planet.y) / distance };
  };
  world.addForce(
    forEachParticle((particle) => {
      const { nx, ny } = towards(particle.x, particle.y);
      particle.applyForce(-nx * values.pull * particle.mass, -ny * values.pull * particle.mass);
    }),
    crate.particles,
  );
  world.addContactGenerator({
    addContacts({ x, y }, contacts) {
      for (const { slot } of crate.particles) {
        const { distance, nx, ny } = towards(x[slot], y[slot]);
        const depth = radius + corner - distance;
        // Of what it is sunk in by, a share is reported at each step.
        if (depth > 0) contacts.add(slot, planet.slot, nx, ny, values.share * depth, 0);
      }
    },
  });
  const sink = (): void => {
    Object.assign(planet, { x: 0, y: 0 });
    const bottom = radius - values.depth;
    for (const [n, each] of crate.particles.entries()) {
      const [across, up] = [n === 0 || n === 3 ? -1 : 1, n < 2 ? corner : size - corner];
      Object.assign(each, { x: across * (size / 2 - corner), y: bottom + up, vx: 0, vy: 0 });
    }
  };
  sink();
  return { world, planet, crate, sink };
}

/** Where the planet was, and where the box will stand. */
function marks({ planet: { x, y } }: ReturnType<typeof planetWith>): Guide[] {
  const half = size / 2;
  const low = Math.sqrt((radius + corner) ** 2 - (half - corner) ** 2) - corner;
  const outline = [-half, low, half, low, half, low + size, -half, low + size, -half, low];
  const guides: Guide[] = [{ kind: 'curve', points: outline, dashed: true, opacity: 0.8 }];
  if (Math.hypot(x, y) < 0.01) return [...guides, { kind: 'circle', x, y, radius: 0.05, filled: true }];
  return [
    ...guides,
    { kind: 'circle', x: 0, y: 0, radius, opacity: 0.6 },
    { kind: 'circle', x: 0, y: 0, radius: 0.05, filled: true, tone: 'accent' },
    { kind: 'arrow', from: { x: 0, y: 0 }, to: { x, y }, tone: 'accent' },
  ];
}

export const sunkBox: Scene<'depth' | 'pull' | 'share'> = {
  id: 'sunk-box',
  figure: 'Figure 15',
  title: 'A box sunk into a planet',
  summary:
    'A small box is found inside a planet. To move both by half of the depth looks fair and is wrong: the planet would jump, and with every later step the box, which its weight presses in a little, would push it on. An immovable body has the inverse mass 0, so its part of the way is 0 and the box goes all of it. Here a share of the depth is resolved in each step, to be seen. Take the box and throw it.',
  lookFor:
    'On the right the box comes up to its place; on the left it is the planet that gives way, and it never stops.',
  formula: String.raw`\Delta\mathbf p_a=\frac{m_a^{-1}}{m_a^{-1}+m_b^{-1}}\,d\,\hat{\mathbf n},\qquad m_b=\infty:\quad\Delta\mathbf p_a=d\,\hat{\mathbf n},\quad\Delta\mathbf p_b=\mathbf 0`,
  parameters: {
    depth: { label: 'Sunk in by', unit: 'm', min: 0.1, max: 1, step: 0.05, value: 0.8 },
    pull: { label: 'Pull of the planet', unit: 'm/s²', min: 1, max: 20, step: 0.5, value: 9, live: true },
    share: { label: 'Resolved in each step', min: 0.02, max: 1, step: 0.01, value: 0.04, live: true },
  },
  show: { minX: -3.6, maxX: 3.6, minY: -3.4, maxY: 4.2 },
  poster: 1.5,
  style: ({ series, paper }) => ({
    background: paper,
    groups: { 0: { fill: series[1], alpha: 0.7 }, 1: { fill: series[2] } },
    bodies: { fillAlpha: 0.9, mark: false, stroke: paper, strokeWidth: 1.5 },
  }),

  build(values) {
    const wrong = planetWith(wrongResolver({ moves: () => [0.5, -0.5] }), values);
    const right = planetWith(severity(), values);
    const again = new Again([wrong.world, right.world], 5, 's', 'Sink again', () => {
      wrong.sink();
      right.sink();
    });
    return {
      world: wrong.world,
      label: 'Half each',
      beside: [{ world: right.world, label: 'By inverse mass', guides: () => marks(right) }],
      actions: [again.action],
      beforeStep: () => again.beforeStep(),
      guides: () => marks(wrong),
      readouts: () => [
        { label: 'Planet moved, half each', value: Math.hypot(wrong.planet.x, wrong.planet.y), unit: 'm' },
        { label: 'by inverse mass', value: Math.hypot(right.planet.x, right.planet.y), unit: 'm' },
      ],
    };
  },

  check(run) {
    const { setup, run: go } = run({ share: 1, pull: 9 });
    const [wrong, right] = [setup.world, setup.beside![0].world];
    go(4.9);
    const { x, y } = right.particles;
    const depths = right.bodies[0].particles.map((each) => radius + corner - Math.hypot(each.x, each.y));
    return [
      { name: 'by inverse mass: how far the planet moved', value: Math.abs(x[0]) + Math.abs(y[0]), atMost: 0 },
      { name: 'by inverse mass: depth that is left', value: Math.max(...depths), atLeast: 0, atMost: 1e-4 },
      { name: 'by inverse mass: how far the box slid', value: Math.abs(right.bodies[0].x), atMost: 1e-3 },
      { name: 'half each: how far the planet moved', value: -wrong.particles.y[0], atLeast: 0.4 },
    ];
  },
};
