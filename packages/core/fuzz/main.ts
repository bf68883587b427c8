/**
 * Steps random worlds and tells what goes wrong in them: `node main.ts --worlds 1000 --from 0`. A world depends on its number alone,
 * so that a run can be split among processes. Of a world that fails the least that still fails is printed, as `WorldPlan`.
 */
import { parseArgs } from 'node:util';
import { judge } from './judge.ts';
import { randomPlan } from './random-plan.ts';
import { shrink } from './shrink.ts';

const { values } = parseArgs({
  options: {
    worlds: { type: 'string', default: '1000' },
    from: { type: 'string', default: '0' },
    brief: { type: 'boolean', default: false },
  },
});
const from = Number(values.from);
const worlds = Number(values.worlds);
if (!Number.isInteger(from) || !(Number.isInteger(worlds) && worlds > 0)) {
  throw new RangeError(`fuzz: --from and --worlds must be whole numbers; got ${values.from} and ${values.worlds}.`);
}

let failed = 0;
for (let seed = from; seed < from + worlds; seed++) {
  const plan = randomPlan(seed);
  const violation = judge(plan);
  if (violation) {
    failed++;
    console.log(`world ${seed}: ${violation.kind} in step ${violation.step}: ${violation.detail}`);
    if (!values.brief) {
      const least = shrink(plan, violation);
      console.log(`  least: ${judge(least)?.detail}\n  ${JSON.stringify(least)}`);
    }
  }
  if ((seed + 1 - from) % 10_000 === 0) console.log(`${seed + 1 - from} worlds, ${failed} failed`);
}
console.log(`${worlds} worlds from ${from}: ${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;
