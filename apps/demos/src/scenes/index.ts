import { loadScene, sceneIds } from './load-scene.ts';
import type { Scene } from './scene.ts';

/** Every scene, in the order of the thesis. */
export const scenes: readonly Scene[] = await Promise.all(sceneIds.map(loadScene));
