import { Drag, type FireworkRule, Fireworks, Random, World } from '@mass/core';
import type { ParticleStyle } from '@mass/core/view';
import type { Scene } from './scene.ts';

// A rocket, or a shell where the sky was touched, bursts into stars, and each of them bursts into sparks.
const kinds = [
  { name: 'Willow', star: '#ffb64f', spark: '#ffd98f', speed: 15, scatter: 4, life: 2 },
  { name: 'Peony', star: '#ff5d5d', spark: '#ff9d86', speed: 24, scatter: 9, life: 1.2 },
  { name: 'Crown', star: '#a17bff', spark: '#d2b8ff', speed: 30, scatter: 7, life: 1.3 },
  { name: 'Spray', star: '#2fd3c3', spark: '#a5f5e0', speed: 20, scatter: 14, life: 1.1 },
];
const rocketOf = (kind: number): number => 1 + kind;
const shellOf = (kind: number): number => 11 + kind;
const starOf = (kind: number, shape: number): number => 21 + 10 * shape + kind;
const sparkOf = (kind: number): number => 51 + kind;

// Velocities are random in a box: three boxes, a wide one, a square one and a tall one, make a round burst.
const shapes = [
  { x: 1, y: 0.4 },
  { x: 0.76, y: 0.76 },
  { x: 0.4, y: 1 },
];
const within = (x: number, y: number) => ({ minVelocity: { x: -x, y: -y }, maxVelocity: { x, y } });

/** The rules of a kind whose rockets burst into so many stars, and each of those into so many sparks. */
function rulesOf(kind: number, stars: number, sparks: number): FireworkRule[] {
  const { speed, scatter, life } = kinds[kind];
  const rise = { minVelocity: { x: -2, y: 13 }, maxVelocity: { x: 2, y: 17 }, minAge: 1, maxAge: 1.4, damping: 0.9 };
  const payloads = shapes.map((_, shape) => ({ type: starOf(kind, shape), count: Math.ceil(stars / 3) }));
  return [
    { type: rocketOf(kind), ...rise, mass: 50, payloads },
    { type: shellOf(kind), ...within(0, 0), minAge: 0.01, maxAge: 0.02, damping: 1, payloads },
    ...shapes.map(({ x, y }, shape) => ({
      ...{ type: starOf(kind, shape), ...within(speed * x, speed * y), minAge: 0.6, maxAge: 0.95, damping: 0.8 },
      payloads: [{ type: sparkOf(kind), count: sparks }],
    })),
    { type: sparkOf(kind), ...within(scatter, scatter), minAge: 0.3 * life, maxAge: life, damping: 0.5, mass: 0.3 },
  ];
}

export const fireworks: Scene<'sparks' | 'rate'> = {
  id: 'fireworks',
  figure: 'Figure 4',
  title: 'Fireworks',
  summary:
    'A firework is a particle with a type and an age that runs down. When it has run out, the payloads of its type appear in its place, each with its velocity and a random one on top, from the range that its rule gives. The bursts are round because of the air: drag that grows with the square of the speed. Take hold of a rocket or a star and fling it: what it bursts into sets out with the velocity that you gave it.',
  lookFor:
    'Every rocket bursts into stars and every star bursts again, into sparks; touch the sky to set one off there.',
  formula: String.raw`\mathbf{v}_\text{payload}=\mathbf{v}_\text{parent}+\mathbf{r},\qquad r_x\in[\min_x,\max_x],\quad r_y\in[\min_y,\max_y]`,
  parameters: {
    sparks: { label: 'Sparks in the sky', min: 500, max: 10_000, step: 500, value: 3000 },
    rate: { label: 'Rockets', unit: 'a second', min: 0, max: 3, step: 0.25, value: 2, live: true },
  },
  show: { minX: -25, maxX: 25, minY: 0, maxY: 26 },
  poster: 2.2,
  style: () => {
    const groups: Record<number, Partial<ParticleStyle>> = {};
    for (const [kind, { star, spark }] of kinds.entries()) {
      groups[rocketOf(kind)] = {
        fill: '#ffe9c9',
        minRadius: 1.7,
        trail: { seconds: 0.6, width: 2.2, color: '#d08a45' },
      };
      groups[sparkOf(kind)] = {
        fill: spark,
        minRadius: 1,
        fadeOut: 0.8,
        trail: { seconds: 0.25, width: 1.3, points: 4, color: star },
      };
      for (const shape of shapes.keys()) {
        groups[starOf(kind, shape)] = { fill: star, minRadius: 1.6, trail: { seconds: 0.45, width: 2.2, points: 9 } };
      }
    }
    return { background: '#070a18', groups };
  },

  build(values, seed) {
    const world = new World({ gravity: { x: 0, y: -2.5 }, capacity: 16_384 });
    const random = new Random(seed);
    const stars = 24 + Math.round(values.sparks / 80);
    const sparks = Math.max(1, Math.round(values.sparks / stars / 1.9));
    const rules = kinds.flatMap((_, kind) => rulesOf(kind, stars, sparks));
    const show = world.addEffect(new Fireworks({ rules, seed, ground: { minX: -17, maxX: 17, y: 0 } }));
    world.addForce(new Drag({ k2: 0.4 }));
    show.launch(shellOf(2), { x: -7, y: 14 });
    let due = 0.9;
    let launched = 0;

    return {
      world,
      actions: kinds.map(({ name }, kind) => ({
        key: `${kind + 1}`,
        label: name,
        group: starOf(kind, 0),
        run: () => show.launch(rocketOf(kind)),
      })),
      tap: (at) => show.launch(shellOf(random.integer(0, 3)), at),
      beforeStep(dt) {
        for (due += values.rate * dt; due >= 1; due--) show.launch(rocketOf(launched++ % 4));
      },
      readouts: () => [{ label: 'Bursts', value: show.bursts, digits: 0 }],
    };
  },

  check(run) {
    const trial = run({ sparks: 10_000 });
    const { world } = trial.setup;
    const seen = { rockets: 0, stars: 0, sparks: 0, most: 0 };
    trial.run(8, () => {
      const { count, alive, group } = world.particles;
      for (let i = 0; i < count; i++) {
        if (alive[i] === 1) seen[group[i] > 50 ? 'sparks' : group[i] > 20 ? 'stars' : 'rockets']++;
      }
      seen.most = Math.max(seen.most, world.particleCount);
    });
    return [
      { name: 'rockets rise', value: seen.rockets, atLeast: 1 },
      { name: 'rockets burst into stars', value: seen.stars, atLeast: 1 },
      { name: 'stars burst into sparks', value: seen.sparks, atLeast: 1 },
      { name: 'most particles at a time', value: seen.most, atLeast: 9000, atMost: 25_000 },
    ];
  },
};
