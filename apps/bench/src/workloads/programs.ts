import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import type { Workload } from '../workload.ts';

const TIME_IMPORT = `const from = performance.now();
await import(process.argv[1]);
console.log(performance.now() - from);
process.exit(0);`;
const STARTS = 5;

/** Bundles the program of an engine, minified, and tells the file. */
async function bundle(engine: string): Promise<string> {
  const program = join(import.meta.dirname, `../programs/${engine}.ts`);
  const { build } = await import('esbuild');
  const outfile = join(import.meta.dirname, `../../dist/${engine}.mjs`);
  const format = { bundle: true, minify: true, format: 'esm', target: 'es2022', legalComments: 'none' } as const;
  await build({ entryPoints: [program], outfile, ...format, logLevel: 'error' });
  return outfile;
}

export const programs: Workload = {
  id: 'programs',
  title: 'Size and start of a small program',
  about: `A program that drops a few discs into a box and takes one step, written as each engine's documentation would have it
(\`src/programs\`), bundled and minified by esbuild. Size: after gzip, of engines that come in one file. Start: from its import to the end of its first step in a new
Node.js, the least of ${STARTS}.`,
  needs: ['collide'],
  measures: {
    size: { title: 'size', unit: 'kB', better: 'less', target: { limit: 10 } },
    start: { title: 'start', unit: 'ms', better: 'less', target: { limit: 5 } },
  },
  engines: ['mass', 'planck', 'p2-es', 'phaser-box2d', 'matter-js', 'nape-js', 'party', 'rapier2d-compat'],
  cases: [{ name: 'a few discs', n: 3, quick: true }],
  async run({ engine }) {
    const file = await bundle(engine.id);
    const starts = Array.from({ length: STARTS }, () => {
      const args = ['--input-type=module', '--eval', TIME_IMPORT, pathToFileURL(file).href];
      const output = execFileSync(process.execPath, args, { encoding: 'utf8' });
      return Number(output.trim().split('\n').at(-1));
    });
    return { size: gzipSync(readFileSync(file), { level: 9 }).length / 1000, start: Math.min(...starts) };
  },
};
