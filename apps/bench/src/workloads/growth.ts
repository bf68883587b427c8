import { median } from '../statistics.ts';
import type { Bench, Case, Measure, Workload } from '../workload.ts';
import { pileScene } from './pile.ts';

const SIZES = [100, 500, 2000, 8000, 32_000, 100_000];
const ROWS = 20;
const SETTLE = 180;
const TIMED = 60;

/** Nanoseconds a disc and step, or nothing if it takes too long. */
function timePerDisc({ build, run, time }: Bench, n: number): number {
  try {
    const simulation = build(pileScene(n, {}, ROWS));
    run(simulation, SETTLE);
    return (1e6 * median(time(simulation, TIMED))) / n;
  } catch {
    return Number.NaN;
  }
}

const perSize = SIZES.map((n): [string, Measure] => [`n${n}`, { title: `N = ${n}`, unit: 'ns', better: 'less' }]);

interface GrowthCase extends Case {
  readonly sizes: readonly number[];
}

export const growth: Workload<GrowthCase> = {
  id: 'growth',
  title: 'Time per disc against their number',
  about: `Piles of discs, all of 20 rows, ever wider: the work grows with the number and nothing else does. Median of the steps from 3 s to 4 s,
over the number of discs; all sizes in one process, one after the other. A dash: it would have taken too long.`,
  needs: ['collide'],
  measures: {
    ...Object.fromEntries(perSize),
    growth: { title: '32000 over 2000', unit: '', better: 'less', target: { limit: 1.5 } },
  },
  cases: [
    { name: 'to 2000', n: 2000, sizes: SIZES.slice(0, 3), quick: true },
    { name: 'to 100 000', n: 100_000, sizes: SIZES },
  ],
  engines: ['mass', 'box2d3-wasm', 'rapier2d-simd-compat', 'planck'],
  run(bench, { sizes }) {
    const values = Object.fromEntries(sizes.map((n) => [`n${n}`, timePerDisc(bench, n)]));
    return { ...values, growth: values['n32000'] / values['n2000'] };
  },
};
