import type { Workload } from '../workload.ts';
import { asleep } from './asleep.ts';
import { cloth } from './cloth.ts';
import { crates } from './crates.ts';
import { energy } from './energy.ts';
import { flight } from './flight.ts';
import { garbage } from './garbage.ts';
import { growth } from './growth.ts';
import { load } from './load.ts';
import { pendulum } from './pendulum.ts';
import { pile } from './pile.ts';
import { programs } from './programs.ts';
import { readout } from './readout.ts';
import { rope } from './rope.ts';
import { stack } from './stack.ts';
import { tower } from './tower.ts';
import { tunnel } from './tunnel.ts';

/** All workloads, in the order of the report. A new one is a file and a line here. */
export const workloads = [
  ...[pile, asleep, stack, rope, cloth, flight, crates, readout, growth, garbage, programs],
  ...[load, energy, pendulum, tunnel, tower],
] as readonly Workload[];
