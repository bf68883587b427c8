import type { World } from '../world/world.ts';

/** What a renderer reads of a world; it writes nothing. */
export type ViewedWorld = Pick<
  World,
  | 'particles'
  | 'time'
  | 'stepCount'
  | 'gravity'
  | 'particleAt'
  | 'generationAt'
  | 'links'
  | 'forces'
  | 'shapes'
  | 'bodies'
  | 'contacts'
>;
