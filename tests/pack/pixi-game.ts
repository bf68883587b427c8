import { World } from '@mass/core';
import * as pixi from '@mass/pixi';
import { Container } from 'pixi.js';

/** What the packages export, by name. */
export const names: string[] = [...Object.keys(pixi), World.name, Container.name];
