/**
 * Free flight with gravity and drag, side by side with a hand-written loop over objects: `node free-flight.ts`.
 * Both do the whole work of a step, in turns within one run; the result is the median of the rounds and the spread from
 * the lower to the upper quartile, in nanoseconds a particle and step, and the ratio of the medians.
 */
import { Drag, forEachParticle, World } from '@mass/core';
import { makeBodies, stepBodies, stepDampedBodies } from './object-loop.ts';

const DT = 1 / 60;
const K1 = 0.1;
const GRAVITY = -9.81;
const ROUNDS = 41;
const PARTICLE_STEPS_A_ROUND = 4e6;

interface Contender {
  readonly name: string;
  readonly step: () => void;
  /** Something that depends on every step, so that none can be left out. */
  readonly result: () => number;
  readonly times: number[];
}

function makeWorld(count: number): World {
  const world = new World({ gravity: { x: 0, y: GRAVITY }, capacity: count });
  for (const { x, y, vx, vy, mass, damping } of makeBodies(count)) world.addParticle({ x, y, vx, vy, mass, damping });
  return world;
}

function contenders(count: number): Contender[] {
  const bodies = makeBodies(count);
  const dampedBodies = makeBodies(count);
  const builtIn = makeWorld(count);
  builtIn.addForce(new Drag({ k1: K1 }));
  const own = makeWorld(count);
  own.addForce(forEachParticle((particle) => particle.applyForce(-K1 * particle.vx, -K1 * particle.vy)));
  const overArrays = makeWorld(count);
  overArrays.addForce({
    apply({ vx, vy, fx, fy }, { slots, count: targets }) {
      for (let t = 0; t < targets; t++) {
        const i = slots[t];
        fx[i] -= K1 * vx[i];
        fy[i] -= K1 * vy[i];
      }
    },
  });
  return [
    { name: 'objects', step: () => stepBodies(bodies, GRAVITY, K1, DT), result: () => bodies[count - 1].y, times: [] },
    {
      name: 'objects, damped and accelerated',
      step: () => stepDampedBodies(dampedBodies, GRAVITY, K1, DT),
      result: () => dampedBodies[count - 1].y,
      times: [],
    },
    { name: 'mass', step: () => builtIn.step(DT), result: () => builtIn.particles.y[count - 1], times: [] },
    {
      name: 'mass, own force over the arrays',
      step: () => overArrays.step(DT),
      result: () => overArrays.particles.y[count - 1],
      times: [],
    },
    {
      name: 'mass, own force per particle',
      step: () => own.step(DT),
      result: () => own.particles.y[count - 1],
      times: [],
    },
  ];
}

function run(count: number): void {
  const all = contenders(count);
  const steps = Math.max(1, Math.round(PARTICLE_STEPS_A_ROUND / count));
  for (let round = -5; round < ROUNDS; round++) {
    for (const contender of all) {
      const start = performance.now();
      for (let s = 0; s < steps; s++) contender.step();
      const nanoseconds = ((performance.now() - start) * 1e6) / (steps * count);
      if (round >= 0) contender.times.push(nanoseconds);
    }
  }
  const reference = quantile(all[0].times, 0.5);
  console.log(`\n${count} particles`);
  for (const { name, times, result } of all) {
    const median = quantile(times, 0.5);
    const spread = `${quantile(times, 0.25).toFixed(2)} to ${quantile(times, 0.75).toFixed(2)}`;
    const difference = Math.abs(result() - all[0].result());
    console.log(
      `  ${name.padEnd(32)} ${median.toFixed(2).padStart(6)} ns (${spread}), ratio ${(median / reference).toFixed(2)}` +
        `, last height differs by ${difference.toExponential(0)} m`,
    );
  }
}

function quantile(values: number[], share: number): number {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.floor(share * (sorted.length - 1))];
}

for (const count of [10_000, 100_000]) run(count);
