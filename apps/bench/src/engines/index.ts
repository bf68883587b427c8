import type { Engine } from '../engine.ts';
import { box2d } from './box2d-wasm.ts';
import { box2d3, box2d3Compat } from './box2d3-wasm.ts';
import { mass } from './mass.ts';
import { matter } from './matter-js.ts';
import { nape } from './nape-js.ts';
import { objects } from './objects.ts';
import { p2 } from './p2-es.ts';
import { party } from './party.ts';
import { phaserBox2d } from './phaser-box2d.ts';
import { planck } from './planck.ts';
import { rapier, rapierSimd } from './rapier2d.ts';
import { verlet } from './verlet.ts';

/** All engines, Mass first. A new one is a file and a line here. */
export const engines: readonly Engine[] = [
  mass,
  ...[box2d3, box2d3Compat, rapier, rapierSimd, box2d],
  ...[planck, p2, phaserBox2d, matter, nape, party],
  ...[verlet, objects],
];

/** Those that `--quick` takes, unless others are asked for. */
export const quickEngines = 'mass,box2d3-wasm,planck,verlet,objects';
