/**
 * The severity resolver beside a plain one that looks at all contacts in each iteration: `node severity.ts`.
 * Two scenes, each a whole step from one saved state, in turns within one run: a row of overlapping discs that fly about,
 * and a settled pile of discs in a box. Restitution 0.2; the table says how much of the limit, twice the contacts, each of
 * the two phases used. Medians and quartiles in milliseconds a step.
 */
import { DiscContacts, HalfPlane, Random, type Resolver, severity, World } from '@mass/core';
import { PlainSeverity } from '../test/resolvers/severity/plain-severity.ts';

const DT = 1 / 60;
const ROUNDS = 21;
const LAYERS = 15;
const LARGEST_PLAIN_ROUNDS = 3_000;
const LARGEST_PLAIN = 10_000;

interface Scene {
  readonly world: World;
  readonly reset: () => void;
}

type Build = (contacts: number, resolver: Resolver) => World;

const chain: Build = (contacts, resolver) => {
  const random = new Random(3);
  const world = new World({ resolver, capacity: contacts + 1 });
  world.addContactGenerator(new DiscContacts());
  for (let i = 0; i <= contacts; i++) {
    const vx = random.between(-1, 1);
    world.addParticle({ x: i * 0.16, y: 0, vx, vy: random.between(-1, 1), radius: 0.1, restitution: 0.2 });
  }
  return world;
};

const pile: Build = (contacts, resolver) => {
  const random = new Random(4);
  const discs = Math.round(contacts / 2.4);
  const columns = Math.ceil(discs / LAYERS);
  const world = new World({ resolver, gravity: { x: 0, y: -9.81 }, capacity: discs });
  world.addContactGenerator(new DiscContacts());
  world.addShape(new HalfPlane());
  world.addShape(new HalfPlane({ normal: { x: 1, y: 0 }, point: { x: -0.1, y: 0 } }));
  world.addShape(new HalfPlane({ normal: { x: -1, y: 0 }, point: { x: columns * 0.2 + 0.1, y: 0 } }));
  for (let i = 0; i < discs; i++) {
    const row = Math.floor(i / columns);
    const x = ((i % columns) + (row % 2) / 2) * 0.2 + 0.05;
    world.addParticle({ x, y: 0.1 + row * 0.175, radius: random.between(0.093, 0.1), mass: 1, restitution: 0.2 });
  }
  return world;
};

/** The state of a scene after some steps, to be stepped from again and again. */
function prepare(build: Build, contacts: number, resolver: Resolver, settle: number): Scene {
  const settled = build(contacts, severity());
  for (let i = 0; i < settle; i++) settled.step(DT);
  const { x, y, vx, vy, count } = settled.particles;
  const state = [x, y, vx, vy].map((array) => array.slice(0, count));
  const world = build(contacts, resolver);
  const reset = () => {
    const { particles } = world;
    particles.x.set(state[0]);
    particles.y.set(state[1]);
    particles.vx.set(state[2]);
    particles.vy.set(state[3]);
  };
  return { world, reset };
}

function time({ world, reset }: Scene): number {
  reset();
  const start = performance.now();
  world.step(DT);
  return performance.now() - start;
}

function sameBits(a: World, b: World): boolean {
  const { count } = a.particles;
  for (const name of ['x', 'y', 'vx', 'vy'] as const) {
    for (let i = 0; i < count; i++) if (!Object.is(a.particles[name][i], b.particles[name][i])) return false;
  }
  return true;
}

function quantile(values: number[], share: number): number {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.floor(share * (sorted.length - 1))];
}

function show(times: number[]): string {
  const spread = `${quantile(times, 0.25).toFixed(2)} to ${quantile(times, 0.75).toFixed(2)}`;
  return `${quantile(times, 0.5).toFixed(2).padStart(9)} (${spread})`;
}

function run(name: string, build: Build, contacts: number, settle: number, alone: boolean): void {
  const fast = prepare(build, contacts, severity(), settle);
  const plainResolver = new PlainSeverity();
  const plain = alone ? undefined : prepare(build, contacts, plainResolver, settle);
  const times: number[] = [];
  const plainTimes: number[] = [];
  const rounds = contacts < 1000 ? ROUNDS * 10 : ROUNDS;
  for (let round = -Math.ceil(20_000 / contacts) - 2; round < rounds; round++) {
    const taken = time(fast);
    if (round >= 0) times.push(taken);
    if (plain && round >= 0 && (contacts <= LARGEST_PLAIN_ROUNDS ? round < ROUNDS : round === 0)) {
      plainTimes.push(time(plain));
    }
  }
  const n = fast.world.contacts.count;
  const perLog = (quantile(times, 0.5) * 1e6) / (n * Math.log2(n));
  const beside = plain
    ? ` | plain ${show(plainTimes)} | ${sameBits(fast.world, plain.world) ? 'same bits' : 'DIFFERENT'} | used ` +
      `${Math.round((50 * plainResolver.velocityIterations) / n)} %, ${Math.round((50 * plainResolver.penetrationIterations) / n)} %`
    : '';
  console.log(
    `${name.padEnd(6)} ${String(n).padStart(6)} contacts | ${show(times)} ms | ${perLog.toFixed(1)} ns/(n log n)${beside}`,
  );
}

const alone = process.argv.includes('--alone');
for (const contacts of [100, 300, 1_000, 3_000, 10_000, 30_000]) {
  run('chain', chain, contacts, 0, alone || contacts > LARGEST_PLAIN);
  run('pile', pile, contacts, 120, alone || contacts > LARGEST_PLAIN);
}
