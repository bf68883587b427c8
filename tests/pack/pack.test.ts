// The packages as a stranger gets them: packed, installed into a new project outside the workspace, and used there.
import { cpSync, globSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core';
import { build } from 'esbuild';
import { publint } from 'publint';
import { formatMessage } from 'publint/utils';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { packages } from '../../scripts/build.ts';
import { root, run, runBin } from '../../scripts/run.ts';

const game = mkdtempSync(join(tmpdir(), 'mass-pack-'));
const tarballs = new Map<string, string>();
const windows = process.platform === 'win32';

/** npm and npx are shell scripts on Windows. */
async function shell(command: 'npm' | 'npx', args: string[], cwd: string): Promise<void> {
  const { code, output } = windows
    ? await run('cmd.exe', ['/d', '/s', '/c', command, ...args], { cwd, quiet: true })
    : await run(command, args, { cwd, quiet: true });
  if (code !== 0) throw new Error(`${command} ${args.join(' ')} ended with ${code}\n${output}`);
}

beforeAll(async () => {
  for (const name of packages) {
    // `prepack` builds the package first.
    await shell('npx', ['-y', 'pnpm@12', 'pack', '--pack-destination', game], join(root, 'packages', name));
    const [file] = globSync(`mass-${name}-*.tgz`, { cwd: game });
    tarballs.set(name, join(game, file));
  }
  writeFileSync(join(game, 'package.json'), JSON.stringify({ name: 'game', private: true, type: 'module' }));
  await shell('npm', ['install', '--no-audit', '--no-fund', ...tarballs.values(), 'pixi.js@8'], game);
  for (const file of ['core-game.ts', 'canvas-game.ts', 'pixi-game.ts']) {
    cpSync(join(import.meta.dirname, file), join(game, file));
  }
});

afterAll(() => rmSync(game, { recursive: true, force: true }));

describe.each(packages)('the tarball of @mass/%s', (name) => {
  it('holds what it declares', async () => {
    const data = readFileSync(tarballs.get(name)!);
    const { messages, pkg } = await publint({ pack: { tarball: new Uint8Array(data).buffer }, level: 'suggestion' });
    expect(messages.map((message) => formatMessage(message, pkg!))).toEqual([]);
  });

  it('has types that agree with its code', async () => {
    const tarball = createPackageFromTarballData(new Uint8Array(readFileSync(tarballs.get(name)!)));
    const result = await checkPackage(tarball);
    if (!result.types) throw new Error('no types found');
    // The packages are ES modules for resolvers that read `exports`: the old resolver and require() are not served.
    const problems = result.problems.filter(
      (problem) =>
        problem.kind !== 'CJSResolvesToESM' && !('resolutionKind' in problem && problem.resolutionKind === 'node10'),
    );
    expect(problems).toEqual([]);
  });

  it('has a README, a licence and no source, and asks for nothing of this workspace', () => {
    const installed = join(game, 'node_modules', '@mass', name);
    const files = globSync('**/*', { cwd: installed }).map((file) => file.replaceAll('\\', '/'));
    expect(files).toEqual(expect.arrayContaining(['README.md', 'LICENSE', 'dist/index.js', 'dist/index.d.ts']));
    expect(files.filter((file) => file.endsWith('.ts') && !file.endsWith('.d.ts'))).toEqual([]);
    const {
      dependencies = {},
      peerDependencies = {},
      scripts,
    } = JSON.parse(readFileSync(join(installed, 'package.json'), 'utf8'));
    expect(Object.values({ ...dependencies, ...peerDependencies }).join()).not.toMatch(/workspace:|catalog:/);
    expect(scripts?.install ?? scripts?.postinstall).toBeUndefined();
  });
});

describe.each(['bundler', 'node16'])('under moduleResolution %s', (moduleResolution) => {
  it.each([
    ['core-game.ts', ['es2022']],
    ['canvas-game.ts', ['es2022', 'dom', 'dom.iterable']],
    ['pixi-game.ts', ['es2022', 'dom', 'dom.iterable']],
  ])('%s type-checks', async (file, lib) => {
    const config = join(game, `tsconfig.${file}.${moduleResolution}.json`);
    writeFileSync(
      config,
      JSON.stringify({
        compilerOptions: {
          target: 'es2022',
          module: moduleResolution === 'bundler' ? 'esnext' : 'node16',
          moduleResolution,
          lib,
          types: [],
          strict: true,
          exactOptionalPropertyTypes: true,
          noEmit: true,
          // Our own declarations are checked; those of pixi.js are its own affair.
          skipLibCheck: file === 'pixi-game.ts',
        },
        files: [file],
      }),
    );
    const { code, output } = await runBin('typescript', ['-p', config], { bin: 'tsc', cwd: game, quiet: true });
    expect(output).toBe('');
    expect(code).toBe(0);
  });
});

/** Bundles a file of the game for a platform. Returns the path of the bundle. */
async function bundle(file: string, platform: 'node' | 'browser'): Promise<string> {
  mkdirSync(join(game, 'out'), { recursive: true });
  const outfile = join(game, 'out', file.replace('.ts', '.mjs'));
  const { warnings } = await build({
    entryPoints: [file],
    absWorkingDir: game,
    bundle: true,
    format: 'esm',
    platform,
    outfile,
    logLevel: 'silent',
  });
  expect(warnings).toEqual([]);
  return outfile;
}

/** Runs an expression on what a module of the game exports, in a Node.js of its own. */
async function evaluate(module: string, expression: string): Promise<string> {
  const code = `import * as game from ${JSON.stringify(pathToFileURL(module).href)}; console.log(${expression});`;
  const { output } = await run(process.execPath, ['--input-type=module', '-e', code], { cwd: game, quiet: true });
  return output.trim();
}

it('the game runs, bundled', async () => {
  const distance = Number(await evaluate(await bundle('core-game.ts', 'node'), 'game.play()'));
  // Without drag it would fly 2·vx·vy/g ≈ 29.4 m, and the last metre of fall adds one more.
  expect(distance).toBeGreaterThan(20);
  expect(distance).toBeLessThan(30);
});

it('the game runs without a bundler', async () => {
  const bundled = await evaluate(await bundle('core-game.ts', 'node'), 'game.play()');
  const plain = join(game, 'core-game.mjs');
  await build({ entryPoints: [join(game, 'core-game.ts')], outfile: plain, format: 'esm', logLevel: 'silent' });
  expect(await evaluate(plain, 'game.play()')).toBe(bundled);
});

it.each(['canvas-game.ts', 'pixi-game.ts'] as const)('%s bundles for the browser', async (file) => {
  const code = readFileSync(await bundle(file, 'browser'), 'utf8');
  expect(code.length).toBeGreaterThan(1000);
});
