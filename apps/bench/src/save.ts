import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Report } from './report.ts';
import { reportAsMarkdown } from './tables.ts';

const RESULTS = join(import.meta.dirname, '../results.json');
const DOCS = join(import.meta.dirname, '../../../docs/benchmarks.md');
const MARKS = ['<!-- results: written by `pnpm bench --save` -->', '<!-- end of results -->'] as const;

/** The saved report, or an empty one. */
export function readReport(): Report {
  if (!existsSync(RESULTS)) return { engines: {}, workloads: {}, cases: [] };
  return JSON.parse(readFileSync(RESULTS, 'utf8'));
}

/** Writes the JSON, four digits of each number, and its tables into the docs, between two marks. */
export function saveReport(report: Report): void {
  const json = JSON.stringify(report, (_, value) => (typeof value === 'number' ? Number(value.toPrecision(4)) : value));
  writeFileSync(RESULTS, `${json.replace(/\{"(workload|engine)":/g, '\n$&')}\n`); // a line a case, a line an engine
  const docs = readFileSync(DOCS, 'utf8');
  const [before, rest] = docs.split(MARKS[0]);
  const after = rest?.split(MARKS[1])[1];
  if (after === undefined) throw new Error(`bench: ${DOCS} must hold the marks ${MARKS.join(' and ')}.`);
  writeFileSync(DOCS, `${before}${MARKS[0]}\n\n${reportAsMarkdown(readReport())}\n\n${MARKS[1]}${after}`);
}
