/**
 * Accuracy and speed, side by side: `pnpm bench --help`. Every run is a process of its own; engines take turns, round by round.
 */
import { parseArgs } from 'node:util';
import { engines, quickEngines } from './engines/index.ts';
import { makeReport, mergeReports } from './report.ts';
import { type Result, runCase } from './runner.ts';
import { readReport, saveReport } from './save.ts';
import { caseTable, targetTable } from './tables.ts';
import type { Case } from './workload.ts';
import { workloads } from './workloads/index.ts';

const HELP = `pnpm bench [options]

  --quick            the smallest cases, one round, five engines: about two minutes
  --only a,b         these workloads: ${workloads.map(({ id }) => id).join(', ')}
  --cases a,b        these cases, by name
  --engines a,b      these engines: ${engines.map(({ id }) => id).join(', ')}
  --rounds n         how often each engine runs each case; 3, or 1 with --quick
  --save             writes results.json and the tables of docs/benchmarks.md; cases that did not run stay as they were
`;

const { values: options } = parseArgs({
  args: process.argv.slice(2).filter((arg) => arg !== '--'),
  options: {
    quick: { type: 'boolean', default: false },
    only: { type: 'string' },
    cases: { type: 'string' },
    engines: { type: 'string' },
    rounds: { type: 'string' },
    save: { type: 'boolean', default: false },
    help: { type: 'boolean', default: false },
  },
});

/** Those of a list that are asked for by id; all if nothing is. A name that nobody has is an error. */
function choose<T>(all: readonly T[], idOf: (item: T) => string, ids: string | undefined): readonly T[] {
  if (ids === undefined) return all;
  return ids.split(',').map((wanted) => {
    const found = all.find((item) => idOf(item) === wanted);
    if (!found) throw new Error(`bench: there is no "${wanted}"; there is ${all.map(idOf).join(', ')}.`);
    return found;
  });
}

if (options.help) {
  console.log(HELP);
} else {
  const rounds = Number(options.rounds ?? (options.quick ? 1 : 3));
  if (!(Number.isInteger(rounds) && rounds > 0))
    throw new Error(`bench: --rounds must be 1 or more; got ${options.rounds}.`);
  const engineIds = options.engines ?? (options.quick ? quickEngines : undefined);
  const chosenEngines = choose(engines, ({ id }) => id, engineIds);
  const caseNames = options.cases?.split(',');
  const report = makeReport(chosenEngines, rounds);
  for (const workload of choose(workloads, ({ id }) => id, options.only)) {
    const takePart = chosenEngines.filter(({ id }) => workload.engines?.includes(id) ?? true);
    const earlier: [Case, Result[]][] = [];
    for (const which of workload.cases) {
      if (caseNames ? !caseNames.includes(which.name) : options.quick && !which.quick) continue;
      const results = await runCase(workload, which, takePart, rounds, earlier);
      earlier.push([which, results]);
      report.add(workload, which, results);
      if (options.save) saveReport(mergeReports(readReport(), report.data));
      console.log(`\n${workload.title}: ${which.name}\n${caseTable(workload, results)}`);
    }
  }
  console.log(`\n${targetTable(report.data)}`);
}
