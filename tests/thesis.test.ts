import { existsSync, readFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { scenes } from '../apps/demos/src/scenes/index.ts';

const page = join(import.meta.dirname, '..', 'docs', 'thesis.md');
const lines = readFileSync(page, 'utf8').split('\n');
const rows = lines.filter((line) => line.startsWith('|') && !/^[|\s-]*$/.test(line));
const links = [...lines.join('\n').matchAll(/\[([^\]]+)\]\(([^)]+)\)/g)].map(([, text, target]) => ({ text, target }));

/** The cells of a row; a bar that is escaped is text. */
function cellsOf(row: string): string[] {
  return row
    .split(/(?<!\\)\|/)
    .slice(1, -1)
    .map((cell) => cell.trim());
}

describe('the page from the thesis to the engine', () => {
  it('names files that exist, and nothing beyond the repository', () => {
    expect(links.length).toBeGreaterThan(200);
    for (const { target } of links) {
      expect(target, 'a relative link').toMatch(/^\.\.\//);
      expect(existsSync(resolve(dirname(page), target)), target).toBe(true);
    }
  });

  it('has no empty cell, and in each row a file, a test and a scene', () => {
    expect(rows.length).toBeGreaterThan(100);
    for (const row of rows) {
      const cells = cellsOf(row);
      for (const cell of cells) expect(cell, row).not.toBe('');
      if (cells.at(-1) === 'scene') continue;
      const [file, test, scene] = cells.slice(-3);
      expect(file, row).toMatch(/packages\/core\/src\//);
      expect(test, row).toMatch(/\.(test|e2e)\.ts\)/);
      expect(scene, row).toMatch(/apps\/demos\/src\/scenes\//);
    }
  });

  it('names scenes that are in the gallery, and all of them', () => {
    const named = links
      .filter(({ target }) => target.includes('/src/scenes/') && !target.endsWith('/index.ts'))
      .map(({ target }) => basename(target, '.ts'));
    const ids = scenes.map(({ id }) => id);
    for (const name of named) expect(ids).toContain(name);
    for (const id of ids) expect(named, 'a scene that the page leaves out').toContain(id);
  });

  it('puts each scene under the figure that it says it is', () => {
    for (const { id, figure } of scenes) {
      const number = /^Figure (\d+)$/.exec(figure)?.[1];
      if (number === undefined) continue;
      const row = rows.map(cellsOf).find((cells) => cells.length === 5 && cells[0] === number);
      expect(row?.[4], figure).toContain(`[${id}]`);
    }
    const figures = rows.map((row) => cellsOf(row)[0]);
    for (let number = 4; number <= 28; number++) expect(figures, 'a figure').toContain(`${number}`);
  });

  it('cites rules that the tests it names hold to', () => {
    const rules = links.filter(({ text }) => /^[A-Z]\d+$/.test(text));
    expect(rules.length).toBeGreaterThan(80);
    for (const { text, target } of rules) {
      const source = readFileSync(resolve(dirname(page), target), 'utf8');
      expect(source.includes(`[${text}]`), `${text} in ${target}`).toBe(true);
    }
  });
});
