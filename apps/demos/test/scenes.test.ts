import { describe, expect, it } from 'vitest';
import { scenes } from '../src/scenes/index.ts';
import { loadScene, sceneIds } from '../src/scenes/load-scene.ts';
import { runner } from '../src/scenes/run.ts';
import { holds, type Setup } from '../src/scenes/scene.ts';
import { goldenHashes } from './golden-hashes.ts';
import { hashWorld } from './hash-world.ts';

const seconds = 5;

/** Every number of every particle of every world, as one hash. */
function hashSetup({ world, beside = [] }: Setup): string {
  return [world, ...beside.map((each) => each.world)].map(hashWorld).join(' ');
}

describe.each(scenes.map((scene) => [scene.id, scene] as const))('scene %s', (id, scene) => {
  const run = runner(scene);

  it('stays finite, and gives the same bits twice and as ever', () => {
    const first = run(scene.light);
    const second = run(scene.light);
    first.run(seconds);
    second.run(seconds);
    const { count, x, y, vx, vy } = first.setup.world.particles;
    expect(count).toBeGreaterThan(0);
    for (let i = 0; i < count; i++) expect(Number.isFinite(x[i] + y[i] + vx[i] + vy[i]), `particle ${i}`).toBe(true);
    expect(hashSetup(second.setup)).toBe(hashSetup(first.setup));
    expect(hashSetup(first.setup), `golden hash of ${id}`).toBe(goldenHashes[id]);
  });

  it('shows what must be seen', () => {
    const findings = scene.check(run);
    expect(findings.length).toBeGreaterThan(0);
    for (const finding of findings) expect(holds(finding), JSON.stringify(finding)).toBe(true);
  });

  it('bears the least and the most of each parameter', () => {
    for (const [name, { min, max, value }] of Object.entries(scene.parameters)) {
      expect(value).toBeGreaterThanOrEqual(min);
      expect(value).toBeLessThanOrEqual(max);
      for (const extreme of [min, max]) expect(() => run({ ...scene.light, [name]: extreme }).run(1)).not.toThrow();
    }
  });

  it('does what each of its actions says, each on a key of its own', () => {
    const { setup, run: go } = run();
    const keys = setup.actions?.map(({ key }) => key) ?? [];
    expect(new Set(keys).size).toBe(keys.length);
    for (const key of keys) expect([' ', '.', 'r', '0'], 'keys of the stage').not.toContain(key);
    for (const action of setup.actions ?? []) expect(() => action.run()).not.toThrow();
    expect(() => go(0.5)).not.toThrow();
  });

  it('says what it is in as many words as there is room for', () => {
    const { minX, maxX, minY, maxY } = scene.show;
    expect(id).toMatch(/^[a-z0-9]+(-[a-z0-9]+)*$/);
    expect(maxX - minX).toBeGreaterThan(0);
    expect(maxY - minY).toBeGreaterThan(0);
    expect(scene.lookFor.length).toBeLessThan(150);
    expect(scene.lookFor).toMatch(/^[^.]*\.$/);
    expect(scene.title.length).toBeLessThan(40);
  });
});

describe('the scenes', () => {
  it('have addresses of their own', () => {
    expect(new Set(scenes.map(({ id }) => id)).size).toBe(scenes.length);
  });

  it('are loaded by their ids; an id that there is not is an error that names those there are', async () => {
    expect(scenes.map(({ id }) => id)).toEqual(sceneIds);
    await expect(loadScene('toString')).rejects.toThrow(/one of projectiles, .*; got toString/);
  });

  it('have a golden hash each, and no hash is left of a scene that is gone', () => {
    expect(Object.keys(goldenHashes).sort()).toEqual(scenes.map(({ id }) => id).sort());
  });
});
