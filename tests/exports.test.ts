// What a package exports says what it is, and is named one by one. Biome has no such rules yet.
import { globSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { root } from '../scripts/run.ts';

const declaration =
  /^export (?:declare )?(?:default )?(?:abstract )?(?:async )?(?:class|const|function\*?|interface|let|type) (\w+)/;

/** The exported names of a source text that have no doc comment right above them. */
function undocumented(text: string): string[] {
  const lines = text.split('\n');
  const documented = new Set<string>();
  const missing = new Set<string>();
  lines.forEach((line, index) => {
    const name = line.match(declaration)?.[1];
    if (!name) return;
    let above = index - 1;
    while (above >= 0 && /^\s*(\/\/|@)/.test(lines[above])) above--; // a lint comment or a decorator may stand between
    const last = above;
    if (/\*\/\s*$/.test(lines[last] ?? '')) while (above > 0 && !/^\s*\/\*/.test(lines[above])) above--;
    const hasDoc = last >= 0 && /\*\/\s*$/.test(lines[last]) && /^\s*\/\*\*/.test(lines[above]);
    if (hasDoc) documented.add(name);
    else missing.add(name);
  });
  return [...missing].filter((name) => !documented.has(name)); // one comment serves all overloads
}

const files = globSync('packages/*/src/**/*.ts', { cwd: root }).sort();

it('finds a missing comment', () => {
  expect(undocumented('/** A. */\nexport const a = 1;\n\nexport function b(): void {}\n')).toEqual(['b']);
});

it.each(files)('%s documents what it exports', (file) => {
  expect(undocumented(readFileSync(join(root, file), 'utf8'))).toEqual([]);
});

it.each(globSync('packages/*/src/**/index.ts', { cwd: root }).sort())('%s names each export', (file) => {
  expect(readFileSync(join(root, file), 'utf8')).not.toMatch(/^export \* from/m);
});
