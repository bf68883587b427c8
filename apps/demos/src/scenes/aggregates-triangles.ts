import { type Body, Box, box, DiscContacts, Segment, severity, triangle, World } from '@mass/core';
import { overlapOf, strainOf } from './aggregates-squares.ts';
import type { Guide, Scene } from './scene.ts';

const g = 9.81;
const hand = { x: -6.2, y: 1 };
const pit = { left: 3.1, right: 6.3, high: 1.5 };
const capacity = 9;
const pause = 1.5;
const steps = 480;

export const aggregatesTriangles: Scene<'turning' | 'speed' | 'side'> = {
  id: 'aggregates-triangles',
  figure: 'Figure 27',
  title: 'Thrown triangles',
  summary:
    'Triangles of three particles and three rods, and now and then a square of four, thrown with a spin. In the air the centre of mass keeps to its parabola as a single particle would, while the corners run in loops round it. The rods of the thesis lose a little of the turning, by the law below, h being the step. In the pit they pile up, circle against circle, without friction. When it is full, its floor opens.',
  lookFor: 'The corners loop, the centre keeps to the dotted parabola, and nothing in the engine knows that it turns.',
  formula: String.raw`\mathbf p_i(t)=\mathbf c(t)+R(\omega t)\,\mathbf r_i,\qquad\omega(t)=\frac{\omega_0}{\sqrt{1+\omega_0^2\,h\,t}}`,
  parameters: {
    turning: { label: 'Turning at the throw', unit: 'rad/s', min: -12, max: 12, step: 1, value: 7, live: true },
    speed: { label: 'Speed of the throw', unit: 'm/s', min: 9.5, max: 10.9, step: 0.1, value: 10.2, live: true },
    side: { label: 'Side', unit: 'm', min: 0.4, max: 0.8, step: 0.05, value: 0.65, live: true },
  },
  show: { minX: -7.2, maxX: 7, minY: -0.9, maxY: 5.5 },
  step: 1 / steps,
  poster: 4.1,
  style: ({ series, accent, paper }) => ({
    particle: { stroke: paper, strokeWidth: 1 },
    groups: {
      0: { fill: series[1] },
      1: { fill: series[4] },
      2: { fill: series[3] },
      9: { fill: accent, trail: { seconds: 1.1, width: 2.5, alpha: 0.5 } },
    },
    bodies: { skeleton: true, fillAlpha: 0.22, strokeWidth: 0, mark: false },
    links: { rod: { width: 2 } },
  }),

  build(values) {
    const world = new World({ gravity: { x: 0, y: -g }, resolver: severity({ iterations: 400 }) });
    world.addContactGenerator(new DiscContacts());
    const { left, right, high } = pit;
    world.addShape(new Segment({ a: { x: left, y: -0.2 }, b: { x: left - 0.25, y: high }, thickness: 0.14 }));
    world.addShape(new Segment({ a: { x: right, y: -0.2 }, b: { x: right + 0.25, y: high + 1.2 }, thickness: 0.14 }));
    const trapdoor = new Box({ centre: { x: (left + right) / 2, y: -0.12 }, width: right - left, height: 0.24 });
    world.addShape(trapdoor);
    let shut = true;
    let thrown: Body | undefined;
    let start = { vx: 0, vy: 0, time: -Infinity, spin: 0 };
    let count = 0;

    function toss(): void {
      if (thrown?.alive) thrown.group = count % 3;
      count++;
      const angle = 0.86;
      start = {
        vx: values.speed * Math.cos(angle),
        vy: values.speed * Math.sin(angle),
        time: world.time,
        spin: values.turning,
      };
      const common = {
        ...hand,
        mass: 3,
        radius: values.side / 3.9,
        restitution: 0.25,
        angle: count,
        angularVelocity: values.turning,
        group: 9,
      };
      thrown = world.addBody(
        count % 3 === 0
          ? box({ ...common, width: values.side, height: values.side })
          : triangle({ ...common, width: values.side }),
      );
      for (const particle of thrown.particles) {
        particle.vx += start.vx;
        particle.vy += start.vy;
      }
    }
    toss();

    const centreAt = (t: number) => ({ x: hand.x + start.vx * t, y: hand.y + start.vy * t - (g * t * t) / 2 });

    return {
      world,
      actions: [{ key: 't', label: 'Throw', run: toss }],
      beforeStep() {
        for (const body of world.bodies) if (body.y < -2) world.removeBody(body);
        const resting = world.bodies.length;
        if (shut && resting >= capacity && world.time - start.time > 2.4) {
          world.removeShape(trapdoor);
          shut = false;
        } else if (!shut && resting === 0) {
          world.addShape(trapdoor);
          shut = true;
        }
        if (shut && resting < capacity && world.time - start.time > pause) toss();
      },
      guides(): Guide[] {
        const points = Array.from({ length: 41 }, (_, n) => centreAt(n / 25)).filter(({ x }) => x < pit.right);
        const guides: Guide[] = [
          { kind: 'curve', points: points.flatMap(({ x, y }) => [x, y]), dashed: true, tone: 'quiet' },
        ];
        if (thrown?.alive) {
          guides.push({ kind: 'circle', x: thrown.x, y: thrown.y, radius: 0.06, filled: true, tone: 'ink' });
        }
        return guides;
      },
      readouts: () => [
        { label: 'Turning', value: thrown?.alive ? thrown.angularVelocity : 0, unit: 'rad/s', digits: 2 },
        { label: 'by the law', value: turningAfter(start.spin, world.time - start.time), unit: 'rad/s', digits: 2 },
        { label: 'Greatest strain', value: 100 * strainOf(world), unit: '%', digits: 3 },
      ],
    };
  },

  check(run) {
    const trial = run();
    const { world } = trial.setup;
    const [first] = world.bodies;
    const corner = first.particles[0];
    const turning = first.angularVelocity;
    const { vx, vy, x: x0, y: y0 } = first;
    let [off, drift, loops, wasAbove] = [0, 0, 0, corner.y > first.y];
    trial.run(1.2, () => {
      const t = world.time;
      off = Math.max(off, Math.hypot(first.x - x0 - vx * t, first.y - y0 - vy * t + (g * t * t) / 2));
      drift = Math.max(drift, Math.abs(first.angularVelocity / turningAfter(turning, t) - 1));
      const above = corner.y > first.y;
      if (above && !wasAbove) loops++;
      wasAbove = above;
    });
    let [strain, overlap, most] = [0, 0, 0];
    trial.run(14, () => {
      strain = Math.max(strain, strainOf(world));
      overlap = Math.max(overlap, overlapOf(world));
      most = Math.max(most, world.bodies.length);
    });
    return [
      { name: 'centre off the parabola, m', value: off, atMost: 0.03 },
      { name: 'turning in the air off its law, as a share', value: drift, atMost: 0.005 },
      { name: 'turning left after 1.2 s, as a share', value: turningAfter(turning, 1.2) / turning, atLeast: 0.94 },
      { name: 'loops of a corner in 1.2 s at 7 rad/s', value: loops, atLeast: 1, atMost: 2 },
      { name: 'bodies at most', value: most, atLeast: capacity, atMost: capacity },
      { name: 'strain of any rod at any time', value: strain, atMost: 0.01 },
      { name: 'overlap of two circles, as a share of the radius', value: overlap, atMost: 0.05 },
    ];
  },
};

/** What the rods leave of a turning after a time: each step takes (ω·h)²/2 of it. Units: rad/s, s. */
function turningAfter(turning: number, time: number): number {
  return turning / Math.sqrt(1 + (turning * turning * time) / steps);
}
