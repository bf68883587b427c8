// Builds the gallery: static files in `dist` that work from any sub-path. `node build.ts` from this folder.
import { cpSync, mkdirSync, mkdtempSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build as bundle, type Metafile } from 'esbuild';
import { directImports } from './direct-imports.ts';
import { benchmarksPage } from './pages/benchmarks-page.ts';
import { hero } from './pages/chapters.ts';
import type { Assets } from './pages/layout.ts';
import { listPage } from './pages/list-page.ts';
import { scenePage } from './pages/scene-page.ts';
import { scenes } from './src/scenes/index.ts';

const here = dirname(fileURLToPath(import.meta.url));
const dist = join(here, 'dist');

/** The entries of the bundle: what a page loads by name. Every other chunk is loaded by these, the code of a scene among them. */
const entries = {
  list: 'src/gallery/list-page.ts',
  scene: 'src/gallery/scene-page.ts',
  benchmarks: 'src/gallery/benchmarks-page.ts',
  style: 'src/styles/gallery.css',
  formula: 'src/styles/formula.css',
};

/**
 * Builds the gallery into a folder of its own, `dist` unless it is given, and returns its path. Everything is made elsewhere
 * first: a build that fails leaves the last one as it was, a server never sees half of one, and two builds at once do not meet.
 */
export async function build(target: string = dist): Promise<string> {
  mkdirSync(join(here, 'node_modules'), { recursive: true });
  const folder = mkdtempSync(join(here, 'node_modules', '.gallery-'));
  const next = join(folder, 'next');
  try {
    await buildInto(next);
    rmSync(target, { recursive: true, force: true });
    move(next, target);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
  return target;
}

async function buildInto(next: string): Promise<void> {
  const { metafile } = await bundle({
    absWorkingDir: here,
    entryPoints: entries,
    outdir: next,
    entryNames: 'assets/[name]-[hash]',
    chunkNames: 'assets/chunk-[hash]',
    assetNames: 'assets/[name]-[hash]',
    bundle: true,
    splitting: true,
    plugins: [directImports],
    format: 'esm',
    target: 'es2022',
    minify: true,
    sourcemap: 'linked',
    // KaTeX offers each font three times; every browser that runs the gallery takes the first.
    loader: { '.woff2': 'file', '.woff': 'empty', '.ttf': 'empty' },
    metafile: true,
    logLevel: 'warning',
  });

  const write = (file: string, text: string): void => {
    const path = join(next, file);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, text);
  };
  const assetsOf = (script: 'list' | 'scene', id: string, toRoot: string): Assets =>
    findAssets(metafile, next, [entries[script], `src/scenes/${id}.ts`], toRoot);
  write('benchmarks/index.html', benchmarksPage(findAssets(metafile, next, [entries.benchmarks], '../')));
  write('index.html', listPage(scenes, assetsOf('list', hero.id, '')));
  for (const [index, scene] of scenes.entries()) {
    const neighbours = { previous: scenes[index - 1], next: scenes[index + 1] };
    const page = await scenePage(scene, neighbours, assetsOf('scene', scene.id, '../../'));
    write(`scenes/${scene.id}/index.html`, page);
  }
  // GitHub Pages hides files whose name begins with an underscore unless told not to; other hosts do not mind the file.
  write('.nojekyll', '');
}

/** Moves a folder, to another disk as well. */
function move(from: string, to: string): void {
  try {
    renameSync(from, to);
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code !== 'EXDEV') throw error;
    cpSync(from, to, { recursive: true });
  }
}

/**
 * The addresses of what a page loads, its script and the scene that moves first, if one does, seen from the page: `toRoot` leads from it to
 * the root of the gallery.
 */
function findAssets(
  metafile: Metafile,
  built: string,
  [script, scene]: readonly [script: string, scene?: string],
  toRoot: string,
): Assets {
  const address = (output: string): string =>
    `${toRoot}${relative(built, resolve(here, output)).replaceAll('\\', '/')}`;
  const outputOf = (entry: string): string => {
    const found = Object.keys(metafile.outputs).find((name) => metafile.outputs[name].entryPoint === entry);
    if (!found) throw new Error(`build: ${entry} must have an output; there is none.`);
    return found;
  };
  const importsOf = (output: string, found = new Set<string>()): Set<string> => {
    for (const { path, kind } of metafile.outputs[output].imports) {
      if (kind !== 'import-statement' || found.has(path)) continue;
      found.add(path);
      importsOf(path, found);
    }
    return found;
  };
  const output = outputOf(script);
  const preload = importsOf(output);
  if (scene !== undefined) importsOf(outputOf(scene), preload.add(outputOf(scene)));
  const pixi = outputOf('src/stage/pixi-picture.ts');
  const pixiPreload = [pixi, ...importsOf(pixi)].filter((path) => !preload.has(path));
  return {
    toRoot,
    script: address(output),
    preload: [...preload].map(address),
    pixiPreload: pixiPreload.map(address),
    style: address(outputOf(entries.style)),
    formulaStyle: address(outputOf(entries.formula)),
  };
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const started = performance.now();
  console.log(`built ${await build()} in ${Math.round(performance.now() - started)} ms`);
}
