import * as canvas2d from '@mass/canvas2d';
import { World } from '@mass/core';
import * as view from '@mass/core/view';

/** What the packages export, by name. */
export const names: string[] = [...Object.keys(canvas2d), ...Object.keys(view), World.name];
