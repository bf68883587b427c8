import { readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'esbuild';

const engine = ['@mass/core', '@mass/core/view'].map((name) => [name, filesOf(name)] as const);

/**
 * Imports each part of the engine from the file that it is in. Where several pages share the index of a package, esbuild gives
 * each of them whatever the index leads to and one of them needs; so a page gets what it needs itself.
 */
export const directImports: Plugin = {
  name: 'direct-imports',
  setup({ onLoad }) {
    onLoad({ filter: /[\\/](demos|canvas2d|pixi)[\\/]src[\\/].*\.ts$/ }, ({ path }) => {
      let contents = readFileSync(path, 'utf8');
      for (const [name, files] of engine) {
        contents = contents.replaceAll(new RegExp(`^import \\{([^}]*)\\} from '${name}';`, 'gm'), (_, names: string) =>
          names.replaceAll(/(?:type )?\w+(?: as \w+)?,?/g, (each) => importOf(each.replace(',', ''), name, files)),
        );
      }
      return { contents, loader: 'ts' };
    });
  },
};

function importOf(what: string, name: string, files: ReadonlyMap<string, string>): string {
  if (what.startsWith('type ')) return '';
  const file = files.get(what.split(' ')[0]);
  if (!file) throw new Error(`directImports: the index of ${name} must export ${what} from a file; it does not.`);
  return `import { ${what} } from ${JSON.stringify(file)};`;
}

/** The file of each name that the index of a package exports. */
function filesOf(name: string): ReadonlyMap<string, string> {
  const index = fileURLToPath(import.meta.resolve(name));
  const files = new Map<string, string>();
  for (const [, names, from] of readFileSync(index, 'utf8').matchAll(/^export \{([^}]*)\} from '([^']+)';/gm)) {
    for (const [exported] of names.matchAll(/(?<!type )\b(?!type )\w+/g))
      files.set(exported, resolve(dirname(index), from));
  }
  return files;
}
