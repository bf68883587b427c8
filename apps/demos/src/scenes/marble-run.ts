import { DiscContacts, inRegion, type Particle, Polyline, Segment, Wind, World } from '@mass/core';
import type { Guide, Point, Scene } from './scene.ts';

const g = 9.81;
const radius = 0.2;
const belt = { left: -7, right: 8.55, y: -4 };
const tube = { left: 8.7, right: 9.3, foot: -4, top: 3.1 };
const loop = { x: -2.1, y: 0.7, radius: 1.7 };
/** What the marble is on: the way into the loop, or the way out of it, which cross. */
const [common, into, outOf] = [1, 2, 4];

export const marbleRun: Scene<'count' | 'speed' | 'air'> = {
  id: 'marble-run',
  figure: 'Sub-steps',
  title: 'A marble run',
  summary:
    'Marbles slide without friction down a slope and through a loop: what holds them at its top is their own speed, which is why the slope must be higher than the loop. A conveyor with friction brakes what comes fast and carries all at one speed; a tube of air lifts them to the start again. Slow the air, and they get stuck in the bend; turn it off, and they sink; drag a marble and let it go anywhere.',
  lookFor: 'A marble that comes from high enough stays on the track at the top of the loop.',
  formula: String.raw`\frac{v^2}{r}\ge g\;\Rightarrow\;v_0^2\ge 5\,g\,r`,
  parameters: {
    count: { label: 'Marbles', min: 1, max: 50, step: 1, value: 30 },
    speed: { label: 'Conveyor', unit: 'm/s', min: 0.5, max: 4, step: 0.1, value: 2 },
    air: { label: 'Air in the tube', unit: 'm/s', min: 2, max: 8, step: 0.1, value: 4.2, live: true },
  },
  show: { minX: -10, maxX: 10, minY: -4.6, maxY: 4.4 },
  poster: 3,
  style: ({ series, quiet }) => ({
    particle: { trail: { seconds: 0.25, alpha: 0.35 } },
    groups: Object.fromEntries([1, 2, 3, 4, 6, 7].map((n) => [n, { fill: series[n] }])),
    shapes: { stroke: series[0], strokeWidth: 2.5, fill: quiet, hatch: null },
  }),

  build(values) {
    const { count, speed } = values;
    const world = new World({ gravity: { x: 0, y: -g } });
    world.addContactGenerator(new DiscContacts());
    for (const shape of track()) world.addShape(shape);
    const ends = { a: { x: belt.left, y: belt.y - 0.1 }, b: { x: tube.right, y: belt.y - 0.1 } };
    world.addShape(new Segment({ ...ends, thickness: 0.2, friction: 12, surfaceSpeed: speed }));
    const wind = new Wind({ velocity: { x: 0, y: values.air }, k1: 12 });
    world.addForce(inRegion(wind, ({ x, y }, slot) => x[slot] > (y[slot] < tube.top ? 8.86 : 8.5)));
    const marbles = Array.from({ length: count }, (_, n) => {
      const group = [1, 2, 3, 4, 6, 7][n % 6];
      const marble = world.addParticle({ ...start(n), radius, friction: 0.05, group });
      enter(marble, into);
      return marble;
    });
    let blows = true;
    const toggle = (): void => {
      blows = !blows;
    };
    return {
      world,
      actions: [{ key: 'a', label: 'Air on or off', run: toggle }],
      beforeStep() {
        const air = blows ? values.air : 0;
        if ('y' in wind.velocity && wind.velocity.y !== air) wind.velocity = { x: 0, y: air };
        for (const marble of marbles) follow(marble);
      },
      guides: () => [...beltMarks(world.time * speed), ...(blows ? airMarks(world.time * values.air) : [])],
      readouts: () => [
        {
          label: 'Fastest',
          value: Math.max(...marbles.map(({ vx, vy }) => Math.hypot(vx, vy))),
          unit: 'm/s',
          digits: 1,
        },
      ],
    };
  },

  check(run) {
    const { setup, run: go } = run();
    const { world } = setup;
    const marbles = Array.from({ length: world.particleCount }, (_, slot) => world.particleAt(slot));
    const lastTop = marbles.map(() => 0);
    let [slowest, tops, astray] = [Number.POSITIVE_INFINITY, 0, 0];
    let before: number[] = [];
    go(40, () => {
      for (const [n, { x, y, vx, vy }] of marbles.entries()) {
        if (before[n] < loop.x && x >= loop.x && y > loop.y + 1) {
          slowest = Math.min(slowest, Math.hypot(vx, vy));
          lastTop[n] = world.time;
          tops++;
        }
        if (y < belt.y || Math.abs(x) > 10) astray++;
      }
      before = marbles.map(({ x }) => x);
    });
    const carried = marbles.filter(({ x, y }) => y < belt.y + 0.3 && x > 0 && x < 8).map(({ vx }) => Math.abs(vx - 2));
    const alone = run({ count: 1 });
    const only = alone.setup.world.particleAt(0);
    let highest = belt.y;
    alone.run(12);
    alone.run(8, () => {
      highest = Math.max(highest, only.y);
    });
    return [
      { name: 'passages of the top of the loop in 40 s', value: tops, atLeast: 60 },
      { name: 'marbles that did not pass it, of 30', value: lastTop.filter((time) => time === 0).length, atMost: 2 },
      { name: 'v²/r at the top, in g', value: slowest ** 2 / (loop.radius - radius) / g, atLeast: 1 },
      { name: 'marbles off the track, at any time', value: astray, atMost: 0 },
      { name: 'marbles on the second half of the belt', value: carried.length, atLeast: 1 },
      { name: 'how far their speed is from that of the belt, m/s', value: Math.max(...carried), atMost: 0.3 },
      { name: 'how high a single marble is lifted again, m', value: highest, atLeast: 3.5 },
    ];
  },
};

/** Where a marble starts, and how fast: on the first slope, in the tube, on the belt. */
function start(n: number): { x: number; y: number; vx: number; vy: number } {
  if (n < 5) return { x: 7.8 - 0.6 * n, y: 3.75, vx: -2.5, vy: 0 };
  if (n < 16) return { x: 9, y: tube.top - 0.6 * (n - 5), vx: 0, vy: 2.6 };
  return { x: 8.4 - 0.44 * (n - 16), y: belt.y + radius, vx: 2, vy: 0 };
}

/** Marbles on ways that cross do not meet. */
function enter(marble: Particle, way: number): void {
  marble.category = way * 8;
  marble.mask = common | way | (way * 8);
}

/**
 * At the top of the loop a marble goes over to the way out, and so does one that falls back; beyond it, it is as before. What was thrown
 * off the track begins again.
 */
function follow(marble: Particle): void {
  if (marble.y < belt.y - 2) Object.assign(marble, { x: 7.2, y: 4.2, vx: -2.5, vy: 0 });
  const [x, y] = [marble.x - loop.x, marble.y - loop.y];
  const inLoop = x * x + y * y < loop.radius ** 2 && marble.vx > 0;
  if (inLoop && (y > 0 ? x > 0 : x < 0)) enter(marble, outOf);
  else if (marble.x < -6 || marble.x > 1) enter(marble, into);
}

/** Points along a circle, from one angle to another in degrees, each 2 cm from the next. */
function arc(x: number, y: number, r: number, from: number, to: number): Point[] {
  const [start, way] = [(from * Math.PI) / 180, ((to - from) * Math.PI) / 180];
  const count = Math.ceil((Math.abs(way) * r) / 0.02);
  return Array.from({ length: count + 1 }, (_, n) => {
    const angle = start + (way * n) / count;
    return { x: x + r * Math.cos(angle), y: y + r * Math.sin(angle) };
  });
}

function track(): Polyline[] {
  const low = loop.y - loop.radius;
  const [crest, foot] = [6.5, 0];
  const slope = Array.from({ length: 131 }, (_, n) => {
    const share = n / 130;
    return { x: foot + (crest - foot) * share, y: low + ((3.3 - low) * (1 - Math.cos(Math.PI * share))) / 2 };
  });
  const inside = [...arc(8.4, tube.top, 0.3, 90, 0), { x: tube.left, y: tube.foot + 0.65 }];
  return [
    // From the top of the loop down its left side, up the slope, into the tube; solid from above, as from inside the loop.
    new Polyline({
      points: [...arc(loop.x, loop.y, loop.radius, 90, 270), ...slope, ...inside],
      oneSided: true,
      category: into,
    }),
    new Polyline({
      points: [{ x: -7, y: low - 0.3 }, ...arc(loop.x, loop.y, loop.radius, -90, 90)],
      oneSided: true,
      category: outOf,
    }),
    new Polyline({ points: [{ x: tube.right, y: tube.foot }, ...arc(8.4, tube.top, 0.9, 0, 120)] }),
    new Polyline({ points: [{ x: -5, y: -0.5 }, ...arc(-7.1, -2.42, 1.58, 92, 270)] }),
  ];
}

/** Marks that go with the belt. */
function beltMarks(way: number): Guide[] {
  return Array.from({ length: 25 }, (_, n): Guide => {
    const x = belt.left + ((n * 0.6 + way) % 15);
    return { kind: 'curve', points: [x, belt.y - 0.05, x + 0.12, belt.y - 0.15], tone: 'quiet' };
  });
}

/** Arrowheads that rise with the air. */
function airMarks(way: number): Guide[] {
  return Array.from({ length: 6 }, (_, n): Guide => {
    const y = tube.foot + 0.9 + ((n * 1.1 + way * 0.5) % 6.6);
    const points = [tube.left + 0.15, y - 0.15, 9, y, tube.right - 0.15, y - 0.15];
    return { kind: 'curve', points, tone: 'quiet', opacity: 0.5 };
  });
}
