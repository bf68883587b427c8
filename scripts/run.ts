import { spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The root of the repository. */
export const root: string = dirname(import.meta.dirname);

/** The JavaScript file behind a command of an installed package: what `node_modules/.bin` points to, on every system. */
export function binOf(packageName: string, command: string = packageName.split('/').pop() ?? packageName): string {
  const directory = join(root, 'node_modules', ...packageName.split('/'));
  const { bin } = JSON.parse(readFileSync(join(directory, 'package.json'), 'utf8'));
  return join(directory, typeof bin === 'string' ? bin : bin[command]);
}

/** What a program that has ended leaves behind. */
export interface Ended {
  readonly code: number;
  readonly output: string;
}

/** How to run a program: extra environment variables, the folder to run it in, and whether to keep its output for later. */
export interface RunOptions {
  readonly env?: Record<string, string>;
  readonly cwd?: string;
  readonly quiet?: boolean;
}

/** Runs a program to its end; one that cannot be started ends with 127. With `quiet` its output is kept instead of shown. */
export function run(command: string, args: readonly string[], options: RunOptions = {}): Promise<Ended> {
  const { env = {}, cwd = root, quiet = false } = options;
  return new Promise((resolve) => {
    const child = spawn(command, args, {
      cwd,
      env: { ...process.env, ...env },
      stdio: quiet ? ['ignore', 'pipe', 'pipe'] : ['ignore', 'inherit', 'inherit'],
    });
    let output = '';
    const keep = (chunk: Buffer): void => {
      output += chunk.toString();
    };
    child.stdout?.on('data', keep);
    child.stderr?.on('data', keep);
    child.on('error', (error) => resolve({ code: 127, output: error.message }));
    child.on('close', (code, signal) =>
      resolve({ code: code ?? 1, output: signal ? `${output}\nended by ${signal}` : output }),
    );
  });
}

/** Runs a command of an installed package on the same Node.js as this script. */
export function runBin(
  packageName: string,
  args: readonly string[],
  options: RunOptions & { bin?: string } = {},
): Promise<Ended> {
  return run(process.execPath, [binOf(packageName, options.bin), ...args], options);
}

/** Whether a module is the script that was started, and not imported by another. */
export function isMain(moduleUrl: string): boolean {
  return process.argv[1] === fileURLToPath(moduleUrl);
}
