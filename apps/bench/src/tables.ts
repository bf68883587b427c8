// Results as Markdown.
import type { CaseReport, Report } from './report.ts';
import type { Result, Spread } from './runner.ts';
import type { Measure } from './workload.ts';

const OWN = 'mass';
const REMARK = 90;

/** A number with two or three digits that count; a dash for one that could not be had. */
export function format(value: number | null): string {
  if (value === null || Number.isNaN(value)) return '–'; // JSON has null for NaN
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(1);
  return size >= 100 ? value.toFixed(0) : value.toPrecision(size >= 10 ? 3 : 2);
}

function table(head: readonly string[], rows: readonly (readonly string[])[]): string {
  const widths = head.map((title, c) => Math.max(title.length, ...rows.map((row) => row[c].length), 3));
  const line = (cells: readonly string[]): string =>
    `| ${cells.map((cell, c) => cell.padEnd(widths[c])).join(' | ')} |`;
  const isText = widths.map((_, c) => c === 0 || rows.some((row) => /^[a-z]{2,} /.test(row[c])));
  const rule = widths.map((width, c) => (isText[c] ? '-'.repeat(width) : `${'-'.repeat(width - 1)}:`));
  return [line(head), line(rule), ...rows.map(line)].join('\n');
}

/** One row an engine, one column a measure; the spread over the rounds beside the first measure. */
export function caseTable(
  { measures }: { measures: Readonly<Record<string, Measure>> },
  results: readonly Result[],
): string {
  const names = Object.keys(measures);
  const head = names.map((name) => `${measures[name].title}${measures[name].unit && `, ${measures[name].unit}`}`);
  const takePart = results.filter(({ leftOut }) => leftOut === undefined);
  const rows = takePart.map(({ engine, values, failure, unsound }) => {
    if (failure !== undefined) return [engine, ...names.map(() => ''), shorten(failure)];
    return [engine, ...names.map((name, i) => cell(values[name], i === 0)), unsound ?? ''];
  });
  const missing = results.flatMap(({ engine, leftOut }) => (leftOut === undefined ? [] : [`${engine} (${leftOut})`]));
  const note = missing.length > 0 ? `\n\nLeft out: ${missing.join(', ')}.` : '';
  return `${table(['engine', ...head, 'remark'], rows)}${note}`;
}

/** The first of a long message. */
function shorten(message: string): string {
  return message.length <= REMARK ? message : `${message.slice(0, REMARK)}…`;
}

function cell({ median, low, high }: Spread, withSpread: boolean): string {
  return withSpread && low < high ? `${format(median)} (${format(low)} to ${format(high)})` : format(median);
}

/** The best sound peer of a measure; what is written by hand for this suite is a yardstick, not a peer. */
function bestPeer(
  { engines }: Report,
  results: readonly Result[],
  name: string,
  better: Measure['better'],
): Result | undefined {
  const sign = better === 'less' ? 1 : -1;
  return results
    .filter(
      ({ engine, failure, unsound }) =>
        engines[engine]?.version && !engine.startsWith(OWN) && failure === undefined && unsound === undefined,
    )
    .filter(({ values }) => Number.isFinite(values[name]?.median))
    .sort((a, b) => sign * (a.values[name].median - b.values[name].median))[0];
}

/** A row for each target: ours, the best peer's, and whether the target is met. */
export function targetTable(report: Report): string {
  const rows = report.cases.flatMap((one) =>
    Object.keys(one.targets).flatMap((name) => {
      const row = targetRow(report, one, name);
      return row ? [row] : [];
    }),
  );
  return table(['work', 'measure', 'Mass', 'best peer', 'ratio', 'target', 'met'], rows);
}

function targetRow(report: Report, one: CaseReport, name: string): string[] | undefined {
  const { title, measures } = report.workloads[one.workload];
  const measure = measures[name];
  const own = one.results.find(({ engine }) => engine === OWN);
  if (!own || own.leftOut !== undefined) return undefined;
  const { ratio, limit } = one.targets[name];
  const value = own.values[name]?.median ?? Number.NaN;
  const best = bestPeer(report, one.results, name, measure.better);
  const share = best && value / best.values[name].median;
  const goals: string[] = [];
  const checks: boolean[] = [];
  if (ratio !== undefined) {
    goals.push(`ratio ${ratio}`);
    checks.push(share !== undefined && share <= ratio);
  }
  if (limit !== undefined) {
    goals.push(`${measure.better === 'less' ? 'at most' : 'at least'} ${limit} ${measure.unit}`.trimEnd());
    checks.push(measure.better === 'less' ? value <= limit : value >= limit);
  }
  const sound = own.failure === undefined && own.unsound === undefined;
  return [
    `${title}: ${one.name}`,
    `${measure.title}${measure.unit && `, ${measure.unit}`}`,
    own.failure === undefined ? format(value) : 'failed',
    best ? `${format(best.values[name].median)} (${best.engine})` : 'none',
    ratio === undefined || share === undefined ? '' : format(share),
    goals.join(', '),
    checks.length === 0 ? '' : sound && checks.every(Boolean) ? 'yes' : 'no',
  ];
}

/** The whole report: targets, then each workload with its cases, then the settings of each engine. */
export function reportAsMarkdown(report: Report): string {
  const parts = ['## Targets', targetTable(report), '## Results'];
  for (const [id, workload] of Object.entries(report.workloads)) {
    parts.push(`### ${workload.title}`, workload.about);
    for (const { name, results, rounds, machine, workload: of } of report.cases) {
      if (of !== id) continue;
      const runs = `${rounds} ${rounds === 1 ? 'round' : 'rounds'} on ${machine}`;
      parts.push(`#### ${name}`, `${runs}.`, caseTable(workload, results));
    }
  }
  parts.push('## Engines and their settings');
  for (const [id, { version, language, settings }] of Object.entries(report.engines)) {
    parts.push(`- **${id}** ${version} (${language}): ${settings.join('; ')}.`.replace('  ', ' '));
  }
  return parts.join('\n\n');
}
