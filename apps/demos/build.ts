// Builds the gallery: static files in `dist` that work from any sub-path. `node build.ts` from this folder.
import { mkdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build as bundle, type Metafile } from 'esbuild';
import type { Assets } from './pages/layout.ts';
import { listPage } from './pages/list-page.ts';
import { scenePage } from './pages/scene-page.ts';
import { scenes } from './src/scenes/index.ts';

const here = dirname(fileURLToPath(import.meta.url));
const dist = join(here, 'dist');
// Everything is made here first: a build that fails leaves the last one as it was, and a server never sees half of one.
const next = 'node_modules/.gallery';

/** The entries of the bundle: what a page loads by name. Every other chunk is loaded by these. */
const entries = {
  list: 'src/gallery/list-page.ts',
  scene: 'src/gallery/scene-page.ts',
  style: 'src/styles/gallery.css',
  formula: 'src/styles/formula.css',
};

/** Builds the gallery. Returns the folder of its static files. */
export async function build(): Promise<string> {
  rmSync(join(here, next), { recursive: true, force: true });
  const { metafile } = await bundle({
    absWorkingDir: here,
    entryPoints: entries,
    outdir: next,
    entryNames: 'assets/[name]-[hash]',
    chunkNames: 'assets/chunk-[hash]',
    assetNames: 'assets/[name]-[hash]',
    bundle: true,
    splitting: true,
    format: 'esm',
    target: 'es2022',
    minify: true,
    sourcemap: 'linked',
    // KaTeX offers each font three times; every browser that runs the gallery takes the first.
    loader: { '.woff2': 'file', '.woff': 'empty', '.ttf': 'empty' },
    metafile: true,
    logLevel: 'warning',
  });

  write('index.html', listPage(scenes, assetsOf(metafile, 'list', '')));
  for (const [index, scene] of scenes.entries()) {
    const neighbours = { previous: scenes[index - 1], next: scenes[index + 1] };
    const page = await scenePage(scene, neighbours, assetsOf(metafile, 'scene', '../../'));
    write(`scenes/${scene.id}/index.html`, page);
  }
  // GitHub Pages hides files whose name begins with an underscore unless told not to; other hosts do not mind the file.
  write('.nojekyll', '');
  rmSync(dist, { recursive: true, force: true });
  renameSync(join(here, next), dist);
  return dist;
}

/** The addresses of what a page loads, seen from the page: `toRoot` leads from it to `dist`. */
function assetsOf(metafile: Metafile, script: 'list' | 'scene', toRoot: string): Assets {
  const address = (output: string): string => `${toRoot}${output.slice(next.length + 1)}`;
  const outputOf = (entry: string): string => {
    const found = Object.keys(metafile.outputs).find((name) => metafile.outputs[name].entryPoint === entry);
    if (!found) throw new Error(`build: ${entry} must have an output; there is none.`);
    return found;
  };
  const preload = new Set<string>();
  const visit = (output: string): void => {
    for (const { path, kind } of metafile.outputs[output].imports) {
      if (kind !== 'import-statement' || preload.has(path)) continue;
      preload.add(path);
      visit(path);
    }
  };
  const output = outputOf(entries[script]);
  visit(output);
  return {
    toRoot,
    script: address(output),
    preload: [...preload].map(address),
    style: address(outputOf(entries.style)),
    formulaStyle: address(outputOf(entries.formula)),
  };
}

function write(file: string, text: string): void {
  const path = join(here, next, file);
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, text);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const started = performance.now();
  console.log(`built ${await build()} in ${Math.round(performance.now() - started)} ms`);
}
