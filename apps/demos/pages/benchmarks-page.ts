import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { CaseReport, Report } from '../../bench/src/report.ts';
import type { Result } from '../../bench/src/runner.ts';
import { format } from '../../bench/src/tables.ts';
import type { Measure } from '../../bench/src/workload.ts';
import { type Dot, dotTable, type Line, lineChart } from './charts.ts';
import { type Html, html } from './html.ts';
import { type Assets, layout } from './layout.ts';

const OWN = 'mass';

/** Workloads that are lines over something, and not dots beside each other. */
const drawnAsLines = new Set(['growth', 'energy', 'load']);

/** Accuracy and speed beside other engines, as the benchmark last saved them. */
export function benchmarksPage(assets: Assets): string {
  const file = join(import.meta.dirname, '../../bench/results.json');
  const report: Report = JSON.parse(readFileSync(file, 'utf8'));
  return layout(
    {
      title: 'Benchmarks · Mass',
      description: 'Accuracy and speed of Mass and a dozen other engines, side by side, on the same scenes.',
      kind: 'benchmarks',
      main: html`<header class="opening">
<h1>Beside other engines</h1>
<p class="look">The same scenes, each run a process of its own, engines in turns; the quality of a result stands beside its time, and is computed by one code for all. Where Mass loses, it says so. <code>pnpm bench</code> runs it again; each engine's settings are at the end.</p>
</header>
${Object.entries(report.workloads).map(([id, workload]) => {
  const cases = report.cases.filter((one) => one.workload === id);
  if (cases.length === 0) return false;
  return html`<section aria-labelledby="${id}">
<h2 class="chapter" id="${id}">${workload.title}</h2>
<p class="about">${workload.about.replaceAll('`', '')}</p>
${drawnAsLines.has(id) ? linesOf(id, cases) : cases.map((one) => dotsOf(one, workload.measures))}</section>
`;
})}
<section aria-labelledby="settings">
<h2 class="chapter" id="settings">Settings</h2>
<ul class="settings">
${Object.entries(report.engines).map(([id, { version, language, settings }]) => html`<li><b>${id}</b> ${version} (${language}): ${settings.join('; ').replaceAll('`', '')}.</li>\n`)}</ul>
</section>`,
    },
    assets,
  );
}

function numberOf({ values }: Result, name: string): number {
  return values[name]?.median ?? Number.NaN;
}

function dotsOf({ name, machine, rounds, results }: CaseReport, measures: Readonly<Record<string, Measure>>): Html {
  const names = Object.keys(measures);
  const head = names.map((key) => `${measures[key].title}${measures[key].unit && `, ${measures[key].unit}`}`);
  const sign = measures[names[0]].better === 'less' ? 1 : -1;
  const dots = results
    .filter(({ leftOut }) => leftOut === undefined)
    .map((result): Dot => {
      const { engine, failure, unsound } = result;
      const cells = names.map((key) => (failure === undefined ? format(numberOf(result, key)) : ''));
      const remark = (failure ?? unsound ?? '').slice(0, 60);
      return { label: engine, value: numberOf(result, names[0]), cells, remark, sound: unsound === undefined };
    })
    .sort((a, b) => (Number.isNaN(a.value) ? 1 : Number.isNaN(b.value) ? -1 : sign * (a.value - b.value)));
  return html`${dotTable(name, head, dots, OWN)}<p class="machine">${rounds} ${rounds === 1 ? 'round' : 'rounds'}, ${machine}</p>
`;
}

function linesOf(id: string, cases: readonly CaseReport[]): Html {
  const last = cases[cases.length - 1];
  const took = last.results.filter(({ leftOut, failure }) => leftOut === undefined && failure === undefined);
  if (id === 'growth') {
    const sizes = Object.keys(took[0].values).filter((name) => name.startsWith('n'));
    return lineChart({
      title: 'Time per disc and step against the number of discs',
      x: { label: 'discs', logarithmic: true, ticks: [100, 1000, 10_000, 100_000] },
      y: { label: 'ns a disc', logarithmic: true, ticks: [100, 300, 1000, 3000, 10_000, 30_000] },
      lines: took.map((result) => lineOf(result, sizes)),
      own: OWN,
    });
  }
  if (id === 'energy') {
    const times = Object.keys(took[0].values);
    return lineChart({
      title: 'Energy left in the swing',
      x: { label: 'seconds', ticks: [0, 5, 10, 15, 20] },
      y: { label: '%', ticks: [0, 25, 50, 75, 100] },
      lines: took.map((result) => {
        const { label, points } = lineOf(result, times);
        return { label, points: [[0, 100], ...points] };
      }),
      own: OWN,
    });
  }
  return lineChart({
    title: 'Stretch with the recommended settings',
    x: { label: 'load, kg, on links of 1 kg', logarithmic: true, ticks: [1, 10, 100, 1000, 10_000] },
    y: { label: '%', logarithmic: true, ticks: [1e-6, 1e-4, 0.01, 1, 100, 10_000] },
    lines: took.map(({ engine }) => ({
      label: engine,
      points: cases.map(({ n, results }): [number, number] => {
        const result = results.find((one) => one.engine === engine);
        return [n, result ? numberOf(result, 'once') : Number.NaN];
      }),
    })),
    own: OWN,
  });
}

/** The line through measures whose names are a letter and a number. */
function lineOf(result: Result, names: readonly string[]): Line {
  return {
    label: result.engine,
    points: names.map((name): [number, number] => [Number(name.slice(1)), numberOf(result, name)]),
  };
}
