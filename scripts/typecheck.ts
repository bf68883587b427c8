// Type-checks every project of the workspace, each under its own limits: the core and the scenes without DOM and Node types, and so on.
import { existsSync, globSync } from 'node:fs';
import { dirname, join, relative, sep } from 'node:path';
import { isMain, root, runBin } from './run.ts';

/** Runs tsc on the root project and on each package and application that has source. Returns whether all passed. */
export async function checkTypes(): Promise<boolean> {
  const projects = globSync(['{packages,apps}/*/tsconfig.json', 'apps/*/src/*/tsconfig.json'], { cwd: root })
    .map((file) => join(root, file))
    .filter((file) => file.includes(`${sep}src${sep}`) || existsSync(join(dirname(file), 'src')));
  projects.unshift(join(root, 'tsconfig.json'));

  const results = await Promise.all(
    projects.map(async (project) => {
      const { code, output } = await runBin('typescript', ['-p', project, '--pretty'], { bin: 'tsc', quiet: true });
      return { project: relative(root, project), code, output };
    }),
  );
  for (const { project, code, output } of results)
    console.log(`${code === 0 ? 'ok  ' : 'FAIL'} ${project}\n${output}`.trimEnd());
  return results.every(({ code }) => code === 0);
}

if (isMain(import.meta.url)) process.exitCode = (await checkTypes()) ? 0 : 1;
