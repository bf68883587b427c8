// Everything that must hold before a change is merged, and exactly what continuous integration runs.
// The last line of its own, `N passed, N failed`, counts tests: Vitest's and Playwright's, as their reports have them.
// A skipped test counts as failed: nothing is left out in silence. A failed step that runs no tests counts as one failed.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Ended, runBin } from './run.ts';

interface Tally {
  passed: number;
  failed: number;
}

const reports = mkdtempSync(join(tmpdir(), 'mass-test-'));
const total: Tally = { passed: 0, failed: 0 };

function heading(name: string): void {
  console.log(`\n\u25b6 ${name}`);
}

/** Runs a step that has no tests of its own. */
async function step(name: string, work: () => Promise<Ended | undefined>): Promise<boolean> {
  heading(name);
  try {
    const ended = await work();
    if (!ended || ended.code === 0) return true;
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
  }
  console.error(`\u2717 ${name} failed`);
  total.failed++;
  return false;
}

/** Runs a test runner and adds what its JSON report counts. A runner that fails, or counts nothing, cannot pass. */
async function tests(
  name: string,
  work: (report: string) => Promise<Ended>,
  read: (report: string) => Tally,
): Promise<void> {
  heading(name);
  const report = join(reports, `${name.replaceAll(' ', '-')}.json`);
  const { code } = await work(report);
  let tally: Tally = { passed: 0, failed: 0 };
  try {
    tally = read(report);
  } catch {
    console.error(`\u2717 ${name} left no report`);
  }
  if (tally.passed + tally.failed === 0) console.error(`\u2717 ${name}: no test ran`);
  if (tally.failed === 0 && (code !== 0 || tally.passed === 0)) tally.failed = 1;
  total.passed += tally.passed;
  total.failed += tally.failed;
}

function readVitest(report: string): Tally {
  const { numTotalTests, numPassedTests } = JSON.parse(readFileSync(report, 'utf8'));
  return { passed: numPassedTests, failed: numTotalTests - numPassedTests };
}

function readPlaywright(report: string): Tally {
  const { stats } = JSON.parse(readFileSync(report, 'utf8'));
  return { passed: stats.expected, failed: stats.unexpected + stats.flaky + stats.skipped };
}

const ready =
  (await step('format and lint', () => runBin('@biomejs/biome', ['check', '--error-on-warnings', '.']))) &&
  (await step('types', async () => {
    const { checkTypes } = await import('./typecheck.ts');
    return { code: (await checkTypes()) ? 0 : 1, output: '' };
  })) &&
  (await step('build', async () => {
    const { buildAll } = await import('./build.ts');
    await buildAll();
    return undefined;
  }));

if (ready) {
  await tests(
    'unit tests',
    (report) =>
      runBin('vitest', [
        'run',
        '--allowOnly=false',
        '--reporter=default',
        '--reporter=json',
        `--outputFile.json=${report}`,
      ]),
    readVitest,
  );
  await tests(
    'browser tests',
    (report) =>
      runBin('playwright', ['test', '--forbid-only', '--reporter=list,json'], {
        env: { PLAYWRIGHT_JSON_OUTPUT_FILE: report },
      }),
    readPlaywright,
  );
}

rmSync(reports, { recursive: true, force: true });
console.log(`\n${total.passed} passed, ${total.failed} failed`);
process.exitCode = total.failed === 0 ? 0 : 1;
