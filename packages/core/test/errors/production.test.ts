import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import * as source from '@mass/core';
import { build } from 'esbuild';
import { beforeAll, describe, expect, it } from 'vitest';
import { thrownBy } from '../helpers.ts';

type Core = typeof source;

const entry = fileURLToPath(import.meta.resolve('@mass/core'));
let bundled: Core;
let inputs: string[];

beforeAll(async () => {
  const { outputFiles, metafile } = await build({
    entryPoints: [entry],
    bundle: true,
    minify: true,
    format: 'esm',
    write: false,
    metafile: true,
    define: { 'process.env.NODE_ENV': '"production"', 'import.meta.env.PROD': 'true' },
  });
  inputs = Object.keys(metafile.inputs);
  bundled = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);
});

describe('a production build', () => {
  const mistakes: [string, (core: Core) => unknown][] = [
    ['a negative step', ({ World }) => new World().step(-1)],
    ['a mass of 0', ({ World }) => new World().addParticle({ x: 0, y: 0, mass: 0 })],
    ['a position of NaN', ({ World }) => new World().addParticle({ x: NaN, y: 0 })],
    ['a drag that is negative', ({ Drag }) => new Drag({ k1: -1 })],
    [
      'a removed particle',
      ({ World }) => {
        const particle = new World().addParticle({ x: 0, y: 0 });
        particle.remove();
        return particle.x;
      },
    ],
    [
      'a number that is no longer finite',
      ({ World }) => {
        const world = new World();
        world.addParticle({ x: 0, y: 0 });
        world.particles.vx[0] = NaN;
        world.step(0.1);
      },
    ],
    [
      'a particle that is added within a step',
      ({ World, forEachParticle }) => {
        const world = new World();
        world.addParticle({ x: 0, y: 0 });
        world.addForce(forEachParticle(() => world.spawn(0, 0)));
        world.step(0.1);
      },
    ],
  ];

  it.each(mistakes)('[X7] has the same error for %s', (_what, act) => {
    const error = thrownBy(() => act(source));
    const production = thrownBy(() => act(bundled));
    expect(production.message).toBe(error.message);
    expect(production.constructor).toBe(error.constructor);
  });

  it('[X7] no source file asks what kind of build it is in', () => {
    expect(inputs.length).toBeGreaterThan(20);
    for (const file of inputs) {
      expect(readFileSync(file, 'utf8')).not.toMatch(/NODE_ENV|import\.meta|process\.|__DEV__|console\./);
    }
  });
});
