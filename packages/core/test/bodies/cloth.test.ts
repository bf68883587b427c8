import { box, chain, cloth, type DistanceLink, PointerSpring, substep, World } from '@mass/core';
import { describe, expect, it } from 'vitest';
import { hashOf, run } from '../helpers.ts';
import { worstStrain } from './helpers.ts';

const gravity = { x: 0, y: -9.81 };
const square = { x: 1, y: 2, width: 3, height: 2, columns: 4, rows: 3 };

describe('building', () => {
  it('[B15] joins rows of particles to their neighbours in row and column, about its centre', () => {
    const world = new World();
    const body = world.addBody(cloth({ ...square, mass: 6, radius: 0.1, group: 3 }));
    expect([body.particles.length, body.links.length]).toEqual([12, 4 * 2 + 3 * 3]);
    expect([body.x, body.y, body.mass]).toEqual([1, 2, 6]);
    expect([body.kind, body.closed, body.group]).toEqual(['cloth', false, 3]);
    for (const [place, { x, y, mass, radius }] of body.particles.entries()) {
      expect([x, y, mass, radius]).toEqual([(place % 4) - 0.5, 3 - Math.floor(place / 4), 0.5, 0.1]);
    }
    for (const link of body.links as DistanceLink[]) {
      expect([link.kind, link.minLength, link.maxLength, link.strain]).toEqual(['cable', 0, 1, 0]);
    }
  });

  it('[B15] is of rods where they are asked for, which give and break as they are told', () => {
    const giving = { compliance: 0.01, linkDamping: 0.2, breakForce: 5, breakStrain: 0.5 };
    const body = new World().addBody(cloth({ ...square, kind: 'rod', ...giving }));
    for (const link of body.links as DistanceLink[]) {
      expect([link.kind, link.minLength, link.maxLength]).toEqual(['rod', 1, 1]);
      expect([link.compliance, link.damping, link.breakForce, link.breakStrain]).toEqual([0.01, 0.2, 5, 0.5]);
    }
  });

  it('[B15] is pinned along the top, at the upper corners, or where a function says', () => {
    const pinsOf = (pinned: Parameters<typeof cloth>[0]['pinned']): number[] => {
      const { particles } = new World().addBody(cloth(pinned === undefined ? square : { ...square, pinned }));
      return particles.flatMap(({ mass }, place) => (mass === Infinity ? [place] : []));
    };
    expect(pinsOf(undefined)).toEqual([]);
    expect(pinsOf('top')).toEqual([0, 1, 2, 3]);
    expect(pinsOf('corners')).toEqual([0, 3]);
    expect(pinsOf((column, row) => column === 1 && row === 2)).toEqual([9]);
  });

  it('[B1] the same plan gives the same bits', () => {
    const plan = cloth({ ...square, pinned: 'corners', vx: 1 });
    const [first, second] = [0, 1].map(() => {
      const world = new World({ gravity });
      world.addBody(plan);
      run(world, 60);
      return hashOf(world);
    });
    expect(second).toBe(first);
  });
});

describe('hanging', () => {
  it('[B16] holds its length under its weight', () => {
    const world = new World({ gravity });
    const body = world.addBody(cloth({ ...square, columns: 16, rows: 12, pinned: 'top', vx: 0.5 }));
    let worst = 0;
    for (let n = 0; n < 300; n++) {
      world.step(1 / 60);
      worst = Math.max(worst, worstStrain(body));
    }
    expect(worst).toBeLessThan(0.005);
  });

  it('[B16] gives where its links do: each column by the weight below, C·F', () => {
    const world = new World({ gravity, resolver: substep({ sleepTime: Infinity }) });
    const compliance = 0.02;
    const body = world.addBody(cloth({ ...square, mass: 1.2, pinned: 'top', compliance, linkDamping: 1 }));
    run(world, 1200);
    const weight = (row: number): number => (2 - row) * 0.1 * 9.81;
    const [top, middle] = [0, 1].map((row) => 1 + compliance * weight(row));
    const at = (row: number): number => body.particles[4 * row + 1].y;
    expect(at(0) - at(1)).toBeCloseTo(top, 4);
    expect(at(1) - at(2)).toBeCloseTo(middle, 4);
  });

  it('[B16] tears where it is pulled, and what it hangs on holds', () => {
    const world = new World({ gravity });
    const body = world.addBody(
      cloth({ ...square, columns: 16, rows: 12, pinned: 'top', compliance: 0.01, breakStrain: 0.5 }),
    );
    const links = world.links.length;
    run(world, 60);
    expect(world.links.length).toBe(links);
    const hand = world.addForce(new PointerSpring({ frequency: 30, maxForce: 60 }));
    hand.grab(body.particles[6 * 16 + 8]);
    hand.moveTo(2, -3);
    const broken: unknown[] = [];
    world.on('linkBroke', ({ link }) => broken.push(link));
    run(world, 60);
    expect(broken.length).toBeGreaterThan(2);
    expect(world.links.length).toBe(links - broken.length);
    expect(body.whole).toBe(true);
    for (const particle of body.particles.slice(0, 16)) expect(particle.y).toBe(3);
  });
});

describe('links that give', () => {
  it('[B17] stretch a chain by C·F each; a box has them, too', () => {
    const world = new World({ gravity, resolver: substep({ sleepTime: Infinity }) });
    const from = { x: 0, y: 0 };
    const rope = chain({ from, to: { x: 0, y: -1 }, links: 4, free: 'to', mass: 4, compliance: 1e-3, linkDamping: 1 });
    const body = world.addBody(rope);
    run(world, 3000);
    const tension = [4, 3, 2, 1].map((below) => below * 9.81);
    let y = 0;
    for (const [place, particle] of body.particles.entries()) {
      y -= 0.25 + 1e-3 * tension[place];
      expect(particle.y).toBeCloseTo(y, 4);
    }
    const soft = new World().addBody(box({ x: 0, y: 0, width: 1, height: 1, compliance: 0.5, linkDamping: 0.1 }));
    for (const link of soft.links as DistanceLink[]) expect([link.compliance, link.damping]).toEqual([0.5, 0.1]);
  });
});
