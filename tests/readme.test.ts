// Every TypeScript snippet of the READMEs and the docs compiles, and runs unless its fence says `ts browser`.
import { globSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { root, run, runBin } from '../scripts/run.ts';

interface Snippet {
  readonly name: string;
  readonly file: string;
  readonly browser: boolean;
  readonly code: string;
}

// Inside the workspace, so that `@mass/core` is found as it is by any other file here; `dist` is in no commit.
const directory = join(root, 'dist', 'snippets');

const snippets: Snippet[] = globSync(['*.md', 'docs/**/*.md', 'packages/*/*.md'], { cwd: root })
  .sort()
  .flatMap((document) =>
    [...readFileSync(join(root, document), 'utf8').matchAll(/^```ts( browser)?\r?\n([\s\S]*?)^```/gm)].map(
      ([, browser, code], index) => ({
        name: `${document} #${index + 1}`,
        file: join(directory, `${document.replaceAll(/[\\/.]/g, '-')}-${index + 1}.ts`),
        browser: Boolean(browser),
        code,
      }),
    ),
  );

/** Core compiles without the DOM, and so does a snippet that needs none. */
function project(lib: string[], files: string[]): string {
  return JSON.stringify({
    extends: '../../tsconfig.base.json',
    compilerOptions: { lib, isolatedDeclarations: false, noUnusedLocals: false },
    files,
  });
}

beforeAll(() => {
  rmSync(directory, { recursive: true, force: true });
  mkdirSync(directory, { recursive: true });
  for (const { file, code } of snippets) writeFileSync(file, `${code}\nexport {};\n`);
});

afterAll(() => rmSync(directory, { recursive: true, force: true }));

it('the README has a first snippet', () => {
  expect(snippets.filter(({ name }) => name.startsWith('README.md')).length).toBeGreaterThan(0);
});

describe.each(snippets)('$name', ({ file, browser }) => {
  it('compiles', async () => {
    const config = `${file}.json`;
    writeFileSync(config, project(browser ? ['es2023', 'dom', 'dom.iterable'] : ['es2022'], [file]));
    const { code, output } = await runBin('typescript', ['-p', config], { bin: 'tsc', quiet: true });
    expect(output).toBe('');
    expect(code).toBe(0);
  });

  if (browser) return;
  it('runs', async () => {
    const { code, output } = await run(process.execPath, [file], { quiet: true });
    expect(output).toBe('');
    expect(code).toBe(0);
  });
});
