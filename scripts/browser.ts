// Finds a Chromium for the browser tests, or gets one, or says in one error which command to run.
import { accessSync, constants, existsSync, statSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { chromium } from 'playwright';
import { isMain, run, runBin } from './run.ts';

/** WebGL by SwiftShader, so that the same pixels come out with and without a graphics card; no traffic of the browser's own. */
export const browserArgs: readonly string[] = [
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  // Drawn by the processor, an accelerated canvas is many times slower than one that is not.
  '--disable-accelerated-2d-canvas',
  // Chromium's sandbox cannot start as root.
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
];

const pathNames = [
  'chromium',
  'chromium-browser',
  'google-chrome',
  'google-chrome-stable',
  'chrome',
  'msedge',
  'microsoft-edge',
];

function usualPlaces(): string[] {
  const { HOME = '', LOCALAPPDATA = '', PROGRAMFILES = '', 'PROGRAMFILES(X86)': PROGRAMFILES_X86 = '' } = process.env;
  if (process.platform === 'darwin') {
    const applications = ['Google Chrome', 'Chromium', 'Microsoft Edge'].map(
      (name) => `/Applications/${name}.app/Contents/MacOS/${name}`,
    );
    return [...applications, ...applications.map((path) => join(HOME, path))];
  }
  if (process.platform === 'win32') {
    const folders = [PROGRAMFILES, PROGRAMFILES_X86, LOCALAPPDATA].filter(Boolean);
    const programs = [
      'Google/Chrome/Application/chrome.exe',
      'Chromium/Application/chrome.exe',
      'Microsoft/Edge/Application/msedge.exe',
    ];
    return folders.flatMap((folder) => programs.map((program) => join(folder, program)));
  }
  return ['/opt/google/chrome/chrome', '/snap/bin/chromium', '/usr/lib/chromium/chromium'];
}

function isProgram(path: string): boolean {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}

function onThisMachine(): string | undefined {
  const suffix = process.platform === 'win32' ? '.exe' : '';
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  const onPath = pathNames.flatMap((name) => folders.map((folder) => join(folder, name + suffix)));
  return [...onPath, ...usualPlaces()].find(isProgram);
}

/** The line of a program's output that says what went wrong. */
function reason(output: string): string {
  const lines = output.trim().split('\n');
  return lines.find((line) => /^(E:|Error:|error)/.test(line)) ?? lines.at(-1) ?? '';
}

async function playwrightsDownload(): Promise<string | undefined> {
  const { code, output } = await runBin('playwright', ['install', '--no-shell', 'chromium'], { quiet: true });
  if (code !== 0) console.error(`The download failed. ${reason(output)}`);
  return code === 0 && isProgram(chromium.executablePath()) ? chromium.executablePath() : undefined;
}

async function debiansPackage(): Promise<string | undefined> {
  if (process.platform !== 'linux' || process.getuid?.() !== 0 || !existsSync('/etc/debian_version')) return undefined;
  const env = { DEBIAN_FRONTEND: 'noninteractive' };
  await run('apt-get', ['update', '-qq'], { env, quiet: true });
  const { code, output } = await run('apt-get', ['install', '-y', '-qq', '--no-install-recommends', 'chromium'], {
    env,
    quiet: true,
  });
  if (code !== 0) console.error(`apt-get could not install chromium. ${reason(output)}`);
  return code === 0 ? onThisMachine() : undefined;
}

/** The path of a Chromium or Chrome to test with: CHROME_PATH, Playwright's own, one on the machine, Playwright's download, Debian's package. */
export async function findBrowser(): Promise<string> {
  const { CHROME_PATH } = process.env;
  if (CHROME_PATH) {
    if (isProgram(CHROME_PATH)) return CHROME_PATH;
    throw new Error(`Browser tests: CHROME_PATH must be the path of a Chromium or Chrome; got ${CHROME_PATH}.`);
  }
  if (isProgram(chromium.executablePath())) return chromium.executablePath();
  const found = onThisMachine();
  if (found) return found;

  console.log('No Chromium on this machine: downloading the one that Playwright uses.');
  const downloaded = await playwrightsDownload();
  if (downloaded) return downloaded;
  const installed = await debiansPackage();
  if (installed) return installed;

  throw new Error(
    'Browser tests: no Chromium or Chrome found, and none could be downloaded. ' +
      'Run `npx -y pnpm@12 exec playwright install --with-deps chromium`, or set CHROME_PATH to a Chromium or Chrome.',
  );
}

if (isMain(import.meta.url)) {
  try {
    console.log(await findBrowser());
  } catch (error) {
    console.error((error as Error).message);
    process.exitCode = 1;
  }
}
