// Builds what is published and what is hosted: `dist` of each package, then the gallery.
// `node scripts/build.ts core pixi` builds these packages alone.
import { existsSync, globSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build, type Plugin } from 'esbuild';
import { isMain, root, runBin } from './run.ts';

/** The published packages, in the order of their imports. */
export const packages = ['core', 'canvas2d', 'pixi'] as const;

/** Every import stays an import: one output file for each source file lets a bundler drop whole files that a game does not use. */
const keepImports: Plugin = {
  name: 'keep-imports',
  setup({ onResolve }) {
    onResolve({ filter: /./ }, ({ path, kind }) =>
      kind === 'entry-point'
        ? null
        : { path: path.startsWith('.') ? path.replace(/\.ts$/, '.js') : path, external: true },
    );
  },
};

/** Builds `dist` of one package: JavaScript by esbuild, declarations by tsc. */
export async function buildPackage(name: string): Promise<void> {
  const directory = join(root, 'packages', name);
  const source = join(directory, 'src');
  const dist = join(directory, 'dist');
  if (!existsSync(join(source, 'index.ts')))
    throw new Error(`build: packages/${name} must have a src/index.ts; there is none.`);
  rmSync(dist, { recursive: true, force: true });

  await build({
    entryPoints: globSync('**/*.ts', { cwd: source }).map((file) => join(source, file)),
    outdir: dist,
    outbase: source,
    bundle: true,
    plugins: [keepImports],
    format: 'esm',
    target: 'es2022',
    platform: 'neutral',
    sourcemap: true,
    logLevel: 'warning',
  });

  const tsc = await runBin('typescript', ['-p', join(directory, 'tsconfig.build.json')], { quiet: true, bin: 'tsc' });
  if (tsc.code !== 0) throw new Error(`build: the declarations of packages/${name} were not made.\n${tsc.output}`);
  for (const file of globSync('**/*.d.ts', { cwd: dist })) useJavaScriptSpecifiers(join(dist, file));
}

/** tsc leaves `./x.ts` in declarations as it is, where only `./x.js` means `./x.d.ts` to every tool. */
function useJavaScriptSpecifiers(file: string): void {
  const text = readFileSync(file, 'utf8');
  writeFileSync(file, text.replace(/((?:from|import\(|import)\s*['"]\.{1,2}\/[^'"]*)\.ts(['"])/g, '$1.js$2'));
}

/** Builds the packages and then the gallery. Returns the folder of the gallery's static files. */
export async function buildAll(): Promise<string> {
  for (const name of packages) {
    await buildPackage(name);
    console.log(`built packages/${name}/dist`);
  }
  const gallery = await buildGallery();
  console.log('built apps/demos/dist');
  return gallery;
}

/** Builds the gallery, into `apps/demos/dist` unless another folder is given. Returns the folder of its static files. */
export async function buildGallery(target?: string): Promise<string> {
  const demos: { build(target?: string): Promise<string> } = await import('../apps/demos/build.ts');
  return demos.build(target);
}

if (isMain(import.meta.url)) {
  const names = process.argv.slice(2);
  if (names.length === 0) await buildAll();
  for (const name of names) await buildPackage(name);
}
