import type { Run, Scene, Setup, Values } from './scene.ts';

/** The step of a scene that names none. Unit: s. */
export const DEFAULT_STEP: number = 1 / 60;

/** The seed of a scene when the address names none. */
export const DEFAULT_SEED = 1;

/** The values of a scene's parameters, as they are until somebody changes them. */
export function defaultValues<Name extends string>(scene: Scene<Name>): Values<Name> {
  const entries = Object.entries<Scene['parameters'][string]>(scene.parameters).map(([name, { value }]) => [
    name,
    value,
  ]);
  return Object.fromEntries(entries) as Values<Name>;
}

/** One step of a scene: what the scene does before it, then each of its worlds. */
export function stepSetup(setup: Setup, dt: number): void {
  setup.beforeStep?.(dt);
  setup.world.step(dt);
  for (const { world } of setup.beside ?? []) world.step(dt);
}

/** Runs a scene without a picture: for its check, for the tests, for benchmarks. */
export function runner<Name extends string>(scene: Scene<Name>): Run<Name> {
  return (values = {}, seed = DEFAULT_SEED) => {
    const setup = scene.build({ ...defaultValues(scene), ...values }, seed);
    const step = scene.step ?? DEFAULT_STEP;
    return {
      setup,
      press(key: string): void {
        const action = setup.actions?.find((candidate) => candidate.key === key);
        if (!action) throw new Error(`${scene.id}: press must name the key of an action; got ${JSON.stringify(key)}.`);
        action.run();
      },
      run(seconds: number, look?: () => void): void {
        for (let n = Math.round(seconds / step); n > 0; n--) {
          stepSetup(setup, step);
          look?.();
        }
      },
    };
  };
}
