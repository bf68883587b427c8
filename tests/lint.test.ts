// The rules that keep the layers apart and the arithmetic exact are only worth something if they fail when they should.
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { root, runBin } from '../scripts/run.ts';

const workspace = mkdtempSync(join(tmpdir(), 'mass-lint-'));

beforeAll(() => {
  for (const file of [
    'biome.json',
    '.gitignore',
    'lint',
    'packages/core/package.json',
    'packages/canvas2d/package.json',
  ]) {
    cpSync(join(root, file), join(workspace, file), { recursive: true });
  }
});

afterAll(() => rmSync(workspace, { recursive: true, force: true }));

/** The diagnostics for one file of source, with other files beside it. */
async function lint(files: Record<string, string>): Promise<string> {
  for (const [file, text] of Object.entries(files)) {
    mkdirSync(dirname(join(workspace, file)), { recursive: true });
    writeFileSync(join(workspace, file), text);
  }
  const { output } = await runBin('@biomejs/biome', ['lint', ...Object.keys(files)], { cwd: workspace, quiet: true });
  return output;
}

const inexact = [
  'sin',
  'cos',
  'tan',
  'atan2',
  'asin',
  'acos',
  'exp',
  'log',
  'log2',
  'log10',
  'pow',
  'hypot',
  'cbrt',
  'random',
];

it.each(inexact)('the step cannot call Math.%s', async (name) => {
  const file = 'packages/core/src/forces/inexact.ts';
  expect(await lint({ [file]: `export const f = (x: number): number => Math.${name}(x, x);\n` })).toContain(
    'lint/nursery/noJsRestrictedProperties',
  );
});

it('the step cannot take a function out of Math', async () => {
  const output = await lint({ 'packages/core/src/world/inexact.ts': 'const { sin } = Math;\nexport const f = sin;\n' });
  expect(output).toContain('lint/nursery/noJsRestrictedProperties');
});

it.each(['x ** 2', '(x * x) ** 0.5', '(x **= 2)'])('the step cannot use %s', async (power) => {
  const output = await lint({
    'packages/core/src/forces/power.ts': `export const f = (x: number): number => ${power};\n`,
  });
  expect(output).toContain('The last bit of a power is left to the engine');
});

it.each(['Date', 'performance'])('the step cannot read %s', async (clock) => {
  const output = await lint({ 'packages/core/src/world/clock.ts': `export const f = (): number => ${clock}.now();\n` });
  expect(output).toContain('lint/style/noRestrictedGlobals');
});

it('the view may use what drawing needs', async () => {
  const output = await lint({
    'packages/core/src/view/angle.ts': 'export const f = (x: number): number => Math.sin(x) ** 2;\n',
  });
  expect(output).toContain('No fixes applied');
  expect(output).not.toContain('━');
});

it('an import cycle is an error, type imports counted', async () => {
  const output = await lint({
    'packages/core/src/math/a.ts': "import type { B } from './b.ts';\nexport type A = B | 1;\n",
    'packages/core/src/math/b.ts': "import type { A } from './a.ts';\nexport type B = A | 2;\n",
  });
  expect(output).toContain('lint/suspicious/noImportCycles');
});

it.each([
  ['packages/core/src/world/up.ts', '@mass/canvas2d'],
  ['packages/core/src/world/outside.ts', 'some-package'],
  ['packages/core/src/world/node.ts', 'node:fs'],
  ['packages/core/src/world/view.ts', '../view/camera.ts'],
  ['packages/core/src/math/up.ts', '../particles/particle.ts'],
  ['packages/core/src/forces/up.ts', '../world/world.ts'],
  ['packages/core/src/effects/up.ts', '../world/world.ts'],
  ['packages/canvas2d/src/sideways.ts', '@mass/pixi'],
  ['packages/canvas2d/src/deep.ts', '../../core/src/world/world.ts'],
])('%s cannot import %s', async (file, specifier) => {
  const output = await lint({ [file]: `import { something } from '${specifier}';\nexport const other = something;\n` });
  expect(output).toContain('lint/style/noRestrictedImports');
});

it.each([
  ["import { CanvasRenderer } from '@mass/canvas2d';\nexport const r = CanvasRenderer;\n", 'noRestrictedImports'],
  ["import { Stage } from '../stage/stage.ts';\nexport const s = Stage;\n", 'noRestrictedImports'],
  ['export const x = Math.random();\n', 'noJsRestrictedProperties'],
  ['export const now = Date.now();\n', 'noRestrictedGlobals'],
])('a scene knows the core alone: not %j', async (source, rule) => {
  expect(await lint({ 'apps/demos/src/scenes/worldly.ts': source })).toContain(rule);
});

it('a scene may use the core, and what other scenes share', async () => {
  const output = await lint({
    'apps/demos/src/scenes/game/part.ts':
      "import { World } from '@mass/core';\nimport type { Point } from '../scene.ts';\nexport const f = (at: Point): World => new World({ gravity: at });\n",
  });
  expect(output).not.toContain('━');
});

it('a scene that touches the page does not type-check', async () => {
  const project = JSON.parse(
    readFileSync(join(root, 'apps/demos/src/scenes/tsconfig.json'), 'utf8').replace(/^\s*\/\/.*$/gm, ''),
  );
  const folder = mkdtempSync(join(root, 'apps/demos/node_modules/.scenes-'));
  try {
    const { compilerOptions } = project;
    const file = { extends: join(root, 'tsconfig.base.json'), compilerOptions, files: ['scene.ts'] };
    writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify(file));
    writeFileSync(join(folder, 'scene.ts'), 'export const title: string = document.title;\n');
    const { code, output } = await runBin('typescript', ['-p', folder], { bin: 'tsc', quiet: true });
    expect(output).toContain("Cannot find name 'document'");
    expect(code).not.toBe(0);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
