// What a game downloads: `size` prints what each program weighs, `size pile` what each file has in one of them.
import { gzipSync } from 'node:zlib';
import { type BuildOptions, build, transform } from 'esbuild';
import { isMain, root } from './run.ts';

/** Programs that a game might be. */
export const programs: Readonly<Record<string, string>> = {
  world: "export { World } from '@mass/core';",
  fireworks: "export { Drag, Fireworks, FixedTimestep, Gravity, World } from '@mass/core';",
  pile: "export { DiscContacts, HalfPlane, World } from '@mass/core';",
  rope: "export { rod, World } from '@mass/core';",
  camera: "export { Camera } from '@mass/core/view';",
  all: "export * from '@mass/core';",
};

const weightOf = (code: string): number => gzipSync(code, { level: 9 }).length;

async function bundle(program: string, options: BuildOptions): Promise<string> {
  const { outputFiles = [] } = await build({
    stdin: { contents: programs[program], resolveDir: root, loader: 'ts' },
    absWorkingDir: root,
    bundle: true,
    format: 'esm',
    target: 'es2022',
    write: false,
    logLevel: 'error',
    ...options,
  });
  return outputFiles[0].text;
}

/** What a program weighs, bundled, minified and gzipped. Unit: bytes. */
export async function sizeOf(program: string): Promise<number> {
  return weightOf(await bundle(program, { minify: true }));
}

/** Each file of a program, and what the program would save without its lines, the heaviest first. Unit: bytes. */
async function filesOf(program: string): Promise<[string, number][]> {
  const code = await bundle(program, { minifySyntax: true, minifyIdentifiers: true });
  const lines = code.replace(/^export \{[^}]*\};$/m, '');
  const [, ...parts] = lines.split(/^\/\/ (.+)$/m); // esbuild writes the name of a file above its lines
  const pieces = await Promise.all(
    parts.map((part, i) =>
      i % 2 === 0 ? part : transform(part, { minifyWhitespace: true }).then((made) => made.code),
    ),
  );
  const whole = weightOf(pieces.filter((_, i) => i % 2 === 1).join(''));
  const saved = (at: number): number => whole - weightOf(pieces.filter((_, i) => i % 2 === 1 && i !== at + 1).join(''));
  return pieces
    .flatMap((name, i): [string, number][] => (i % 2 === 0 ? [[name, saved(i)]] : []))
    .sort(([, a], [, b]) => b - a);
}

if (isMain(import.meta.url)) {
  const [program] = process.argv.slice(2);
  const rows = program
    ? await filesOf(program)
    : await Promise.all(Object.keys(programs).map(async (name) => [name, await sizeOf(name)] as const));
  for (const [name, size] of rows) console.log(`${String(size).padStart(7)}  ${name}`);
}
