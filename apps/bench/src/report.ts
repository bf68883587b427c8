import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { cpus } from 'node:os';
import { join } from 'node:path';
import type { Engine } from './engine.ts';
import { engines } from './engines/index.ts';
import type { Result } from './runner.ts';
import type { Case, Measure, Target, Workload } from './workload.ts';
import { workloads } from './workloads/index.ts';

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
  takePart: readonly Engine[],
  rounds: number,
): { data: Report; add: (workload: Workload, which: Case, results: readonly Result[]) => void } {
  const machine = `${cpus()[0]?.model ?? 'unknown processor'}, ${cpus().length} cores, Node.js ${process.version.slice(1)}`;
  const cases: CaseReport[] = [];
  const described: Record<string, WorkloadReport> = {};
  const engineReports = takePart.map((engine): [string, EngineReport] => {
    const { id, language, settings } = engine;
    return [id, { version: versionOf(engine), language, settings }];
  });
  return {
    data: { engines: Object.fromEntries(engineReports), workloads: described, cases },
    add({ id, title, about, measures }, { name, n, targets = {} }, results) {
      described[id] = { title, about: about.replaceAll('\n', ' '), measures };
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

/** The cases of the newer report and those of the older that did not run again, in the order of the suite; what it no longer has is left out. */
export function mergeReports(older: Report, newer: Report): Report {
  const all = { ...older.workloads, ...newer.workloads };
  const cases = workloads.flatMap(({ id, cases }) =>
    cases.flatMap(({ name }) => {
      const isIt = (one: CaseReport): boolean => one.workload === id && one.name === name;
      return newer.cases.find(isIt) ?? older.cases.find(isIt) ?? [];
    }),
  );
  const known = { ...older.engines, ...newer.engines };
  return {
    engines: Object.fromEntries(engines.flatMap(({ id }) => (known[id] ? [[id, known[id]]] : []))),
    workloads: Object.fromEntries(workloads.flatMap(({ id }) => (all[id] ? [[id, all[id]]] : []))),
    cases,
  };
}
