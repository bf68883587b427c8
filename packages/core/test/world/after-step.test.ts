import { type Effect, World } from '@mass/core';
import { describe, expect, it } from 'vitest';

describe('after a step', () => {
  it('[E1] an effect that takes itself out does not make the next one be skipped', () => {
    const world = new World();
    const ran: string[] = [];
    const once: Effect = {
      afterStep() {
        ran.push('once');
        world.removeEffect(once);
      },
    };
    world.addEffect(once);
    world.addEffect({ afterStep: () => ran.push('next') });
    world.step(0.1);
    world.step(0.1);
    expect(ran).toEqual(['once', 'next', 'next']);
  });

  it('[E1] an effect that another takes out does not run any more, one that is added runs from the next step on', () => {
    const world = new World();
    const ran: string[] = [];
    const victim: Effect = { afterStep: () => ran.push('victim') };
    const heir: Effect = { afterStep: () => ran.push('heir') };
    world.addEffect({
      afterStep() {
        if (world.stepCount > 1) return;
        world.removeEffect(victim);
        world.addEffect(heir);
      },
    });
    world.addEffect(victim);
    world.step(0.1);
    expect(ran).toEqual([]);
    world.step(0.1);
    expect(ran).toEqual(['heir']);
  });

  it('[W1] a step within a step, from an effect or a listener, is an error, and the outer one stands', () => {
    const world = new World();
    const effect = world.addEffect({ afterStep: () => world.step(0.1) });
    expect(() => world.step(0.1)).toThrow(/World\.step: a step must end before the next/);
    expect(world.stepCount).toBe(1);
    world.removeEffect(effect);
    world.addParticle({ x: 0, y: 0, lifetime: 0.1 });
    world.on('particleExpired', () => world.step(0.1));
    expect(() => world.step(0.1)).toThrow(/a step must end before the next/);
    expect(world.stepCount).toBe(2);
    world.step(0.1);
    expect(world.stepCount).toBe(3);
  });

  it('[E1] what expired is removed, and told of once, even when a listener throws', () => {
    const world = new World();
    let told = 0;
    world.addParticle({ x: 0, y: 0, lifetime: 0.1 });
    world.on('particleExpired', () => {
      told++;
      throw new Error('from the game');
    });
    expect(() => world.step(0.1)).toThrow('from the game');
    expect(world.particleCount).toBe(0);
    world.step(0.1);
    expect(told).toBe(1);
  });

  it('[X1] NaN among the lifetimes is an error that names the particle and leaves the world as it was', () => {
    const world = new World({ gravity: { x: 0, y: -1 } });
    world.addParticle({ x: 0, y: 0 });
    const second = world.addParticle({ x: 0, y: 5, lifetime: 3 });
    world.particles.lifetime[second.slot] = Number.NaN;
    expect(() => world.step(0.1)).toThrow(/lifetime must be a number of seconds; that of particle 1 is NaN/);
    expect([second.y, second.alive, world.stepCount]).toEqual([5, true, 0]);
  });

  it('[X1] gravity cannot be set within a step', () => {
    const world = new World();
    world.addParticle({ x: 0, y: 0 });
    world.addForce({
      apply() {
        world.gravity = { x: 0, y: 1 };
      },
    });
    expect(() => world.step(0.1)).toThrow(/World\.gravity: this must be called between steps/);
    expect(world.gravity).toEqual({ x: 0, y: 0 });
  });

  it.each([[null], [5], [{}], ['']])('[X1] removeForce with %s for a list is an error', (list) => {
    const world = new World();
    const particle = world.addParticle({ x: 0, y: 0 });
    const force = world.addForce({ apply() {} }, [particle]);
    // biome-ignore lint/suspicious/noExplicitAny: what JavaScript may pass
    const act = () => world.removeForce(force, list as any);
    expect(act).toThrow(/World\.removeForce: particles must be a list of particles/);
  });
});
