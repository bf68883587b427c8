import { spawn } from 'node:child_process';
import { join } from 'node:path';
import type { Engine } from './engine.ts';
import { type Outcome, TOO_SLOW } from './outcome.ts';
import { median } from './statistics.ts';
import type { Case, Values, Workload } from './workload.ts';

/** Median, least and greatest over the rounds. */
export interface Spread {
  readonly median: number;
  readonly low: number;
  readonly high: number;
}

/** What all rounds of one engine came to in one case. */
export interface Result {
  readonly engine: string;
  readonly values: Readonly<Record<string, Spread>>;
  /** Why it takes no part. */
  readonly leftOut?: string;
  /** Why there is no result. */
  readonly failure?: string;
  /** Why the result is nobody's best. */
  readonly unsound?: string;
}

/** Why an engine takes no part in a case; nothing if it does. */
export function whyNot(workload: Workload, which: Case, { cannot = {} }: Engine): string | undefined {
  return [...workload.needs, ...(which.needs ?? [])]
    .map((ability) => cannot[ability])
    .find((reason) => reason !== undefined);
}

/** Whether an engine was given up on in a smaller case of the same workload: then a larger one is not tried. */
function wasTooSlow(engine: string, { n }: Case, earlier: readonly (readonly [Case, readonly Result[]])[]): boolean {
  return earlier.some(
    ([smaller, results]) =>
      smaller.n <= n && results.some((one) => one.engine === engine && one.failure?.startsWith(TOO_SLOW)),
  );
}

/**
 * Runs each engine once a round, in turns, each run in a process of its own. An engine that failed is not tried again.
 * @param earlier - The cases of the workload that ran before, with their results.
 */
export async function runCase(
  workload: Workload,
  which: Case,
  engines: readonly Engine[],
  rounds: number,
  earlier: readonly (readonly [Case, readonly Result[]])[] = [],
): Promise<Result[]> {
  const entries = engines.map((engine) => {
    const failure = wasTooSlow(engine.id, which, earlier) ? `${TOO_SLOW}: it was in a smaller case` : '';
    return { engine, leftOut: whyNot(workload, which, engine), runs: [] as Values[], failure };
  });
  for (let round = 0; round < rounds; round++) {
    for (const entry of entries) {
      if (entry.leftOut !== undefined || entry.failure) continue;
      const outcome = await runInProcess(workload, which, entry.engine);
      if ('failure' in outcome) entry.failure = outcome.failure;
      else entry.runs.push(outcome.values);
    }
  }
  return entries.map(({ engine: { id }, leftOut, runs, failure }): Result => {
    if (leftOut !== undefined) return { engine: id, values: {}, leftOut };
    return failure ? { engine: id, values: {}, failure } : summarize(workload, id, runs);
  });
}

function summarize(workload: Workload, engine: string, runs: readonly Values[]): Result {
  const values: Record<string, Spread> = {};
  const medians: Record<string, number> = {};
  for (const name of Object.keys(workload.measures)) {
    const all = runs.map((run) => run[name] ?? Number.NaN); // JSON has null for NaN
    medians[name] = median(all);
    values[name] = { median: medians[name], low: Math.min(...all), high: Math.max(...all) };
  }
  const unsound = workload.unsound?.(medians);
  return { engine, values, ...(unsound === undefined ? {} : { unsound }) };
}

function runInProcess(workload: Workload, which: Case, engine: Engine): Promise<Outcome> {
  const flags = ['--no-warnings', ...(workload.nodeFlags ?? [])];
  const args = [...flags, join(import.meta.dirname, 'run-one.ts'), workload.id, which.name, engine.id];
  return new Promise((resolve) => {
    const child = spawn(process.execPath, args, { stdio: ['ignore', 'pipe', 'pipe'] });
    let output = '';
    let errors = '';
    child.stdout.on('data', (chunk: Buffer) => {
      output += chunk.toString();
    });
    child.stderr.on('data', (chunk: Buffer) => {
      errors += chunk.toString();
    });
    child.on('close', () => {
      try {
        resolve(JSON.parse(output.trimEnd().split('\n').at(-1) ?? ''));
      } catch {
        resolve({ failure: errors.trim().split('\n').at(-1) || 'ended without a result' });
      }
    });
  });
}
