import { Box, HalfPlane, type Particle, severity, spring, World } from '@mass/core';
import { Again } from './again.ts';
import { wear } from './outline.ts';
import type { Guide, Point, Scene } from './scene.ts';

/** Length of the hooks from their particles, less the thickness of one: apart by this, they hold. Unit: m. */
const reach = 2.9;
const ceiling = 3.6;
const start = { a: 1.7, b: -0.7 };
const floor = -3.1;

/** A hook: a shank, then most of a circle that is open on one side. `down` is 1, or -1 for one that hangs upside down. */
function hook(down: number): Point[] {
  const points: Point[] = [{ x: 0, y: 0 }];
  for (let n = 0; n <= 28; n++) {
    const angle = Math.PI / 2 - (n / 28) * 1.4 * Math.PI;
    points.push({ x: 0.45 * Math.cos(angle) * down, y: (0.45 * Math.sin(angle) - 1.05) * down });
  }
  return points;
}

/** Two hooks in each other. `sign` is that of the contact's normal against hat(p_a - p_b). */
function pair(sign: 1 | -1, weight: number, restitution: number) {
  const world = new World({ resolver: severity() });
  world.addShape(new HalfPlane({ point: { x: 0, y: floor } }));
  world.addShape(new Box({ centre: { x: 0, y: ceiling + 0.15 }, width: 1.8, height: 0.3 }));
  const a = world.addParticle({ x: 0, y: start.a, mass: 1, radius: 0.2, ay: -9.81, damping: 0.5 });
  const b = world.addParticle({ x: 0, y: start.b, mass: weight, radius: 0.3, ay: -9.81, damping: 0.5, group: 1 });
  const follow = [wear(world, a, hook(1), 0, false), wear(world, b, hook(-1), 1, false)];
  world.addForce(spring({ x: 0, y: ceiling }, a, { stiffness: 60, restLength: 1.7, damping: 0.6 }));
  world.addContactGenerator({
    addContacts({ x, y }, contacts) {
      const dx = x[a.slot] - x[b.slot];
      const dy = y[a.slot] - y[b.slot];
      const distance = Math.sqrt(dx * dx + dy * dy);
      // Farther apart than this the hooks are out of each other.
      if (distance < reach || distance > reach + 0.4) return;
      contacts.add(a.slot, b.slot, (sign * dx) / distance, (sign * dy) / distance, distance - reach, restitution);
    },
  });
  const drop = (): void => {
    Object.assign(a, { x: 0, y: start.a, vx: 0, vy: 0 });
    Object.assign(b, { x: 0, y: start.b, vx: 0, vy: 0 });
    for (const each of follow) each();
  };
  return { world, a, b, drop };
}

export const contactNormal: Scene<'weight' | 'restitution'> = {
  id: 'contact-normal',
  figure: 'Figure 13',
  title: 'The contact normal',
  summary:
    'For discs the contact normal, seen from the first particle, points away from the second: the contact keeps them from coming together. Hooks that hold each other are kept from coming apart, so their normal is the opposite. With the sign of discs the resolver finds the hooks well apart, and even helps them through each other. Cables and rods are such contacts. Take hold of a weight and pull.',
  lookFor: 'The same two hooks and the same fall: only the sign of the normal n decides whether they catch.',
  formula: String.raw`\hat{\mathbf n}=-\frac{\mathbf p_a-\mathbf p_b}{\lvert\mathbf p_a-\mathbf p_b\rvert},\qquad v_s=(\mathbf v_a-\mathbf v_b)\cdot\hat{\mathbf n}`,
  parameters: {
    weight: { label: 'Lower weight', unit: 'kg', min: 0.5, max: 3, step: 0.1, value: 1.5 },
    restitution: { label: 'Restitution', min: 0, max: 0.9, step: 0.05, value: 0.3 },
  },
  show: { minX: -2.9, maxX: 2.9, minY: -3.5, maxY: 5.1 },
  poster: 0.9,
  style: ({ series, paper }) => ({
    background: paper,
    groups: { 0: { fill: series[0] }, 1: { fill: series[1] } },
    links: { 'line-0': { color: series[0], width: 6 }, 'line-1': { color: series[1], width: 6 } },
    pins: null,
  }),

  build({ weight, restitution }) {
    const [wrong, right] = ([1, -1] as const).map((sign) => pair(sign, weight, restitution));
    const again = new Again([wrong.world, right.world], 5, 'd', 'Drop again', () => {
      wrong.drop();
      right.drop();
    });
    return {
      world: wrong.world,
      label: 'n as for discs',
      beside: [{ world: right.world, label: 'n the other way', guides: () => normal(right.a, -1) }],
      actions: [again.action],
      beforeStep: () => again.beforeStep(),
      guides: () => normal(wrong.a, 1),
      readouts: () => [
        { label: 'Apart, n as for discs', value: wrong.a.y - wrong.b.y, unit: 'm' },
        { label: 'n the other way', value: right.a.y - right.b.y, unit: 'm' },
      ],
    };
  },

  check(run) {
    const { setup, run: go } = run();
    const [wrong, right] = [setup.world, setup.beside![0].world];
    const apart = ({ particles: { x, y } }: World): number => Math.hypot(x[0] - x[1], y[0] - y[1]);
    let farthest = 0;
    let kept = Number.NaN;
    go(4.9, () => {
      farthest = Math.max(farthest, apart(right));
      const { count, impulse, normalY } = right.contacts;
      if (count === 0 || !Number.isNaN(kept)) return;
      const { vy, inverseMass } = right.particles;
      const after = (vy[0] - vy[1]) * normalY[0];
      kept = -after / (after - impulse[0] * (inverseMass[0] + inverseMass[1]));
    });
    return [
      { name: 'opposite normal: how far past their reach the hooks came', value: farthest - reach, atMost: 1e-9 },
      { name: 'opposite normal: how far apart they end', value: apart(right), atLeast: reach - 1e-3 },
      {
        name: 'opposite normal: share of the speed given back',
        value: kept,
        atLeast: 0.3 - 1e-12,
        atMost: 0.3 + 1e-12,
      },
      { name: 'normal as for discs: how far apart they end', value: apart(wrong), atLeast: reach + 1 },
    ];
  },
};

/** The normal, as the upper particle sees it, beside the place where the hooks touch. */
function normal({ x, y }: Particle, sign: 1 | -1): Guide[] {
  const from = { x: x + 0.95, y: y - 1.5 };
  const to = { x: from.x, y: from.y + sign };
  return [
    { kind: 'circle', ...from, radius: 0.05, filled: true, tone: 'accent' },
    { kind: 'arrow', from, to, tone: 'accent' },
    { kind: 'label', x: from.x + 0.3, y: from.y + 0.5 * sign, text: 'n', tone: 'accent' },
  ];
}
