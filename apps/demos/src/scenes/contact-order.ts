import { type Resolver, type Shape, severity, shapeFinder, World } from '@mass/core';
import { Again } from './again.ts';
import { wear } from './outline.ts';
import type { Guide, Point, Scene, Values } from './scene.ts';
import { wrongResolver } from './wrong-resolver.ts';

/** Little, so that all can be followed. Unit: m/s². */
const gravity = 4;
const half = { x: 1.1, y: 0.4 };
const drop = 1.2;
/** Half the width of each support; the block's lower corners land on their middles. */
const top = 0.55;
const base = -9;

/** A shape to be seen: the contacts are found elsewhere. */
const scenery = (outline: readonly Point[]): Shape & { outline: readonly Point[] } => ({
  outline,
  finder: shapeFinder,
  restitution: 0,
  minX: -4,
  minY: base,
  maxX: 4,
  maxY: 4,
  findSurface() {},
});

/** A block over a level support and a slanting one. It cannot turn: a particle with two corners. */
function blockOver(resolver: Resolver, { tilt, restitution }: Values<'tilt' | 'restitution'>) {
  const world = new World({ resolver });
  const angle = (tilt * Math.PI) / 180;
  const slant = { x: -Math.sin(angle), y: Math.cos(angle) };
  const rise = top * Math.tan(angle);
  const support = (x: number, left: number, right: number): Shape =>
    world.addShape(
      scenery([
        { x: x - top, y: base },
        { x: x + top, y: base },
        { x: x + top, y: right },
        { x: x - top, y: left },
      ]),
    );
  support(-half.x, 0, 0);
  support(half.x, -rise, rise);
  const block = world.addParticle({ x: 0, y: half.y + drop, radius: 0.08, ay: -gravity, group: 1 });
  const corners = [-1, 1, 1, -1].map((side, n) => ({ x: side * half.x, y: n < 2 ? -half.y : half.y }));
  const follow = wear(world, block, corners, 0);
  world.addContactGenerator({
    addContacts({ x, y }, contacts) {
      const { slot } = block;
      const depth = half.y - y[slot];
      const onLevel = x[slot] - half.x < -half.x + top && x[slot] + half.x > -half.x - top;
      if (onLevel && depth > -0.001 && depth < 0.5) contacts.add(slot, -1, 0, 1, depth, restitution);
      // The right corner stands on the slope, on its middle while the block has not slid.
      const deep = depth * slant.y - x[slot] * slant.x;
      if (deep > -0.001 && Math.abs(x[slot]) < top) contacts.add(slot, -1, slant.x, slant.y, deep, restitution);
    },
  });
  const lift = (): void => {
    Object.assign(block, { x: 0, y: half.y + drop, vx: 0, vy: 0 });
    follow();
  };
  return { world, block, slant, lift };
}

type Blocks = ReturnType<typeof blockOver>;

/** The normals of the two contacts, numbered as they are resolved. */
function normals({ slant }: Blocks, first: 'level' | 'slope'): Guide[] {
  const arrow = (x: number, n: Point, order: string): Guide[] => [
    { kind: 'arrow', from: { x, y: 0 }, to: { x: x + 0.9 * n.x, y: 0.9 * n.y }, tone: 'accent' },
    { kind: 'label', x: x + 1.15 * n.x, y: 1.15 * n.y, text: order, tone: 'accent' },
  ];
  const level = arrow(-half.x, { x: 0, y: 1 }, first === 'level' ? '1' : '2');
  return [...level, ...arrow(half.x, slant, first === 'level' ? '2' : '1')];
}

export const contactOrder: Scene<'tilt' | 'restitution'> = {
  id: 'contact-order',
  figure: 'Figure 17',
  title: 'The order of contacts',
  summary:
    'A block lands on two supports at once, one level and one slanting. Contacts are resolved one by one, and each changes what is left for the next. The level one closes faster. Resolved first, it stops the block, and at the slope nothing is left to do. Resolved second, it comes too late: the slope has shoved the block aside. So the most severe goes first. The block is a particle here and does not turn; take it and let it fall.',
  lookFor:
    'The same block, the same two contacts: it lands straight on the right, and is thrown to the side on the left.',
  formula: String.raw`v_{s,i}=\mathbf v\cdot\hat{\mathbf n}_i,\qquad\text{next}=\arg\min_i v_{s,i},\qquad\text{slope first: }\;v_x'=-(1+e)\,v\cos\theta\sin\theta`,
  parameters: {
    tilt: { label: 'Tilt of the right support', unit: '°', min: 10, max: 60, step: 1, value: 35 },
    restitution: { label: 'Restitution', min: 0, max: 0.8, step: 0.05, value: 0.2 },
  },
  show: { minX: -3.1, maxX: 3.1, minY: -1.7, maxY: 3.1 },
  poster: 0.9,
  style: ({ series, paper }) => ({
    background: paper,
    groups: { 0: { fill: series[1] }, 1: { fill: series[1] } },
    bodies: { mark: false, fillAlpha: 0.4, stroke: null },
  }),

  build(values) {
    const wrong = blockOver(wrongResolver({ leastSevereFirst: true }), values);
    const right = blockOver(severity(), values);
    const again = new Again([wrong.world, right.world], 3, 'd', 'Drop again', () => {
      wrong.lift();
      right.lift();
    });
    return {
      world: wrong.world,
      label: 'Least severe first',
      beside: [{ world: right.world, label: 'Most severe first', guides: () => normals(right, 'level') }],
      actions: [again.action],
      beforeStep: () => again.beforeStep(),
      guides: () => normals(wrong, 'slope'),
      readouts: () => [
        { label: 'Sideways, least severe first', value: wrong.block.vx, unit: 'm/s' },
        { label: 'most severe first', value: right.block.vx, unit: 'm/s' },
      ],
    };
  },

  check(run) {
    const trial = run({ tilt: 35, restitution: 0.2 });
    const blocks = [trial.setup.world, trial.setup.beside![0].world].map((world) => world.particleAt(0));
    const sideways = [0, 0];
    let fallen = 0;
    trial.run(2, () => {
      if (blocks[0].vx === 0)
        fallen = -blocks[0].vy + gravity / 60; // as the contacts find it, one step on
      else if (sideways[0] === 0) sideways[0] = blocks[0].vx;
      sideways[1] = Math.max(sideways[1], Math.abs(blocks[1].vx), Math.abs(blocks[1].x));
    });
    const angle = (35 * Math.PI) / 180;
    const exact = -1.2 * fallen * Math.cos(angle) * Math.sin(angle);
    return [
      {
        name: 'least severe first: thrown aside, over (1 + e) v cos θ sin θ',
        value: sideways[0] / exact,
        atLeast: 1 - 1e-12,
        atMost: 1 + 1e-12,
      },
      { name: 'most severe first: sideways', value: sideways[1], atMost: 1e-12 },
    ];
  },
};
