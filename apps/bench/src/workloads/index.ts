import type { Workload } from '../workload.ts';
import { pile } from './pile.ts';
import { rope } from './rope.ts';
import { stack } from './stack.ts';

/** All workloads, in the order of the report. A new one is a file and a line here. */
export const workloads: readonly Workload[] = [pile, stack, rope];
