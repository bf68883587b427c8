import type { Scene } from './scene.ts';

/** Each scene by its id, in the order of the thesis. It is loaded when it is asked for: a page carries the code of its own. */
const loaders: { readonly [id: string]: () => Promise<Scene> } = {
  projectiles: async () => (await import('./projectiles.ts')).projectiles,
  fireworks: async () => (await import('./fireworks.ts')).fireworks,
  'force-generators': async () => (await import('./force-generators.ts')).forceGenerators,
  'springs-period': async () => (await import('./springs-period.ts')).springsPeriod,
  'springs-amplitude': async () => (await import('./springs-amplitude.ts')).springsAmplitude,
  'buoyancy-explained': async () => (await import('./buoyancy-explained.ts')).buoyancyExplained,
  'buoyancy-volumes': async () => (await import('./buoyancy-volumes.ts')).buoyancyVolumes,
  'buoyancy-masses': async () => (await import('./buoyancy-masses.ts')).buoyancyMasses,
  'buoyancy-liquids': async () => (await import('./buoyancy-liquids.ts')).buoyancyLiquids,
  'buoyancy-waves': async () => (await import('./buoyancy-waves.ts')).buoyancyWaves,
  'contact-normal': async () => (await import('./contact-normal.ts')).contactNormal,
  interpenetration: async () => (await import('./interpenetration.ts')).interpenetration,
  'sunk-box': async () => (await import('./sunk-box.ts')).sunkBox,
  'resting-contact': async () => (await import('./resting-contact.ts')).restingContact,
  'contact-order': async () => (await import('./contact-order.ts')).contactOrder,
  restitution: async () => (await import('./restitution.ts')).restitution,
  masses: async () => (await import('./masses.ts')).masses,
  'glancing-masses': async () => (await import('./glancing-masses.ts')).glancingMasses,
  'cables-hanging': async () => (await import('./cables-hanging.ts')).cablesHanging,
  'cables-linked': async () => (await import('./cables-linked.ts')).cablesLinked,
  rods: async () => (await import('./rods.ts')).rods,
  pendulum: async () => (await import('./pendulum.ts')).pendulum,
  'rods-and-cables': async () => (await import('./rods-and-cables.ts')).rodsAndCables,
  'aggregates-squares': async () => (await import('./aggregates-squares.ts')).aggregatesSquares,
  'aggregates-triangles': async () => (await import('./aggregates-triangles.ts')).aggregatesTriangles,
  game: async () => (await import('./game.ts')).game,
  'newtons-cradle': async () => (await import('./newtons-cradle.ts')).newtonsCradle,
  billiards: async () => (await import('./billiards.ts')).billiards,
  'rope-bridge': async () => (await import('./rope-bridge.ts')).ropeBridge,
  'wrecking-ball': async () => (await import('./wrecking-ball.ts')).wreckingBall,
  cloth: async () => (await import('./cloth.ts')).cloth,
  pile: async () => (await import('./pile.ts')).pile,
  'box-stack': async () => (await import('./box-stack.ts')).boxStack,
  'marble-run': async () => (await import('./marble-run.ts')).marbleRun,
  hourglass: async () => (await import('./hourglass.ts')).hourglass,
};

/** The id of every scene, in the order of the thesis. */
export const sceneIds: readonly string[] = Object.keys(loaders);

/** Loads the scene of an id; an error says which there are. */
export async function loadScene(id = ''): Promise<Scene> {
  if (!Object.hasOwn(loaders, id)) throw new Error(`loadScene: id must be one of ${sceneIds.join(', ')}; got ${id}.`);
  return loaders[id]();
}
