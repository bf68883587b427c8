import type { FixedTimestep, World } from '@mass/core';
import type { Camera } from '@mass/core/view';
import type { Scene, Setup, Values } from '../scenes/scene.ts';
import type { RendererKind } from '../stage/renderers.ts';
import type { Stage } from '../stage/stage.ts';

/** What a scene's page offers on `window.mass`: to the curious in the console, and to the browser tests. */
export interface MassOnPage {
  readonly scene: Scene;
  /** The stage: `mass.stage.pause()`, `mass.stage.speed = 0.1`. */
  readonly stage: Stage;
  /** What runs now. A reset makes a new one. */
  readonly setup: Setup;
  readonly world: World;
  readonly camera: Camera;
  readonly clock: FixedTimestep;
  readonly renderer: RendererKind;
  readonly values: Values;
  readonly seed: number;
  /** Frames drawn while the scene played. */
  readonly frames: number;
}

declare global {
  interface Window {
    /** On a scene's page. */
    mass?: MassOnPage;
    /** On the list of scenes: the stages that were started, by their elements. */
    stages?: ReadonlyMap<HTMLElement, Stage>;
  }
}

/** Puts `window.mass` in place. */
export function exposeStage(stage: Stage): void {
  window.mass = {
    scene: stage.scene,
    stage,
    get setup() {
      return stage.setup;
    },
    get world() {
      return stage.setup.world;
    },
    get camera() {
      return stage.panes[0].camera;
    },
    clock: stage.clock,
    get renderer() {
      return stage.renderer;
    },
    get values() {
      return stage.values;
    },
    get seed() {
      return stage.seed;
    },
    get frames() {
      return stage.statistics.frames;
    },
  };
}
