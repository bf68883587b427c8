import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import type { Engine, Simulation } from '../src/engine.ts';
import { engines } from '../src/engines/index.ts';
import { makeReport, mergeReports, type Report } from '../src/report.ts';
import { whyNot } from '../src/runner.ts';
import type { Scene } from '../src/scene.ts';
import { reportAsMarkdown } from '../src/tables.ts';
import type { Bench, Workload } from '../src/workload.ts';
import { workloads } from '../src/workloads/index.ts';

const STEPS = 2;

function engineOf(id: string): Engine {
  const engine = engines.find((one) => one.id === id);
  if (!engine) throw new Error(`no engine ${id}`);
  return engine;
}

/** A bench that takes two steps where the real one takes hundreds, and keeps what was built. */
async function briefBench(engine: Engine): Promise<{ bench: Bench; built: [Scene, Simulation][] }> {
  const build = await engine.load();
  const built: [Scene, Simulation][] = [];
  const bench: Bench = {
    engine,
    build(scene, effort = 1) {
      const simulation = build(scene, effort);
      built.push([scene, simulation]);
      return simulation;
    },
    run(simulation, steps) {
      for (let step = 0; step < Math.min(steps, STEPS); step++) simulation.step();
    },
    time(simulation, steps, after) {
      const times = new Float64Array(Math.min(steps, STEPS)).fill(1);
      times.forEach((_, step) => {
        simulation.step();
        after?.(step);
      });
      return times;
    },
  };
  return { bench, built };
}

const runs = workloads.flatMap((workload) => {
  const takePart = (id: string) =>
    (workload.engines?.includes(id) ?? true) && !whyNot(workload, workload.cases[0], engineOf(id));
  return ['mass', 'planck'].filter(takePart).map((id): [string, string, Workload] => [workload.id, id, workload]);
});

it.each(runs)('%s builds and steps in %s', async (_, id, workload) => {
  const { bench, built } = await briefBench(engineOf(id));
  const values = await workload.run(bench, workload.cases[0]);
  expect(Object.keys(workload.measures)).toEqual(expect.arrayContaining(Object.keys(values)));
  expect(Object.values(values).every((value) => typeof value === 'number')).toBe(true);
  for (const [{ discs, crates }, simulation] of built) {
    const positions = new Float64Array(2 * discs.length);
    const corners = new Float64Array(8 * crates.length);
    simulation.readPositions(positions);
    simulation.readCorners?.(corners);
    expect([...positions, ...corners].every(Number.isFinite)).toBe(true);
  }
});

it('names of workloads, cases and engines are told apart, on the command line too', () => {
  for (const names of [workloads.map(({ id }) => id), engines.map(({ id }) => id)]) {
    expect(new Set(names).size).toBe(names.length);
  }
  for (const { cases } of workloads) {
    expect(new Set(cases.map(({ name }) => name)).size).toBe(cases.length);
    expect(cases.filter(({ name }) => name.includes(','))).toEqual([]);
    expect(cases.some(({ quick }) => quick)).toBe(true);
  }
});

/** Each table of a Markdown text, as rows of cells. */
function tablesOf(markdown: string): string[][][] {
  const blocks = markdown.split('\n\n').filter((block) => block.startsWith('|'));
  return blocks.map((block) => block.split('\n').map((line) => line.split('|').slice(1, -1)));
}

function expectWellFormed(report: Report): void {
  for (const { workload, results, targets } of report.cases) {
    const { measures } = report.workloads[workload];
    expect(Object.keys(measures)).toEqual(expect.arrayContaining(Object.keys(targets)));
    for (const { engine, values, failure, leftOut } of results) {
      expect(Object.keys(report.engines)).toContain(engine);
      expect(Object.keys(values)).toEqual(failure || leftOut ? [] : Object.keys(measures));
    }
  }
  const tables = tablesOf(reportAsMarkdown(report));
  expect(tables.length).toBe(report.cases.length + 1);
  for (const [head, ...rows] of tables) for (const row of rows) expect(row.length).toBe(head.length);
}

it('a report has a table for each case and a row for each target', () => {
  const [workload] = workloads;
  const { data, add } = makeReport(engines, 1);
  const values = (scale: number) =>
    Object.fromEntries(Object.keys(workload.measures).map((name) => [name, { median: scale, low: 0, high: scale }]));
  add(workload, workload.cases[0], [
    { engine: 'mass', values: values(1) },
    { engine: 'planck', values: values(2) },
    { engine: 'verlet', values: values(0.1) },
    { engine: 'p2-es', values: values(0.2), unsound: '3 escaped' },
    { engine: 'matter-js', values: {}, failure: 'too slow' },
    { engine: 'objects', values: {}, leftOut: 'flight alone' },
  ]);
  expectWellFormed(data);
  const [[, , ...targets], [, , ...results]] = tablesOf(reportAsMarkdown(data));
  expect(targets.map((row) => row[3].trim())).toEqual(targets.map(() => '2.0 (planck)'));
  expect(results.map((row) => row[0].trim())).toEqual(['mass', 'planck', 'verlet', 'p2-es', 'matter-js']);
  expect(mergeReports(data, data)).toEqual(data);
});

it('the saved report is well-formed, and the docs show it', () => {
  const root = join(import.meta.dirname, '../../..');
  const report: Report = JSON.parse(readFileSync(join(root, 'apps/bench/results.json'), 'utf8'));
  expectWellFormed(report);
  expect(report.cases.length).toBeGreaterThan(0);
  expect(readFileSync(join(root, 'docs/benchmarks.md'), 'utf8')).toContain(reportAsMarkdown(report));
});
