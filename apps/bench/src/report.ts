import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { cpus } from 'node:os';
import { join } from 'node:path';
import type { Engine } from './engine.ts';
import type { Result } from './runner.ts';
import type { Case, Measure, Target, Workload } from './workload.ts';

/** Results of one case, with what is needed to read them. */
export interface CaseReport {
  readonly workload: string;
  readonly name: string;
  readonly n: number;
  readonly rounds: number;
  readonly machine: string;
  readonly targets: Readonly<Record<string, Target>>;
  readonly results: readonly Result[];
}

/** All that `results.json` holds. */
export interface Report {
  readonly engines: Readonly<Record<string, EngineReport>>;
  readonly workloads: Readonly<Record<string, WorkloadReport>>;
  readonly cases: readonly CaseReport[];
}

export interface EngineReport {
  readonly version: string;
  readonly language: string;
  readonly settings: readonly string[];
}

export interface WorkloadReport {
  readonly title: string;
  readonly about: string;
  readonly measures: Readonly<Record<string, Measure>>;
}

/** A report that grows case by case. */
export function makeReport(
  engines: readonly Engine[],
  rounds: number,
): { data: Report; add: (workload: Workload, which: Case, results: readonly Result[]) => void } {
  const machine = `${cpus()[0]?.model ?? 'unknown processor'}, ${cpus().length} cores, Node.js ${process.version.slice(1)}`;
  const cases: CaseReport[] = [];
  const workloads: Record<string, WorkloadReport> = {};
  const described = engines.map((engine): [string, EngineReport] => {
    const { id, language, settings } = engine;
    return [id, { version: versionOf(engine), language, settings }];
  });
  return {
    data: { engines: Object.fromEntries(described), workloads, cases },
    add({ id, title, about, measures }, { name, n, targets = {} }, results) {
      workloads[id] = { title, about: about.replaceAll('\n', ' '), measures };
      const common = Object.entries(measures).flatMap(([key, { target }]) => (target ? [[key, target] as const] : []));
      cases.push({
        ...{ workload: id, name, n, rounds, machine, results },
        targets: { ...Object.fromEntries(common), ...targets },
      });
    },
  };
}

function versionOf({ package: name }: Engine): string {
  if (name === undefined) return '';
  for (const folder of createRequire(import.meta.url).resolve.paths(name) ?? []) {
    const file = join(folder, name, 'package.json');
    if (existsSync(file)) return JSON.parse(readFileSync(file, 'utf8')).version;
  }
  throw new Error(`bench: ${name} is not installed. Run the install of the workspace.`);
}

/** The cases of the newer report, and those of the older that did not run again. */
export function mergeReports(older: Report, newer: Report): Report {
  const again = (old: CaseReport): boolean =>
    newer.cases.some(({ workload, name }) => workload === old.workload && name === old.name);
  return {
    engines: { ...older.engines, ...newer.engines },
    workloads: { ...older.workloads, ...newer.workloads },
    cases: [...older.cases.filter((old) => !again(old)), ...newer.cases],
  };
}
