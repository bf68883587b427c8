import type { Engine } from '../engine.ts';
import { box2d3, box2d3Compat } from './box2d3-wasm.ts';
import { mass } from './mass.ts';

/** All engines, Mass first. A new one is a file and a line here. */
export const engines: readonly Engine[] = [mass, box2d3, box2d3Compat];
