import { expect, it } from 'vitest';
import { hashOf } from '../../helpers.ts';
import { energyOf, gas, momentumOf, worstOverlap } from './scenes.ts';

it('[I10] 10 discs in a box keep their energy to 1e-9 over 10 000 impacts and never overlap by 1e-9 of a radius', () => {
  const world = gas(10, 3);
  const before = energyOf(world);
  let impacts = 0;
  let overlap = 0;
  while (impacts < 10_000) {
    world.step(1 / 60);
    impacts += world.contacts.count;
    overlap = Math.max(overlap, worstOverlap(world, 2, 2));
  }
  expect(Math.abs(energyOf(world) / before - 1)).toBeLessThan(1e-9);
  expect(overlap).toBeLessThan(1e-9);
});

it('[I10] neither do they in between: with short steps', () => {
  const world = gas(10, 4);
  const before = energyOf(world);
  let overlap = 0;
  for (let step = 0; step < 20_000; step++) {
    world.step(1 / 5000);
    overlap = Math.max(overlap, worstOverlap(world, 2, 2));
  }
  expect(Math.abs(energyOf(world) / before - 1)).toBeLessThan(1e-9);
  expect(overlap).toBeLessThan(1e-9);
});

it('[I10] 20 discs, with dt from 1/2000 to 1 s', () => {
  for (const dt of [1 / 2000, 1 / 240, 1 / 60, 0.1, 1]) {
    const world = gas(20, 5);
    const before = energyOf(world);
    for (let step = 0; step < 100; step++) {
      world.step(dt);
      expect(worstOverlap(world, 2, 2)).toBeLessThan(1e-9);
    }
    expect(Math.abs(energyOf(world) / before - 1)).toBeLessThan(1e-9);
  }
});

it('[I11] the outcome does not depend on the step, as long as chaos lets two runs be compared', () => {
  const ends = [1 / 30, 1 / 60, 1 / 240].map((dt) => {
    const world = gas(10, 6);
    for (let step = 0; step < Math.round(0.5 / dt); step++) world.step(dt);
    return Array.from(world.particles.x.subarray(0, 10));
  });
  for (let i = 0; i < 10; i++) {
    expect(Math.abs(ends[1][i] - ends[0][i])).toBeLessThan(1e-9);
    expect(Math.abs(ends[2][i] - ends[0][i])).toBeLessThan(1e-9);
  }
});

it('[I11] with its velocities turned round it runs back to where it began', () => {
  const world = gas(10, 7);
  const { x, y, vx, vy } = world.particles;
  const startX = x.slice(0, 10);
  const startY = y.slice(0, 10);
  let impacts = 0;
  for (let step = 0; step < 30; step++) {
    world.step(1 / 60);
    impacts += world.contacts.count;
  }
  expect(impacts).toBeGreaterThan(10);
  for (let i = 0; i < 10; i++) {
    vx[i] = -vx[i];
    vy[i] = -vy[i];
  }
  for (let step = 0; step < 30; step++) world.step(1 / 60);
  for (let i = 0; i < 10; i++) {
    expect(Math.abs(x[i] - startX[i])).toBeLessThan(1e-9);
    expect(Math.abs(y[i] - startY[i])).toBeLessThan(1e-9);
  }
});

it('[I12] the same calls give the same bits', () => {
  const hashes = [gas(20, 8), gas(20, 8)].map((world) => {
    for (let step = 0; step < 300; step++) world.step(1 / 60);
    return hashOf(world);
  });
  expect(hashes[0]).toBe(hashes[1]);
});

it('[I12] nothing is remembered from one step to the next: a world set to the same state goes on with the same bits', () => {
  const worlds = [gas(10, 9), gas(10, 9)];
  for (let step = 0; step < 100; step++) worlds[0].step(1 / 60);
  const { particles: from } = worlds[0];
  const { particles: to } = worlds[1];
  for (const name of ['x', 'y', 'vx', 'vy'] as const) to[name].set(from[name]);
  for (const world of worlds) for (let step = 0; step < 100; step++) world.step(1 / 60);
  for (const name of ['x', 'y', 'vx', 'vy'] as const) {
    expect(Array.from(to[name].subarray(0, 10))).toEqual(Array.from(from[name].subarray(0, 10)));
  }
});

it('[I13] discs alone in space keep their momentum to 1e-12', () => {
  const world = gas(20, 10);
  for (const shape of [...world.shapes]) world.removeShape(shape);
  const before = momentumOf(world);
  for (let step = 0; step < 60; step++) world.step(1 / 60);
  const after = momentumOf(world);
  expect(Math.abs(after.x - before.x)).toBeLessThan(1e-12 * 100);
  expect(Math.abs(after.y - before.y)).toBeLessThan(1e-12 * 100);
});
