/** One engine, one case of one workload, in a process of its own: `node run-one.ts <workload> <case> <engine>`. Prints one line of JSON. */
import type { Engine } from './engine.ts';
import { engines } from './engines/index.ts';
import { type Outcome, TOO_SLOW } from './outcome.ts';
import type { Bench } from './workload.ts';
import { workloads } from './workloads/index.ts';

const PATIENCE = 60_000; // ms

/** A bench that gives up on what takes too long. */
async function makeBench(engine: Engine): Promise<Bench> {
  const build = await engine.load();
  const deadline = performance.now() + PATIENCE;
  function requireTime(now: number): void {
    if (now > deadline) throw new Error(`${TOO_SLOW}: given up after ${PATIENCE / 1000} s`);
  }
  return {
    engine,
    build: (scene, effort = 1) => build(scene, effort),
    run(simulation, steps) {
      for (let step = 0; step < steps; step++) {
        if (step % 16 === 0) requireTime(performance.now());
        simulation.step();
      }
    },
    time(simulation, steps, after) {
      const times = new Float64Array(steps);
      for (let step = 0; step < steps; step++) {
        const from = performance.now();
        simulation.step();
        const to = performance.now();
        times[step] = to - from;
        after?.(step);
        requireTime(to);
      }
      return times;
    },
  };
}

async function runOne(workloadId: string, caseName: string, engineId: string): Promise<Outcome> {
  const workload = workloads.find(({ id }) => id === workloadId);
  const which = workload?.cases.find(({ name }) => name === caseName);
  const engine = engines.find(({ id }) => id === engineId);
  if (!workload || !which || !engine) throw new Error(`no such run: ${workloadId}, ${caseName}, ${engineId}`);
  return { values: await workload.run(await makeBench(engine), which) };
}

if (import.meta.main) {
  const [workload, which, engine] = process.argv.slice(2);
  const outcome = await runOne(workload, which, engine).catch((error: Error): Outcome => ({ failure: error.message }));
  console.log(`\n${JSON.stringify(outcome)}`); // a line of its own: some engines greet the console
  process.exit(0);
}
