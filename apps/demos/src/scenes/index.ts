import { aggregatesSquares } from './aggregates-squares.ts';
import { aggregatesTriangles } from './aggregates-triangles.ts';
import { billiards } from './billiards.ts';
import { buoyancyExplained } from './buoyancy-explained.ts';
import { buoyancyLiquids } from './buoyancy-liquids.ts';
import { buoyancyMasses } from './buoyancy-masses.ts';
import { buoyancyVolumes } from './buoyancy-volumes.ts';
import { buoyancyWaves } from './buoyancy-waves.ts';
import { cablesHanging } from './cables-hanging.ts';
import { cablesLinked } from './cables-linked.ts';
import { contactNormal } from './contact-normal.ts';
import { contactOrder } from './contact-order.ts';
import { fireworks } from './fireworks.ts';
import { forceGenerators } from './force-generators.ts';
import { game } from './game.ts';
import { glancingMasses } from './glancing-masses.ts';
import { interpenetration } from './interpenetration.ts';
import { masses } from './masses.ts';
import { newtonsCradle } from './newtons-cradle.ts';
import { pendulum } from './pendulum.ts';
import { projectiles } from './projectiles.ts';
import { restingContact } from './resting-contact.ts';
import { restitution } from './restitution.ts';
import { rods } from './rods.ts';
import { rodsAndCables } from './rods-and-cables.ts';
import type { Scene } from './scene.ts';
import { springsAmplitude } from './springs-amplitude.ts';
import { springsPeriod } from './springs-period.ts';
import { sunkBox } from './sunk-box.ts';

/** Every scene, in the order of the thesis. */
export const scenes: readonly Scene[] = [
  projectiles,
  fireworks,
  forceGenerators,
  springsPeriod,
  springsAmplitude,
  buoyancyExplained,
  buoyancyVolumes,
  buoyancyMasses,
  buoyancyLiquids,
  buoyancyWaves,
  contactNormal,
  interpenetration,
  sunkBox,
  restingContact,
  contactOrder,
  restitution,
  masses,
  glancingMasses,
  cablesHanging,
  cablesLinked,
  rods,
  pendulum,
  rodsAndCables,
  aggregatesSquares,
  aggregatesTriangles,
  game,
  newtonsCradle,
  billiards,
];

/** The scene of an id; an error says which there are. */
export function sceneOf(id: string | undefined): Scene {
  const scene = scenes.find((candidate) => candidate.id === id);
  if (!scene) throw new Error(`sceneOf: id must be one of ${scenes.map((each) => each.id).join(', ')}; got ${id}.`);
  return scene;
}
